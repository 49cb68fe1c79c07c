//! Fits in the page: started by a button, computed in slices between frames.

mod leaving_out;
mod report;
mod results;
mod setup;
mod starting;
mod theories;
mod work;

pub use work::go_on;

use crate::app::App;
use desk::FitProgress;
use starting::Starting;
use theories::Suitability;
use view::views::*;
use view::{browser, page::everything};

/// Last step of the tab *Measure*: record, theory, result.
pub fn view(app: App) -> View {
    let has_records = memo(move || {
        app.records.track();
        app.read_desk(|desk| !desk.records().list().is_empty())
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
    let starting = Starting::new();
    let Starting { refusal, chosen, ranked, .. } = starting;
    let suitability = Suitability::new(app);
    let begin = move |rank: bool| {
        wasm_bindgen_futures::spawn_local(async move {
            if rank { starting.rank(app).await } else { starting.fit(app, suitability).await }
        });
    };
    let busy = memo(move || app.fit_progress.with(Option::is_some));
    let begins = move |rank: bool| {
        button().attr("aria-disabled", move || busy.get().to_string()).when(events::click, move |_| begin(rank))
    };
    let buttons = div()
        .class("intake")
        .child(begins(false).class("primary").id("fit").child(words.fit_begin))
        .child(begins(true).class("quiet").id("rank").title(words.fit_rank_title).child(words.fit_rank))
        .child(changing(move || if busy.get() { running(app, starting) } else { View::new() }));
    let record = step("record-step", "1", words.fit_step_record)
        .child(setup::record(app, refusal))
        .child(leaving_out::view(app));
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
fn running(app: App, starting: Starting) -> View {
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
        starting.press();
        app.act_on_desk(|desk| desk.change_fits(|fits, _| fits.cancel()));
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
