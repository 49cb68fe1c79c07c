//! Fourth step: record, doubts and fit.

use super::{notes, truth};
use crate::app::App;
use crate::film::now::now;
use crate::film::{doubts, words};
use view::browser;
use view::views::*;

/// Progress of the tracking, then its result.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let busy = memo(move || app.films.progress.with(Option::is_some));
    let found = memo(move || app.films.now.with(|now| now.as_ref().is_some_and(|now| now.record.is_some())));
    View::from((
        changing(move || if busy.get() { progress(app) } else { View::new() }),
        changing(move || {
            if found.get() {
                return result(app);
            }
            if busy.get() { View::new() } else { note(words.no_record).into() }
        }),
    ))
}

fn progress(app: App) -> View {
    let words = words::of(app);
    let part = move || {
        app.films.progress.with(|now| match now {
            Some(now) if !now.computing => (100 * now.taken).checked_div(now.of).map(|part| part.to_string()),
            _ => None,
        })
    };
    let said = move || {
        app.films.progress.with(|now| match now {
            Some(now) if now.computing => words.computing.to_owned(),
            Some(now) => format!("{} {} / {}", words.frame, now.taken, now.of),
            None => String::new(),
        })
    };
    let cancel = move |_| {
        app.act_on_desk(|desk| desk.change_films(|films, _| films.cancel_tracking()));
        browser::focus("film-frame");
    };
    div()
        .class("intake")
        .child(tags::progress().attr("aria-label", words.following).max("100").value(part))
        .child(span().class("note").child(text(said)))
        .child(button().class("quiet").id("cancel-tracking").when(events::click, cancel).child(words.cancel))
        .into()
}

fn result(app: App) -> View {
    let words = words::of(app);
    let show = move |_| {
        if let Some(record) = now(app).and_then(|now| now.record) {
            browser::reveal_later(format!("record-{record}"));
        }
    };
    View::from((
        notes::view(app),
        doubts::list(app),
        truth::view(app),
        div()
            .class("intake")
            .child(button().class("quiet").id("film-record").when(events::click, show).child(words.show_record)),
    ))
}
