//! Fits in the page: started by a button, computed in slices between frames.

mod report;
mod results;
mod setup;
mod theories;
mod work;

pub use work::go_on;

use crate::app::App;
use crate::library;
use desk::{Desk, FitProgress};
use view::views::*;
use view::{browser, everything};

/// Last step of the tab *Measure*: record, theory, result.
pub fn view(app: App) -> View {
    let has_records = memo(move || {
        app.records.track();
        app.read_desk(|desk| !desk.records().is_empty())
    });
    // While the tab is open, the plots show the selected part of the time axis.
    effect(move || {
        app.tab.track();
        app.page.wake();
    });
    changing(move || if has_records.get() { steps(app) } else { nothing_yet(app) })
}

/// Content without records.
fn nothing_yet(app: App) -> View {
    let section = section().class("fitting-steps").attr("aria-labelledby", "fit-title");
    section.child(title(app)).child(note(app.words().fit_none)).into()
}

fn title(app: App) -> HtmlH3 {
    h3().id("fit-title").child(app.words().fit_title)
}

fn steps(app: App) -> View {
    let words = app.words();
    let refusal = create_signal(None::<String>);
    let chosen = create_signal(None::<u32>);
    // Result shown unless the user chooses: the best one after a ranking, otherwise the last one.
    let ranked = create_signal(true);
    // Number of fits that were started or cancelled, so that a ranking that is not the last wish is dropped.
    let presses = create_signal(0);
    let suitability = theories::Suitability::new(app);
    let begin = move |rank: bool| {
        if let Some(reason) = suitability.objection().filter(|_| !rank) {
            return refusal.set(Some(reason));
        }
        ranked.set(rank);
        chosen.set(None);
        presses.update(|count| *count += 1);
        if rank {
            return wasm_bindgen_futures::spawn_local(rank_theories(app, presses, refusal));
        }
        let file = app.with(|lab| lab.sources.first().map(|file| file.name.clone())).flatten().unwrap_or_default();
        refusal.set(app.attempt_on_desk(|desk| desk.begin_fit(&file)));
        go_on(app);
    };
    let busy = memo(move || app.fit_progress.with(Option::is_some));
    let begins = move |rank: bool| {
        button().attr("aria-disabled", move || busy.get().to_string()).when(events::click, move |_| begin(rank))
    };
    let buttons = div()
        .class("intake")
        .child(begins(false).class("primary").id("fit").child(words.fit_begin))
        .child(begins(true).class("quiet").id("rank").title(words.fit_rank_title).child(words.fit_rank))
        .child(changing(move || if busy.get() { running(app, presses) } else { View::new() }));
    let record = step("record-step", "1", words.fit_step_record).child(setup::record(app, refusal));
    let theory = step("theory-step", "2", words.fit_step_theory)
        .child(theories::view(app, suitability))
        .child(setup::varied(app, refusal));
    let fit = step("fit-step", "3", words.fit_step_fit)
        .child(buttons)
        .child(refusal_of(refusal))
        .child(results::view(app, chosen, ranked))
        .child(everything::only(app.page, Box::new(move || setup::options(app).into())));
    section()
        .class("fitting-steps")
        .attr("aria-labelledby", "fit-title")
        .child(title(app))
        .child(record)
        .child(theory)
        .child(fit)
        .into()
}

/// Opens the theories, one in each task of the browser, and starts their fits unless something else was started or cancelled
/// meanwhile.
async fn rank_theories(app: App, presses: Signal<u32>, refusal: Signal<Option<String>>) {
    let press = presses.get_untracked();
    let mut theories = Vec::new();
    for entry in library::theories() {
        browser::breathe().await;
        theories.extend(entry.open().map(|document| (entry.file().to_owned(), document)));
    }
    browser::breathe().await;
    // The views may have been built again for another document, whose records are the same.
    let is_shown = presses.is_alive();
    if is_shown && presses.get_untracked() != press {
        return;
    }
    let refused = app.attempt_on_desk(|desk| desk.begin_ranking(theories));
    if is_shown {
        refusal.set(refused);
    }
    go_on(app);
}

/// A card with its step number.
fn step(id: &'static str, number: &'static str, title: &'static str) -> HtmlSection {
    let heading = format!("{id}-title");
    let number = span().class("number-of-step").attr("aria-hidden", "true").child(number);
    section()
        .class("fitting card step")
        .id(id)
        .attr("aria-labelledby", heading.clone())
        .child(h3().id(heading).child(number).child(title))
}

/// Progress bar with a cancel button, while a fit is running.
fn running(app: App, presses: Signal<u32>) -> View {
    let words = app.words();
    let progress = app.fit_progress;
    let finished = move || progress.with(|now| now.as_ref().map_or((0, 1), |now| now.finished));
    let reported = move || {
        progress.with(|now| {
            let Some(FitProgress { theory, trials, finished, .. }) = now else { return String::new() };
            let place = if finished.1 > 1 { format!("{}/{}: ", finished.0 + 1, finished.1) } else { String::new() };
            format!("{place}{theory}, {trials} {}", words.fit_trials)
        })
    };
    // The progress of a single fit is unknown.
    let part = move || {
        let (done, all) = finished();
        (all > 1).then(|| done.to_string())
    };
    let cancel = move |_| {
        presses.update(|count| *count += 1);
        app.act_on_desk(Desk::cancel_fit);
        go_on(app);
        progress.set(None);
        browser::focus("fit");
    };
    View::from((
        tags::progress().attr("aria-label", words.fit_begin).max(move || finished().1.to_string()).value(part),
        span().class("note").child(text(reported)),
        button().class("quiet").id("cancel-fit").when(events::click, cancel).child(words.fit_cancel),
    ))
}
