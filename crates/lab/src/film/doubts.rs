//! Frames that the user should check.

use super::frames::go;
use super::now::now;
use super::words;
use crate::app::App;
use desk::Subject;
use film::tracking::{Doubt, DoubtfulFrame};
use view::pieces::icons;
use view::views::*;

/// Maximum number of listed frames.
const NAMED: usize = 3;

fn count(app: App) -> usize {
    app.films.now.with(|now| now.as_ref().map_or(0, |now| now.doubts.len()))
}

/// Button that goes to the next doubtful frame.
pub fn button(app: App) -> View {
    let words = words::of(app);
    let count = memo(move || count(app));
    changing(move || {
        if count.get() == 0 {
            return View::new();
        }
        view::views::button()
            .class("quiet with-icon")
            .id("film-next-doubt")
            .title(format!("{} (.)", words.next_doubtful))
            .attr("aria-label", format!("{} ({})", words.next_doubtful, count.get()))
            .when(events::click, move |_| next(app))
            .child(icons::doubt())
            .child(span().child(count.get().to_string()))
            .into()
    })
}

/// Goes to the next doubtful frame, from the last to the first.
pub fn next(app: App) {
    let Some(now) = now(app) else { return };
    let frame = app.films.frame.get_untracked();
    let next = now.doubts.iter().find(|doubt| doubt.frame > frame).or_else(|| now.doubts.first());
    let Some(doubt) = next else { return };
    go(app, doubt.frame);
    let words = words::of(app);
    let why = doubt.doubt.words().text(app.language.get_untracked()).into_owned();
    app.say(format!("{} {}: {why}", words.frame, doubt.frame + 1));
}

/// Lost tracks, the number of doubts, and the first of them.
pub fn list(app: App) -> View {
    let words = words::of(app);
    changing(move || {
        let now = app.films.now;
        let doubts = now.with(|now| now.as_ref().map(|now| now.doubts.clone()).unwrap_or_default());
        if doubts.is_empty() {
            return View::new();
        }
        let is_surface = now.with(|now| now.as_ref().is_some_and(|now| matches!(now.subject, Subject::Surfaces(_))));
        let language = app.language.get_untracked();
        // A lost track affects all that follows, and is always listed.
        let (lost, others): (Vec<DoubtfulFrame>, Vec<_>) =
            doubts.iter().partition(|doubt| matches!(doubt.doubt, Doubt::Lost(_)));
        let named = lost.iter().chain(others.iter().take(NAMED)).map(|doubt| {
            let frame = doubt.frame;
            let name = format!("{} {}: {}", words.frame, frame + 1, doubt.doubt.words().text(language));
            li().child(view::views::button().class("pick").when(events::click, move |_| go(app, frame)).child(name))
        });
        let named: Vec<HtmlLi> = named.collect();
        let head = format!("{}: {}", words.doubtful, doubts.len());
        div()
            .class("film-doubts")
            .child(p().child(head))
            .child(ul().each(named, |one| one))
            .child(note(if is_surface { words.doubts_note } else { words.doubts_note_bodies }))
            .into()
    })
}
