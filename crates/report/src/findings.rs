//! Sections about the residuals, the prediction, and undetermined parameters.

use crate::Report;
use crate::fit_report::FitReport;
use crate::markup::{Page, cell, escaped, symbol};
use crate::written;
use analysis::fit::{ObservationFit, Outcome, Verdict};
use units::number::{fixed, near_one};

/// Adds the statistics at the head of a report.
pub fn numbers(page: &mut Page, fit: &FitReport) {
    for one in &fit.statistics {
        page.raw("<div>");
        page.pair(one.name, &one.full_text());
        page.raw("</div>\n");
    }
}

/// True if the verdict is a warning, or the results are doubtful.
pub fn warns(outcome: &Outcome) -> bool {
    !matches!(outcome.verdict(), Verdict::Exact | Verdict::Compatible)
        || !outcome.outliers.is_empty()
        || outcome.stopped().next().is_some()
        || !outcome.undersampled.is_empty()
}

/// Adds the warnings, if there are any.
pub fn warnings(page: &mut Page, fit: &FitReport) {
    if fit.warnings.is_empty() {
        return;
    }
    page.raw("<div class=\"callout\">");
    fit.warnings.iter().for_each(|sentence| page.element("p", sentence));
    page.raw("</div>\n");
}

/// Adds the explanation of the standard errors, and the factor by which the errors for independent residuals are too
/// small.
pub fn errors(page: &mut Page, report: &Report<'_>) {
    let language = report.language;
    let outcome = report.outcome;
    let mut text = language
        .say(
            "The digits in parentheses are the standard error (68 %) in units of the last digits. It allows for residuals that \
             are correlated in time: it is the larger of the error of Newey and West and that of an autoregressive process of \
             order one.",
        )
        .to_owned();
    let ratios =
        outcome.parameters.iter().filter_map(|one| Some(one.stderr_hac? / one.stderr?)).filter(|r| r.is_finite());
    let (least, greatest) = ratios.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), r| (low.min(r), high.max(r)));
    if greatest > 1.3 {
        let style = language.style();
        let range = if greatest - least < 0.15 {
            fixed(greatest, 1, style)
        } else {
            [&fixed(least, 1, style), language.say(" to "), &fixed(greatest, 1, style)].concat()
        };
        text.extend([
            language.say(
                " The textbook's formula, for independent residuals, gives errors that are too small by a factor of ",
            ),
            &range,
            ".",
        ]);
    }
    page.element("p class=\"note\"", &text);
}

/// Adds the section about the residuals.
pub fn residuals(page: &mut Page, report: &Report<'_>, fit: &FitReport) {
    page.heading(report.language.say("What the residuals say"));
    page.element("p", &fit.verdict);
    fit.findings.iter().for_each(|sentence| page.element("p", sentence));
    if report.outcome.observations.len() > 1 {
        by_observation(page, report);
    }
}

/// Adds a table of the quality of the fit of each observation.
fn by_observation(page: &mut Page, report: &Report<'_>) {
    let language = report.language;
    let style = language.style();
    page.table(
        "wide",
        &[
            language.say("Record"),
            language.say("Observed"),
            language.say("#Values fitted"),
            language.say("#Root mean square"),
            "#R²",
        ],
    );
    for fit in &report.outcome.observations {
        let used = fit.inside.iter().filter(|inside| **inside).count();
        let mut observed = symbol(&fit.name);
        if fit.derived {
            observed += language.say(" <small>computed from another column</small>");
        }
        let cells = [
            escaped(record(report, fit)),
            observed,
            cell(&used.to_string()),
            cell(&written::sizes(report.outcome, &fit.name, style).quantity(fit.rmse)),
            cell(&near_one(fit.r2, style)),
        ];
        page.row(&cells.each_ref().map(String::as_str));
    }
    page.end_table();
}

/// Name of the record of an observation.
pub fn record<'a>(report: &Report<'a>, fit: &ObservationFit) -> &'a str {
    report.task.records.get(fit.record).map_or("", |record| &record.name)
}

/// Adds the section about the prediction of the values outside the fitted part, if there are any.
pub fn prediction(page: &mut Page, report: &Report<'_>) {
    let language = report.language;
    let style = language.style();
    let outside: Vec<&ObservationFit> =
        report.outcome.observations.iter().filter(|fit| fit.outside.is_some()).collect();
    if outside.is_empty() {
        return;
    }
    page.heading(language.say("Prediction"));
    let text = language.say(
        "Values outside the fitted part had no say in the fit. How well they are met tells a theory from a flexible curve.",
    );
    page.element("p", text);
    page.table(
        "wide",
        &[
            language.say("Record"),
            language.say("Observed"),
            language.say("#Values predicted"),
            language.say("#Root mean square there"),
            language.say("#in the fitted part"),
            language.say("#Ratio"),
        ],
    );
    for fit in outside {
        let Some(outside) = fit.outside else { continue };
        let cells = [
            escaped(record(report, fit)),
            symbol(&fit.name),
            cell(&outside.n.to_string()),
            cell(&written::sizes(report.outcome, &fit.name, style).quantity(outside.rmse)),
            cell(&written::sizes(report.outcome, &fit.name, style).quantity(fit.rmse)),
            cell(&fixed(outside.rmse / fit.rmse, 2, style)),
        ];
        page.row(&cells.each_ref().map(String::as_str));
    }
    page.end_table();
}
