//! Results as text with aligned columns.

use super::fitted::Fitted;
use crate::refusal::listed;
use analysis::fit::{Estimate, Interval, ObservationFit, Outcome};
use report::readable_units;
use std::fmt::Write;
use units::Language;
use units::number::{self, Group, Style, concise, unit_text};

/// Rows of cells that are aligned in columns.
#[derive(Default)]
pub struct Columns {
    rows: Vec<Vec<String>>,
}

impl Columns {
    /// Adds a row.
    pub fn push(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// Text of the rows with aligned columns. Column `i` is aligned to the right if `right[i]` is true, otherwise to
    /// the left.
    pub fn text(&self, right: &[bool]) -> String {
        let count = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let width =
            |column: usize| self.rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max();
        let widths: Vec<usize> = (0..count).map(|column| width(column).unwrap_or(0)).collect();
        let mut text = String::new();
        for row in &self.rows {
            let mut line = String::from(" ");
            for (column, cell) in row.iter().enumerate() {
                let pad = " ".repeat(widths[column].saturating_sub(cell.chars().count()));
                line.push(' ');
                match right.get(column) {
                    Some(true) => line.extend([pad.as_str(), cell, " "]),
                    _ => line.extend([cell.as_str(), &pad, " "]),
                }
            }
            text.push_str(line.trim_end());
            text.push('\n');
        }
        text
    }
}

/// Text of a fit with all its statistics.
pub fn fit_as_text(fitted: &Fitted, notes: &[Vec<String>]) -> String {
    let outcome = &fitted.outcome;
    let mut text = String::new();
    let names: Vec<&str> = fitted.task.records.iter().map(|record| record.name.as_str()).collect();
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{}, fitted to {}\n", fitted.theory.document.program.title, listed(names));
    if !outcome.converged {
        text.push_str("The fit did not converge: these values are only the best that were found.\n\n");
    }
    text.push_str(&parameters(fitted));
    if outcome.derived.iter().any(|one| one.determined) {
        text.push_str("\nFrom these\n");
        text.push_str(&estimates(&outcome.derived, &[], fitted));
    }
    for one in &outcome.undetermined {
        let _ = writeln!(text, "\n{}", one.text(Language::English));
    }
    text.push('\n');
    text.push_str(&quality(outcome, fitted));
    let _ = writeln!(text, "\n{}", outcome.verdict_text(Language::English));
    for sentence in fitted.remarks().into_iter().chain(searches(outcome)) {
        let _ = writeln!(text, "{sentence}");
    }
    let derived: Vec<&str> =
        outcome.observations.iter().filter(|one| one.derived).map(|one| one.name.as_str()).collect();
    if !derived.is_empty() {
        let _ = writeln!(
            text,
            "{} was computed from another column: it adds no independent information, and is not counted twice.",
            listed(derived)
        );
    }
    for (record, notes) in fitted.task.records.iter().zip(notes).filter(|(_, notes)| !notes.is_empty()) {
        let _ = writeln!(text, "\n{}", record.name);
        for note in notes {
            let _ = writeln!(text, "  {note}");
        }
    }
    text
}

fn parameters(fitted: &Fitted) -> String {
    let outcome = &fitted.outcome;
    let mut text = estimates(&outcome.parameters, &fitted.intervals, fitted);
    if outcome.parameters.iter().any(|one| one.stderr_hac.is_some()) {
        text.push_str(
            "  In brackets: the standard error of the last digits, for residuals correlated in time (the larger of the\n  \
             Newey-West error and that of an AR(1) process). Behind: the textbook's, for independent residuals.\n",
        );
    }
    if !fitted.intervals.is_empty() {
        text.push_str(
            "  68 % and 95 %: intervals from the profile of chi-square, for independent residuals as well.\n",
        );
    }
    text
}

fn estimates(estimates: &[Estimate], intervals: &[Option<[Interval; 2]>], fitted: &Fitted) -> String {
    let mut columns = Columns::default();
    for (place, one) in readable_units(estimates).iter().enumerate() {
        let record = one.record.and_then(|record| fitted.task.records.get(record));
        let name = match record {
            Some(record) => format!("{} ({})", one.name, record.name),
            None => one.name.clone(),
        };
        let value = one.unit.from_si(one.value);
        let error = one.stderr_hac.map(|error| one.unit.from_si(error));
        let shown = if one.determined { concise(value, error, Style::POINT) } else { "not determined".to_owned() };
        let remark = match (one.stopped_text(Language::English), one.stderr) {
            (Some(stopped), _) => stopped.to_owned(),
            (_, Some(error)) => format!("±{}", number::plain(one.unit.from_si(error), 2, Style::POINT)),
            _ => String::new(),
        };
        let unit = if one.determined { unit_text(&one.unit.text) } else { String::new() };
        let profile = intervals.get(place).copied().flatten().map_or_else(String::new, |intervals| {
            let end = |si: Option<f64>| {
                si.map_or("…".to_owned(), |si| number::plain(one.unit.from_si(si), 5, Style::POINT))
            };
            let [one_sigma, two_sigma] =
                intervals.map(|interval| format!("{} … {}", end(interval.low), end(interval.high)));
            format!("68 %: {one_sigma}; 95 %: {two_sigma}")
        });
        columns.push(vec![name, shown, unit, remark, profile, one.label.clone().unwrap_or_default()]);
    }
    columns.text(&[])
}

fn quality(outcome: &Outcome, fitted: &Fitted) -> String {
    let mut columns = Columns::default();
    let number = |value: f64| number::plain(value, 5, Style::POINT);
    columns.push(vec!["values, degrees of freedom".to_owned(), format!("{}, {}", outcome.n, outcome.dof)]);
    for one in &outcome.observations {
        let sizes = report::sizes(outcome, &one.name, Style::POINT);
        columns.push(vec![format!("RMSE of {}", called(one, fitted)), sizes.quantity(one.rmse)]);
        if let Some(outside) = one.outside {
            columns.push(vec![
                format!("RMSE of {} outside the fitted part", called(one, fitted)),
                format!("{} ({} values)", sizes.quantity(outside.rmse), outside.n),
            ]);
        }
    }
    for (record, when) in beginnings(fitted) {
        let what = if record.is_empty() { String::new() } else { format!(" ({record})") };
        columns.push(vec![format!("initial values refer to{what}"), when]);
    }
    if let Some(reduced) = outcome.chi2_reduced {
        columns.push(vec!["reduced chi-square".to_owned(), number(reduced)]);
    }
    match &outcome.reweighted {
        None => columns.push(vec!["R²".to_owned(), number::plain(outcome.r2, 6, Style::POINT)]),
        Some(robust) => {
            if let Some(first) = outcome.observations.first() {
                let what = format!("scale of {} (median)", called(first, fitted));
                columns.push(vec![what, in_unit(first, robust.scale)]);
            }
        }
    }
    columns.push(vec![
        "AICc, BIC".to_owned(),
        format!(
            "{}, {}",
            outcome.aicc.map_or("–".to_owned(), |aicc| number::plain(aicc, 6, Style::POINT)),
            number::plain(outcome.bic, 6, Style::POINT)
        ),
    ]);
    let mut statistic =
        format!("{} (2 for independent residuals)", number::plain(outcome.durbin_watson, 3, Style::POINT));
    if let Some(runs) = outcome.runs {
        let _ = write!(statistic, "; {} runs of equal sign ({:.0} expected)", runs.runs, runs.expected);
    }
    columns.push(vec!["Durbin-Watson".to_owned(), statistic]);
    columns.text(&[])
}

/// Sentences about the starts of the search and about another minimum.
pub fn searches(outcome: &Outcome) -> Vec<String> {
    let quantity = |one: &Estimate, si: f64| report::quantity(si, &one.unit, Style::POINT);
    outcome.search_texts(Language::English).into_iter().chain(outcome.rival_text(Language::English, quantity)).collect()
}

/// Clock readings at which the initial values hold, one per record: `t = 1.0333 s`, with a remark about earlier values.
/// Each is preceded by the record's name if there are several.
pub fn beginnings(fitted: &Fitted) -> Vec<(String, String)> {
    let clock = &fitted.theory.document.program.model.independent;
    let beginning = |(record, origin): (usize, &f64)| {
        let mut when = format!("{} = {}", clock.name, report::quantity(*origin, &clock.unit, Style::POINT));
        let of_record = fitted.outcome.observations.iter().filter(|one| one.record == record);
        let early: usize = of_record.map(|one| one.early).sum();
        if early > 0 {
            let _ = write!(when, "; nothing is predicted of the {early} values before");
        }
        let name = fitted.task.records.get(record).filter(|_| fitted.task.records.len() > 1);
        (name.map(|record| record.name.clone()).unwrap_or_default(), when)
    };
    fitted.outcome.origins.iter().enumerate().map(beginning).collect()
}

/// Name of an observation, with its record if there are several.
fn called(one: &ObservationFit, fitted: &Fitted) -> String {
    match fitted.task.records.get(one.record).filter(|_| fitted.task.records.len() > 1) {
        Some(record) => format!("{} ({})", one.name, record.name),
        None => one.name.clone(),
    }
}

/// Size of a residual, given in SI, in a suitable unit.
fn in_unit(one: &ObservationFit, si: f64) -> String {
    Group::of_residuals(&one.unit, &[si], 3, Style::POINT).quantity(si)
}
