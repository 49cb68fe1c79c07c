//! The film on the stage, in the place of the scene, and its frames in the place of the transport.

use super::{doubts, go, step};
use crate::app::App;
use view::icons;
use view::views::*;
use web_sys::KeyboardEvent;

/// The picture; nothing while no film is open.
pub fn picture(app: App) -> View {
    changing(move || {
        if !app.films.open.get() {
            return View::new();
        }
        let words = app.films.words(app);
        if !app.films.shown.get() {
            let show = move |_| app.films.shown.set(true);
            return button().class("chip film-back").id("show-film").when(events::click, show).child(words.film).into();
        }
        section().class("scene film card").id("film").attr("aria-label", words.film).child(place(app)).into()
    })
}

/// The frame that is shown.
fn place(app: App) -> View {
    let words = app.films.words(app);
    let Some(player) = app.with(|lab| lab.player.clone()).flatten() else { return View::new() };
    let [width, height] = [player.canvas.width(), player.canvas.height()].map(f64::from);
    let mut frame = div();
    let _ = frame.node::<web_sys::Element>().append_child(&player.canvas);
    let frame = frame
        .class("film-frame")
        .id("film-frame")
        .style(format!("--aspect:{}", width / height))
        .tabindex("0")
        .role("application")
        .attr("aria-label", words.film)
        .attr("aria-roledescription", words.film)
        .attr("aria-describedby", "film-keys")
        .when(events::keydown, move |event| key(app, &event));
    View::from((div().class("film-place").child(frame), p().id("film-keys").hidden(true).child(words.picture_keys)))
}

/// The bar with the frames; nothing while the film is not shown.
pub fn transport(app: App) -> View {
    changing(move || if app.films.open.get() && app.films.shown.get() { bar(app).into() } else { View::new() })
}

fn bar(app: App) -> HtmlSection {
    let words = app.films.words(app);
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
    let buttons = div()
        .class("buttons")
        .child(step_button("film-previous", words.previous, -1, icons::step_back()))
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

/// Keys that go through the film.
pub fn key(app: App, event: &KeyboardEvent) {
    if event.ctrl_key() || event.alt_key() || event.meta_key() || event.default_prevented() {
        return;
    }
    let far = if event.shift_key() { 10 } else { 1 };
    match event.key().as_str() {
        "ArrowLeft" | "ArrowDown" => step(app, -far),
        "ArrowRight" | "ArrowUp" => step(app, far),
        "Home" => go(app, 0),
        "End" => go(app, usize::MAX),
        "." => doubts::next(app),
        _ => return,
    }
    event.prevent_default();
}
