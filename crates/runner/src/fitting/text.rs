//! Results as text with aligned columns.

use super::fitted::Fitted;
use crate::refusal::listed;
use analysis::fit::ObservationFit;
use report::{FitReport, FitRow};
use units::number::{self, Style};

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

/// Text of a fit with all its statistics, in English. `notes`: findings about the data of each record.
pub fn fit_as_text(fitted: &Fitted, notes: &[Vec<String>]) -> String {
    let fit = fitted.fit_report();
    let names: Vec<&str> = fitted.task.records.iter().map(|record| record.name.as_str()).collect();
    let mut text = format!("{}, fitted to {}\n\n", fitted.theory.document.program.title, listed(names));
    let lines = |lines: &[String]| lines.iter().flat_map(|line| [line, "\n"]).collect::<String>();
    if !fit.warnings.is_empty() {
        text += &(lines(&fit.warnings) + "\n");
    }
    text += &rows(fit.varied(), fitted);
    if fitted.outcome.parameters.iter().any(|one| one.stderr_hac.is_some()) {
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
    if fit.derived().any(|row| row.estimate.determined) {
        text.push_str("\nFrom these\n");
        text += &rows(fit.derived(), fitted);
    }
    text.push('\n');
    text += &quality(&fit, fitted);
    text += &format!("\n{}\n{}", fit.verdict, lines(&fit.findings));
    for (record, notes) in fitted.task.records.iter().zip(notes).filter(|(_, notes)| !notes.is_empty()) {
        text += &format!("\n{}\n", record.name);
        text.extend(notes.iter().map(|note| format!("  {note}\n")));
    }
    text
}

/// Text of varied numbers or of derived quantities.
fn rows<'a>(rows: impl Iterator<Item = &'a FitRow>, fitted: &Fitted) -> String {
    let mut columns = Columns::default();
    for row in rows {
        let one = &row.estimate;
        let name = match one.record.and_then(|record| fitted.task.records.get(record)) {
            Some(record) => format!("{} ({})", one.name, record.name),
            None => one.name.clone(),
        };
        let remark = match one.stderr.filter(|_| row.note.is_empty()) {
            Some(error) => format!("±{}", number::plain(one.unit.from_si(error), 2, Style::POINT)),
            None => row.note.to_owned(),
        };
        let profile = row.intervals.map_or_else(String::new, |intervals| {
            let end = |si: Option<f64>| {
                si.map_or("…".to_owned(), |si| number::plain(one.unit.from_si(si), 5, Style::POINT))
            };
            let [one_sigma, two_sigma] =
                intervals.map(|interval| format!("{} … {}", end(interval.low), end(interval.high)));
            format!("68 %: {one_sigma}; 95 %: {two_sigma}")
        });
        columns.push(vec![name, row.rounded.clone(), row.unit_text(), remark, profile, row.label.clone()]);
    }
    columns.text(&[])
}

/// Text of the statistics, with the residuals of each observation if there are several or if values were predicted.
fn quality(fit: &FitReport, fitted: &Fitted) -> String {
    let outcome = &fitted.outcome;
    let mut columns = Columns::default();
    for one in &fit.statistics {
        columns.push(vec![one.name.to_owned(), one.full_text()]);
    }
    for one in &outcome.observations {
        let sizes = report::sizes(outcome, &one.name, Style::POINT);
        if outcome.observations.len() > 1 {
            columns.push(vec![format!("RMS residual of {}", called(one, fitted)), sizes.quantity(one.rmse)]);
        }
        if let Some(outside) = one.outside {
            columns.push(vec![
                format!("RMS residual of {} outside the fitted part", called(one, fitted)),
                format!("{} ({} values)", sizes.quantity(outside.rmse), outside.n),
            ]);
        }
    }
    columns.text(&[])
}

/// Name of an observation, with its record if there are several.
fn called(one: &ObservationFit, fitted: &Fitted) -> String {
    match fitted.task.records.get(one.record).filter(|_| fitted.task.records.len() > 1) {
        Some(record) => format!("{} ({})", one.name, record.name),
        None => one.name.clone(),
    }
}
