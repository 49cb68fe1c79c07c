//! The result of a fit in three lines: whether the curve meets the data, the period, and the varied numbers. Before, what keeps
//! the fit from being made, or its progress.

use super::{go_on, results};
use crate::app::App;
use desk::{EstimateView, FitDetail, FitProgress, Nearness};
use view::browser;
use view::pieces::symbols::symbol;
use view::views::*;

/// The lines; their place is kept while they are empty.
pub fn view(app: App) -> HtmlDiv {
    let shown = results::shown(app);
    let shown =
        memo(move || shown.with(|(fits, shown)| (*shown, fits.iter().find(|fit| Some(fit.id) == *shown).cloned())));
    let busy = memo(move || app.fit_progress.with(Option::is_some));
    let lines = move || {
        if busy.get() {
            return running(app);
        }
        if let Some(why) = app.fit.refusal.get_clone() {
            return p().class("refusal").id("fit-refusal").role("alert").child(why).into();
        }
        let (id, fit) = shown.get_clone();
        let detail = id.and_then(|id| app.read_desk(|desk| desk.fits().detail(id)));
        match (detail, app.fit.objection()) {
            (Some(detail), _) => {
                let other = fit.filter(|fit| !fit.applicable).map(|fit| fit.theory);
                result(detail, other)
            }
            (None, Some(reason)) => note(reason).id("unsuitable").into(),
            (None, None) => View::new(),
        }
    };
    div().class("fit-lines").id("fit-lines").child(changing(lines))
}

/// The result. `other`: title of its theory, if that is not the open document.
fn result(detail: FitDetail, other: Option<String>) -> View {
    let FitDetail { doubt, nearness, estimates, leading, .. } = detail;
    let (nearness, sentence) = nearness.unwrap_or((Nearness::Scattered, String::new()));
    // A doubt is the reason why the numbers are not applied.
    let (nearness, sentence) = doubt.map_or((nearness, sentence), |doubt| (Nearness::Missed, doubt));
    let (kind, sign) = match nearness {
        Nearness::Met => ("met", "✓"),
        Nearness::Scattered => ("scattered", "≈"),
        Nearness::Missed => ("missed", "✗"),
    };
    let lead = leading
        .and_then(|place| estimates.get(place))
        .map(|one| p().class("lead").child(number(one)).child(span().class("note").child(one.label.clone())));
    let varied = estimates.iter().filter(|one| !one.derived);
    let varied = p().class("found").each(varied, |one| {
        let label = span().class("visually-hidden").child(format!("{}: ", one.label));
        span().class("unbroken").attr("title", one.label.clone()).child(label).child(number(one))
    });
    View::from((
        p().class("nearness")
            .attr("data-nearness", kind)
            .child(span().class("sign").attr("aria-hidden", "true").child(sign))
            .maybe(other.map(|theory| span().class("theory").child(theory)))
            .child(span().child(sentence)),
        View::from(lead.map(View::from)),
        varied,
    ))
}

/// `L = 21.611 ± 0.005 cm`.
fn number(one: &EstimateView) -> HtmlSpan {
    span().child(symbol(&one.name)).child(format!(" = {} {}", one.value, one.unit))
}

/// Progress bar with a cancel button, while a fit is running.
fn running(app: App) -> View {
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
        app.fit.press();
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
