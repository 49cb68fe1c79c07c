//! First step: the film, its times, and the used part.

use super::notes;
use super::tool::fold;
use crate::app::App;
use crate::film::now::now;
use crate::film::refusals::refuse;
use crate::film::{opening, words};
use view::browser;
use view::views::*;

/// Description of the film, and the settings of its times.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let extent = move || {
        let style = app.language.get_untracked().style();
        let (frames, seconds, [width, height]) =
            app.films.now.with(|now| now.as_ref().map(|now| now.extent)).unwrap_or_default();
        let seconds = units::number::fixed(seconds, 2, style);
        format!("{frames} {}, {seconds} s, {width:.0} × {height:.0} px", words.frames)
    };
    let recorded = memo(move || app.films.now.with(|now| now.as_ref().is_some_and(|now| now.record.is_some())));
    let close = button()
        .class("quiet")
        .id("close-film")
        .when(events::click, move |_| {
            opening::close(app);
            browser::focus("open-film");
        })
        .child(words.close);
    let name = move || app.films.now.with(|now| now.as_ref().map(|now| now.name.clone()).unwrap_or_default());
    View::from((
        p().child(strong().class("film-name").id("film-name").child(text(name))).child(" ").child(text(extent)),
        changing(move || if recorded.get() { View::new() } else { notes::view(app) }),
        fold(words.times).id("film-times").child(factor(app)).child(part(app)),
        div().class("actions").child(close),
    ))
}

fn factor(app: App) -> View {
    let words = words::of(app);
    let now = memo(move || {
        app.films
            .now
            .with(|now| now.as_ref().and_then(|now| now.factor))
            .map(|factor| units::number::plain(factor, 6, app.language.get_untracked().style()))
            .unwrap_or_default()
    });
    let take = move |event| {
        let typed = value_of(&event);
        refuse(app, app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.set_factor(play, &typed))));
    };
    let field =
        short_field("film-factor".to_owned()).attr("placeholder", "1").prop("value", now).when(events::change, take);
    View::from((field_of("film-factor", words.factor).child(field), note(words.factor_note)))
}

/// Used part of the film.
fn part(app: App) -> View {
    let words = words::of(app);
    let end = move |end: usize, id: &'static str, name: &'static str, here: &'static str| {
        let shown = memo(move || {
            let style = app.language.get_untracked().style();
            let seconds = app.films.now.with(|now| now.as_ref().and_then(|now| now.part.get(end).copied().flatten()));
            seconds.map(|seconds| units::number::fixed(seconds, 3, style)).unwrap_or_default()
        });
        let set = move |seconds: Option<f64>| {
            let mut part = now(app).map(|now| now.part).unwrap_or_default();
            if let Some(place) = part.get_mut(end) {
                *place = seconds;
            }
            let refusal = app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.set_part(play, part)));
            refuse(app, refusal);
        };
        let take = move |event| set(value_of(&event).trim().replace(',', ".").parse().ok());
        let here_now = move |_| {
            let player = app.with(|lab| lab.player.clone()).flatten();
            let times = player.map(|player| player.source.film.times()).unwrap_or_default();
            set(times.get(app.films.frame.get_untracked()).copied());
        };
        let whole = memo(move || {
            let style = app.language.get_untracked().style();
            let ends = app.films.now.with(|now| now.as_ref().map(|now| now.whole)).unwrap_or_default();
            units::number::fixed(ends.get(end).copied().unwrap_or_default(), 3, style)
        });
        let field = short_field(id.to_owned())
            .attr("placeholder", move || whole.get_clone())
            .prop("value", shown)
            .when(events::change, take);
        div()
            .class("step-line")
            .child(field_of(id, name).child(with_unit(field, "s")))
            .child(button().class("quiet").when(events::click, here_now).child(here))
    };
    View::from((end(0, "film-from", words.from, words.from_here), end(1, "film-until", words.until, words.until_here)))
}
