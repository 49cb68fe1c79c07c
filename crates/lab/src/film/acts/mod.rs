//! The four steps in the panel: film, subject, lengths, record.

mod follow;
mod lengths;
mod notes;
mod opened;
mod radius;
mod record;
mod tool;
mod truth;

use super::{camera, filming, opening, sample, words};
use crate::app::App;
use film::tracking::lost_from;
use view::pieces::icons;
use view::views::*;
use web_sys::HtmlInputElement;

/// Buttons that open or record a film, beside the one for tables.
pub fn way_in(app: App) -> View {
    let words = words::of(app);
    let mut input = input().r#type("file").accept("video/*,.mkv,.avi");
    let node: HtmlInputElement = input.node();
    let chosen = node.clone();
    let take = move |_| {
        if let Some(file) = chosen.files().and_then(|files| files.get(0)) {
            opening::open(app, file);
        }
        chosen.set_value("");
    };
    let open = view::views::button()
        .class("quiet with-icon")
        .id("open-film")
        .when(events::click, move |_| node.click())
        .child(icons::film())
        .child(span().child(words.open));
    let input = input.id("film-file").hidden(true).attr("aria-label", words.open).when(events::change, take);
    let warning = (!window().is_secure_context()).then(|| note(words.insecure).id("films-need-https"));
    let warning = warning.map_or_else(View::new, View::from);
    let sample = view::views::button()
        .class("quiet with-icon")
        .id("open-sample")
        .when(events::click, move |_| sample::open(app))
        .child(icons::film())
        .child(span().child(words.sample_film));
    View::from((open, input, sample, camera::button(app), filming::button(app), warning))
}

/// The four steps; empty while no film is open.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let opening = move || match app.films.opening.get_clone() {
        Some(name) => p().class("note").role("status").child(format!("{} {name} …", words.opening)).into(),
        None => View::new(),
    };
    let acts = move || {
        if !app.films.open.get() {
            return View::new();
        }
        let done = |number: usize| {
            move || {
                let done = done(app);
                (done.get(number).copied().unwrap_or_default(), done.iter().position(|done| !done) == Some(number))
            }
        };
        ol().class("acts")
            .id("film-acts")
            .attr("aria-label", words.acts)
            .child(act("1", "film-act-film", words.act_film, done(0), opened::view(app)))
            .child(act("2", "film-act-follow", words.act_follow, done(1), follow::view(app)))
            .child(act("3", "film-act-lengths", words.act_lengths, done(2), lengths::view(app)))
            .child(act("4", "film-act-record", words.act_record, done(3), record::view(app)))
            .into()
    };
    View::from((changing(opening), changing(acts)))
}

/// Step with its number, or a tick once it is done.
fn act(
    number: &'static str,
    id: &'static str,
    title: &'static str,
    state: impl Fn() -> (bool, bool) + 'static,
    content: View,
) -> HtmlLi {
    let state = memo(state);
    let class = move || match state.get() {
        (true, _) => "card step act done",
        (_, true) => "card step act now",
        _ => "card step act",
    };
    let sign = move || if state.get().0 { "✓".to_owned() } else { number.to_owned() };
    let number = span().class("number-of-step").attr("aria-hidden", "true").child(text(sign));
    let heading = format!("{id}-title");
    li().class(class).id(id).child(h3().id(heading).child(number).child(title)).child(content)
}

/// Completed steps.
fn done(app: App) -> [bool; 4] {
    let now = app.films.now.get_clone();
    let Some(now) = now else { return [false; 4] };
    let record = now.record.is_some() && !now.plainly_in_doubt;
    [
        true,
        !now.subject.is_nothing() && lost_from(&now.doubts).is_none(),
        now.form.lacking(&now.subject).is_none(),
        record,
    ]
}
