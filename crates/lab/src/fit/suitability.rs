//! Suitability of the open document as the theory of the chosen record. One that cannot hold the record is not preselected.

use crate::app::App;
use desk::{PeriodComparison, PeriodQuestion};
use view::browser;
use view::panel::tabs;
use view::views::*;

/// Asks whether the open document can hold the chosen record, while the tab *Measure* is open.
pub fn follow(app: App) {
    effect(move || {
        app.changes.document.track();
        app.changes.program.track();
        // What was said about one document does not hold for the next.
        app.fit.insists.set(false);
        app.fit.refusal.set(None);
    });
    effect(move || {
        app.changes.document.track();
        app.changes.program.track();
        app.records.track();
        app.fits.track();
        if app.tab.get() == tabs::MEASURE {
            ask(app);
        }
    });
}

/// Asks again if anything has changed on which the answer depends.
fn ask(app: App) {
    let fit = app.fit;
    let question = app.read_desk(|desk| desk.fits().period_question(desk.revision()));
    if fit.asked.with_untracked(|asked| *asked == question) {
        return;
    }
    fit.asked.set(question.clone());
    let comparison = question.and_then(|question| app.read_desk(|desk| desk.fits().compare_periods(question)));
    fit.waits.set(comparison.is_some());
    match comparison {
        Some(comparison) => wasm_bindgen_futures::spawn_local(compute(app, comparison)),
        None => answer(app, None),
    }
}

/// Computes the answer, one period in each task of the browser, unless something else is asked meanwhile.
async fn compute(app: App, mut comparison: PeriodComparison) {
    loop {
        browser::breathe().await;
        let is_asked = |asked: &Option<PeriodQuestion>| asked.as_ref() == Some(comparison.question());
        if !app.fit.asked.with_untracked(is_asked) {
            return;
        }
        if comparison.advance() {
            break;
        }
    }
    app.fit.waits.set(false);
    answer(app, app.read_desk(|desk| desk.fits().cannot_hold(&comparison)));
}

fn answer(app: App, reason: Option<String>) {
    if app.fit.reason.with_untracked(|before| *before != reason) {
        app.fit.reason.set(reason);
    }
}

/// Waits for the answer.
pub async fn known(app: App) {
    while app.fit.waits.get_untracked() {
        browser::breathe().await;
    }
}
