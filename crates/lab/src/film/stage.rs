//! Film on the stage instead of the scene, and its frames instead of the transport.

use super::frames::{go, play, step};
use super::keys::key;
use super::{doubts, frame, sample, space_time, words};
use crate::app::App;
use view::pieces::icons;
use view::views::*;

/// Picture of the film; empty while no film is open.
pub fn picture(app: App) -> View {
    let state = memo(move || (app.films.open.get(), app.films.shown.get()));
    changing(move || {
        let (open, shown) = state.get();
        if !open {
            return View::new();
        }
        let words = words::of(app);
        if !shown {
            let show = move |_| app.films.shown.set(true);
            return button().class("chip film-back").id("show-film").when(events::click, show).child(words.film).into();
        }
        let player = app.with(|lab| lab.player.clone()).flatten();
        let [width, height] = player.map_or([16.0, 9.0], |player| player.size());
        let strips = div().class("film-strips").child(space_time::view(app));
        let keys = p().id("space-time-keys").hidden(true).child(words.space_time_keys);
        section()
            .class("scene film card")
            .id("film")
            .style(format!("--aspect:{}", width / height))
            .attr("aria-label", words.film)
            .child(frame::view(app))
            .child(strips)
            .child(keys)
            .into()
    })
}

/// Bar with the frames; empty while the film is not shown.
pub fn transport(app: App) -> View {
    let told = memo(move || app.films.story.get());
    changing(move || match told.get() {
        Some(_) => sample::bar(app),
        None if app.films.open.get() && app.films.shown.get() => bar(app).into(),
        None => View::new(),
    })
}

fn bar(app: App) -> HtmlSection {
    let words = words::of(app);
    let times = app.with(|lab| lab.player.as_ref().map(|player| player.source.film.times())).flatten();
    let times = times.unwrap_or_default();
    let count = times.len();
    let number = move || app.films.frame.get() + 1;
    let clock = move || {
        let seconds = times.get(app.films.frame.get()).copied().unwrap_or(0.0);
        let style = app.language.get_untracked().style();
        format!("{} s", units::number::fixed(seconds, 3, style))
    };
    let clock = output().class("clock").id("film-clock").attr("aria-live", "off").child(text(clock));
    let line = input()
        .r#type("range")
        .class("line")
        .id("film-line")
        .min("0")
        .max(count.saturating_sub(1).to_string())
        .step("1")
        .attr("aria-label", words.film_time)
        .attr("aria-valuetext", move || format!("{} {} / {count}", words.frame, number()))
        .prop("value", move || app.films.frame.get().to_string())
        .when(events::input, move |event| go(app, value_of(&event).parse().unwrap_or(0)))
        .when(events::keydown, move |event| key(app, &event));
    let behind = move || {
        let part = app.films.frame.get() as f64 / count.saturating_sub(1).max(1) as f64;
        format!("transform:scaleX({part:.4})")
    };
    let step_button = |id: &'static str, name: &'static str, by: isize, icon: SvgSvg| {
        button().class("icon").id(id).called(name).when(events::click, move |_| step(app, by)).child(icon)
    };
    let playing = move || app.films.playing.get();
    let name = move || if playing() { words.pause } else { words.play };
    let toggle = button()
        .class("play")
        .id("film-play")
        .title(name)
        .attr("aria-label", name)
        .when(events::click, move |_| play(app))
        .child(changing(move || if playing() { icons::pause() } else { icons::play() }));
    let buttons = div()
        .class("buttons")
        .child(step_button("film-previous", words.previous, -1, icons::step_back()))
        .child(toggle)
        .child(step_button("film-next", words.next, 1, icons::step_forward()));
    let place = div().class("line-place").child(span().class("behind").style(behind)).child(line);
    let counter = span().class("film-count").id("film-number").child(text(move || format!("{} / {count}", number())));
    let scene = move |_| app.films.shown.set(false);
    let extras = div().class("extras").child(doubts::button(app)).child(
        button().class("quiet").id("show-scene").title(words.show_scene).when(events::click, scene).child(words.scene),
    );
    section()
        .class("transport film-transport")
        .id("film-transport")
        .attr("aria-label", words.film_transport)
        .child(buttons)
        .child(div().class("time").child(clock).child(place).child(counter))
        .child(extras)
}
