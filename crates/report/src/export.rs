//! Data of the report: workbook and CSV.

use crate::written::size;
use crate::{FitReport, FitRow, Report};
use analysis::csv::{self, Dialect};
use analysis::fit::{Estimate, ObservationFit};
use analysis::spreadsheet::{Cell, Sheet, Workbook};
use units::number::with_unit;

/// CSV of the data, row by row: for each observation the time, the measured value, the fitted value, the residual, and
/// 1 if the value was fitted. `decimal_comma`: for spreadsheets that expect it.
pub fn csv(report: &Report<'_>, decimal_comma: bool) -> String {
    let (headers, columns) = data(report);
    let headers: Vec<&str> = headers.iter().map(String::as_str).collect();
    let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
    csv::write(&headers, &columns, if decimal_comma { Dialect::Semicolons } else { Dialect::Commas })
}

/// The report as an XLSX workbook, with sheets for results, data, curves, correlations, and origin.
pub fn workbook(report: &Report<'_>) -> Vec<u8> {
    let language = report.language;
    let (headers, columns) = data(report);
    let data = sheet(language.say("Data"), &headers, &columns);
    let (headers, columns) = curves(report);
    let mut sheets = vec![results(report), data];
    if !columns.is_empty() {
        sheets.push(sheet(language.say("Curves"), &headers, &columns));
    }
    sheets.push(correlations(report));
    sheets.push(about(report));
    Workbook { sheets }.xlsx()
}

/// Sheet of numeric columns.
fn sheet(name: &str, headers: &[String], columns: &[Vec<f64>]) -> Sheet {
    let headers: Vec<&str> = headers.iter().map(String::as_str).collect();
    let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
    Sheet::of_columns(name, &headers, &columns)
}

/// Heading with its unit, preceded by the record's name if there are several.
fn heading(report: &Report<'_>, record: usize, name: &str, unit: &str) -> String {
    let mut text = name.to_owned();
    if !unit.is_empty() {
        text.extend([" [", unit, "]"]);
    }
    match report.task.records.get(record) {
        Some(record) if report.task.records.len() > 1 => [&record.name, ": ", &text].concat(),
        _ => text,
    }
}

fn data(report: &Report<'_>) -> (Vec<String>, Vec<Vec<f64>>) {
    let language = report.language;
    let clock = &report.document.program.model.independent;
    let mut headers = Vec::new();
    let mut columns = Vec::new();
    let mut times: Option<(usize, &[f64])> = None;
    for fit in &report.outcome.observations {
        // Observations of one record at the same times share the time column.
        if times.is_none_or(|(record, known)| record != fit.record || known != fit.times) {
            headers.push(heading(report, fit.record, &clock.name, &clock.unit.text));
            columns.push(fit.times.iter().map(|time| clock.unit.from_si(*time)).collect());
            times = Some((fit.record, &fit.times));
        }
        let name = |what: &str| [&fit.name, " ", what].concat();
        let shown = |values: &[f64]| values.iter().map(|si| fit.unit.from_si(*si)).collect::<Vec<f64>>();
        let unit = fit.unit.text.as_str();
        headers.push(heading(report, fit.record, &name(language.say("measured")), unit));
        columns.push(shown(&fit.measured));
        headers.push(heading(report, fit.record, &name(language.say("fitted")), unit));
        columns.push(shown(&fit.fitted));
        headers.push(heading(report, fit.record, &name(language.say("residual")), unit));
        columns.push(residuals(fit));
        headers.push(heading(report, fit.record, &name(language.say("used")), ""));
        columns.push(fit.inside.iter().map(|inside| f64::from(u8::from(*inside))).collect());
    }
    (headers, columns)
}

fn residuals(fit: &ObservationFit) -> Vec<f64> {
    fit.measured.iter().zip(&fit.fitted).map(|(measured, fitted)| size(&fit.unit, measured - fitted)).collect()
}

fn curves(report: &Report<'_>) -> (Vec<String>, Vec<Vec<f64>>) {
    let language = report.language;
    let clock = &report.document.program.model.independent;
    let (mut headers, mut columns) = (Vec::new(), Vec::new());
    let mut last = None;
    for trace in report.traces {
        let observations = &report.outcome.observations;
        let belongs = |fit: &&ObservationFit| fit.record == trace.record && fit.observation == trace.observation;
        let Some(fit) = observations.iter().find(belongs) else { continue };
        if last != Some(trace.record) {
            headers.push(heading(report, trace.record, &clock.name, &clock.unit.text));
            columns.push(trace.times.iter().map(|time| clock.unit.from_si(*time)).collect());
            last = Some(trace.record);
        }
        headers.push(heading(report, trace.record, &fit.name, &fit.unit.text));
        columns.push(trace.values.iter().map(|si| fit.unit.from_si(*si)).collect());
        let name = [&fit.name, language.say(" standard error")].concat();
        headers.push(heading(report, trace.record, &name, &fit.unit.text));
        columns.push(trace.stderr.iter().map(|si| size(&fit.unit, *si)).collect());
    }
    (headers, columns)
}

pub fn results(report: &Report<'_>) -> Sheet {
    let language = report.language;
    let outcome = report.outcome;
    let mut rows: Vec<Vec<Cell>> = vec![
        [
            language.say("Symbol"),
            language.say("Quantity"),
            language.say("Record"),
            language.say("Value"),
            language.say("Standard error"),
            language.say("Standard error if residuals were independent"),
            language.say("Unit"),
            language.say("Rounded"),
        ]
        .map(Cell::from)
        .to_vec(),
    ];
    let fit = FitReport::new(report);
    rows.extend(fit.rows.iter().map(|row| result(report, row)));
    rows.push(Vec::new());
    let mut say = |name: &str, value: f64, unit: &str, note: &str| {
        let value = Cell::Number(value);
        rows.push(vec![
            Cell::Empty,
            name.into(),
            Cell::Empty,
            value,
            Cell::Empty,
            Cell::Empty,
            unit.into(),
            note.into(),
        ]);
    };
    fit.statistics.iter().for_each(|one| say(one.name, one.value, &one.unit.text, &one.note));
    for fit in &outcome.observations {
        if let Some(outside) = fit.outside {
            let name = [language.say("Root mean square predicted: "), &fit.name].concat();
            let name = heading(report, fit.record, &name, "");
            say(&name, size(&fit.unit, outside.rmse), &fit.unit.text, "");
        }
    }
    rows.push(Vec::new());
    rows.extend(fit.sentences().map(|sentence| vec![Cell::Empty, sentence.as_str().into()]));
    Sheet { name: language.say("Results").to_owned(), rows, header: true }
}

fn result(report: &Report<'_>, row: &FitRow) -> Vec<Cell> {
    let estimate = &row.estimate;
    let record = estimate.record.and_then(|record| report.task.records.get(record));
    let error = |si: Option<f64>| si.map_or(Cell::Empty, |si| Cell::Number(size(&estimate.unit, si)));
    let value = if estimate.determined { Cell::Number(estimate.unit.from_si(estimate.value)) } else { Cell::Empty };
    let rounded = if row.note.is_empty() { with_unit(&row.rounded, &estimate.unit) } else { row.note.to_owned() };
    vec![
        estimate.name.as_str().into(),
        row.label.as_str().into(),
        record.map_or("", |record| &record.name).into(),
        value,
        error(estimate.stderr_hac),
        error(estimate.stderr),
        estimate.unit.text.as_str().into(),
        rounded.into(),
    ]
}

fn correlations(report: &Report<'_>) -> Sheet {
    let language = report.language;
    let parameters = &report.outcome.parameters;
    let name = |estimate: &Estimate| heading(report, estimate.record.unwrap_or(usize::MAX), &estimate.name, "");
    let mut first = vec![Cell::Empty];
    first.extend(parameters.iter().map(|estimate| Cell::from(name(estimate))));
    let mut rows = vec![first];
    for (row, values) in report.outcome.correlation.chunks(parameters.len().max(1)).enumerate() {
        let mut cells = vec![parameters.get(row).map_or(Cell::Empty, |estimate| name(estimate).into())];
        cells.extend(values.iter().map(|value| Cell::Number(*value)));
        rows.push(cells);
    }
    Sheet { name: language.say("Correlations").to_owned(), rows, header: true }
}

fn about(report: &Report<'_>) -> Sheet {
    let language = report.language;
    let line = |name: &str, value: &str| vec![Cell::from(name), Cell::from(value)];
    let mut rows = vec![
        line(language.say("Title"), &report.document.program.edition(language.tag()).title),
        line(language.say("Theory"), report.document_name),
        line(language.say("Command"), report.command),
        line(language.say("Program"), &["Meniscus ", report.version].concat()),
        line(language.say("Date"), report.date),
    ];
    for (number, record) in report.task.records.iter().enumerate() {
        rows.push(line(language.say("Data"), &record.name));
        let notes = report.notes.get(number).map_or(&[][..], Vec::as_slice);
        rows.extend(notes.iter().map(|note| line("", note)));
    }
    rows.push(Vec::new());
    let source = report.document.source.lines();
    rows.extend(source.map(|text| line("", text)));
    Sheet { name: language.say("About").to_owned(), rows, header: false }
}
