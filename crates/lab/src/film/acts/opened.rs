//! First step: the film, its times, and the used part.

use super::notes;
use super::tool::fold;
use crate::app::App;
use crate::film::now::now;
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
            browser::focus("choose-record");
        })
        .child(words.close);
    View::from((
        p().child(text(extent)),
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
    let refused = create_signal(None);
    let take = move |event| {
        let typed = value_of(&event);
        refused.set(app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.set_factor(play, &typed))));
    };
    let field =
        number_field("film-factor", refused).attr("placeholder", "1").prop("value", now).when(events::change, take);
    let field = field_of("film-factor", words.factor).child(field);
    View::from((field, why_refused("film-factor", refused), note(words.factor_note)))
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
        let refused = create_signal(None);
        let take = move |event| {
            let typed = value_of(&event);
            refused.set(app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.set_end(play, end, &typed))));
        };
        let here_now = move |_| {
            let player = app.with(|lab| lab.player.clone()).flatten();
            let times = player.map(|player| player.source.film.times()).unwrap_or_default();
            let mut part = now(app).map(|now| now.part).unwrap_or_default();
            if let Some(place) = part.get_mut(end) {
                *place = times.get(app.films.frame.get_untracked()).copied();
            }
            refused.set(app.attempt_on_desk(|desk| desk.work_on_film(|films, play| films.set_part(play, part))));
        };
        let whole = memo(move || {
            let style = app.language.get_untracked().style();
            let ends = app.films.now.with(|now| now.as_ref().map(|now| now.whole)).unwrap_or_default();
            units::number::fixed(ends.get(end).copied().unwrap_or_default(), 3, style)
        });
        let field = number_field(id, refused)
            .attr("placeholder", move || whole.get_clone())
            .prop("value", shown)
            .when(events::change, take);
        let line = div()
            .class("step-line")
            .child(field_of(id, name).child(with_unit(field, "s")))
            .child(button().class("quiet").when(events::click, here_now).child(here));
        View::from((line, why_refused(id, refused)))
    };
    View::from((end(0, "film-from", words.from, words.from_here), end(1, "film-until", words.until, words.until_here)))
}
