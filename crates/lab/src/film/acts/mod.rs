//! The four steps in the panel: film, subject, lengths, record.

mod follow;
mod lengths;
mod notes;
mod opened;
mod radius;
mod record;
mod tool;
mod truth;

use super::words;
use crate::app::App;
use crate::film::state::Now;
use desk::Subject;
use film::tracking::lost_from;
use view::views::*;
use web_sys::HtmlDetailsElement;

/// What to do where the browser opens no films.
pub fn warning(app: App) -> View {
    let warning = (!window().is_secure_context()).then(|| note(words::of(app).insecure).id("films-need-https"));
    warning.map_or_else(View::new, View::from)
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
        ol().class("acts")
            .id("film-acts")
            .attr("aria-label", words.acts)
            .child(act(app, 0, "film-act-film", words.act_film, opened::view(app)))
            .child(act(app, 1, "film-act-follow", words.act_follow, follow::view(app)))
            .child(act(app, 2, "film-act-lengths", words.act_lengths, lengths::view(app)))
            .child(act(app, 3, "film-act-record", words.act_record, record::view(app)))
            .into()
    };
    View::from((changing(opening), changing(acts)))
}

/// A step: its number, or a tick once it is done, its title and what has been set in it. Its content is unfolded while it is the
/// step to be done or goes on, or as the user folds it.
fn act(app: App, place: usize, id: &'static str, title: &'static str, content: View) -> HtmlLi {
    let state = memo(move || {
        let done = done(app);
        (done.get(place).copied().unwrap_or_default(), done.iter().position(|done| !done) == Some(place))
    });
    let class = move || match state.get() {
        (true, _) => "card step act done",
        (_, true) => "card step act now",
        _ => "card step act",
    };
    let sign = move || if state.get().0 { "✓".to_owned() } else { (place + 1).to_string() };
    let number = span().class("number-of-step").attr("aria-hidden", "true").child(text(sign));
    let heading = format!("{id}-title");
    let folded = create_signal(None);
    let goes_on = memo(move || app.films.now.with(|now| now.as_ref().is_some_and(|now| goes_on(now, place))));
    let open = memo(move || folded.get().unwrap_or_else(|| state.get().1 || goes_on.get()));
    let mut fold = details();
    let node: HtmlDetailsElement = fold.node();
    let turned = move |_| {
        if node.open() != open.get_untracked() {
            folded.set(Some(node.open()));
        }
    };
    let title = h3().id(heading).child(number).child(title);
    li().class(class).id(id).child(
        fold.open(move || open.get())
            .when(events::toggle, turned)
            .child(summary().child(title).child(fact(app, place)))
            .child(content),
    )
}

/// True if there is more to do in a step that is done: another body, the size of a body; what the record leads to.
fn goes_on(now: &Now, place: usize) -> bool {
    match place {
        1 => matches!(now.subject, Subject::Bodies(_)),
        3 => now.record.is_some(),
        _ => false,
    }
}

/// What has been set in a step, beside its title: the name of the film, the scale.
fn fact(app: App, place: usize) -> View {
    let style = app.language.get_untracked().style();
    let fact = |read: Box<dyn Fn(&Now) -> String>| {
        let read = move || app.films.now.with(|now| now.as_ref().map(|now| read(now)).unwrap_or_default());
        span().class("note").child(text(read))
    };
    match place {
        0 => fact(Box::new(|now| now.name.clone())).id("film-name").into(),
        2 => fact(Box::new(move |now| now.scale(style))).id("film-scale").role("status").into(),
        _ => View::new(),
    }
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
