//! What the author claims about the simulation, and whether it holds: a quiet list below the theory, run on demand.

use crate::app::App;
use crate::question::supposed;
use crate::views::*;
use play::{ClaimView, ClaimsView};

/// The list; nothing where the author claims nothing.
pub fn view(app: App) -> View {
    if !app.read(|play| play.has_checks()) {
        return View::new();
    }
    let words = app.words();
    let listed = move || {
        app.changes.checks.track();
        each(app.read(|play| play.checks()), move |claims| group(app, claims))
    };
    let state = move || {
        app.changes.checks.track();
        summary_of(app)
    };
    let run = button().class("quiet").id("run-checks").when(events::click, move |_| app.act(play::Play::begin_checks));
    details()
        .class("card fold checks")
        .id("checks")
        .child(summary().child(h3().child(words.checks)))
        .child(note(words.checks_intro))
        .child(
            p().class("setup")
                .child(run.child(words.run_checks))
                .child(" ")
                .child(span().role("status").child(text(state))),
        )
        .child(div().child(changing(listed)))
        .into()
}

/// How many claims hold.
fn summary_of(app: App) -> String {
    let words = app.words();
    let claims = app.read(|play| play.checks().into_iter().flat_map(|claims| claims.claims).collect::<Vec<_>>());
    let count = |holds: Option<bool>| claims.iter().filter(|claim| claim.holds == holds).count();
    if app.read(|play| play.is_checking()) {
        return words.checks_running.to_owned();
    }
    match (count(None), count(Some(false))) {
        (0, 0) => format!("{} ({})", words.checks_hold, claims.len()),
        (0, failed) => format!("{} {failed}/{}", words.checks_fail, claims.len()),
        _ => String::new(),
    }
}

fn group(app: App, claims: ClaimsView) -> View {
    let words = app.words();
    let head = (!claims.setup.is_empty())
        .then(|| p().class("setup").child(words.checks_with).child(" ").child(supposed(claims.setup)));
    div().maybe(head).child(ul().each(claims.claims, |claim| item(app, claim))).into()
}

fn item(app: App, claim: ClaimView) -> HtmlLi {
    let words = app.words();
    // The mark is read as a word.
    let (mark, spoken) = match claim.holds {
        None => ("·", words.check_open),
        Some(true) => ("✓", words.check_holds),
        Some(false) => ("✗", words.check_fails),
    };
    let state = match claim.holds {
        None => "open",
        Some(true) => "holds",
        Some(false) => "fails",
    };
    li().attr("data-state", state)
        .child(span().class("mark").attr("aria-hidden", "true").child(mark))
        .child(span().class("visually-hidden").child(spoken).child(": "))
        .child(span().class("claim").child(claim.name).child(" ").child(code().child(claim.written)))
        .maybe((!claim.outcome.is_empty()).then(|| span().class("outcome").child(claim.outcome)))
}
