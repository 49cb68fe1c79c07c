//! `meniscus cycles`: an oscillation cycle by cycle, before any theory.

mod figure;
mod text;

use crate::arguments::{Cycles, CyclesFormat};
use crate::columns;
use crate::data::{self, Measured, Observe};
use crate::failure::Failure;
use crate::output;
use crate::terminal::Terminal;
use analysis::csv::{self, Dialect};
use analysis::cycles;
use serde_json::json;
use units::Language;

/// What was measured, and its cycles.
#[derive(Debug)]
struct Record<'a> {
    data: &'a Measured,
    column: usize,
    /// What is observed, as the person calls it.
    name: String,
    /// Its unit, empty if the file gives none.
    unit: String,
    /// Seconds, and the column's own unit; the part that was asked for.
    times: Vec<f64>,
    values: Vec<f64>,
    found: cycles::Cycles,
}

/// Reads the data, measures the cycles and writes them.
pub fn run(arguments: &Cycles, terminal: Terminal) -> Result<(), Failure> {
    let data = data::read(&arguments.data, &arguments.unit)?;
    let record = record(&data, arguments)?;
    let format = format(arguments);
    let text = match format {
        CyclesFormat::Text => text::table(&record),
        CyclesFormat::Json => as_json(&record),
        CyclesFormat::Csv => as_csv(&record),
        CyclesFormat::Svg => figure::svg(&record),
    };
    output::deliver(arguments.output.as_deref(), std::slice::from_ref(&arguments.data), text.as_bytes())?;
    // A table of numbers and a figure have no place for these.
    if matches!(format, CyclesFormat::Csv | CyclesFormat::Svg) {
        terminal.print(&columns::as_text(&data));
        for finding in &data.findings {
            terminal.note(finding);
        }
    }
    Ok(())
}

fn format(arguments: &Cycles) -> CyclesFormat {
    let by_ending = || {
        let ending = arguments.output.as_ref()?.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "json" => Some(CyclesFormat::Json),
            "csv" => Some(CyclesFormat::Csv),
            "svg" => Some(CyclesFormat::Svg),
            _ => None,
        }
    };
    arguments.format.or_else(by_ending).unwrap_or(CyclesFormat::Text)
}

fn record<'a>(data: &'a Measured, arguments: &Cycles) -> Result<Record<'a>, Failure> {
    let column = match &arguments.observe {
        Some(observe) => data.column(observe, &[])?,
        None => widest(data)?,
    };
    let name = match &arguments.observe {
        Some(Observe { quantity, .. }) => quantity.clone(),
        None => data.called(column),
    };
    let table = &data.table;
    let time = table.columns.get(table.columns[column].independent);
    let time_unit = time.and_then(|time| time.unit.as_ref());
    let bound =
        |name: &str, text: &Option<String>| text.as_ref().map(|text| data::reading(name, text, time_unit)).transpose();
    let from = bound("--from", &arguments.from)?.unwrap_or(f64::NEG_INFINITY);
    let until = bound("--until", &arguments.until)?.unwrap_or(f64::INFINITY);
    let rows = time.map(|time| time.si(None)).unwrap_or_default().into_iter().zip(&table.columns[column].values);
    let (times, values): (Vec<f64>, Vec<f64>) = rows
        .filter(|(time, value)| (from..=until).contains(time) && value.is_finite())
        .map(|(time, value)| (time, *value))
        .unzip();
    let found = cycles::cycles(&times, &values).ok_or_else(|| {
        Failure::with_hint(
            format!("{}: {name} does not oscillate so that cycles could be told ({} rows)", data.name, times.len()),
            "a cycle needs three turning points, clear of the noise, with eight rows about them; choose another column \
             with --observe NAME=COLUMN, or another part with --from and --until",
        )
    })?;
    let unit = table.columns[column].unit.as_ref().map(|unit| unit.text.clone()).unwrap_or_default();
    Ok(Record { data, column, name, unit, times, values, found })
}

/// The column that moves most among those of the first body that were measured and share the first one's unit.
fn widest(data: &Measured) -> Result<usize, Failure> {
    let table = &data.table;
    let is_derived = |column: &usize| data.derived.iter().any(|derived| derived.column == *column);
    let measured: Vec<usize> = table.observed_columns().filter(|column| !is_derived(column)).collect();
    let Some(&first) = measured.first() else {
        return Err(Failure::request(format!("{} has no measured column", data.name)));
    };
    let comparable = |column: &&usize| {
        let (one, other) = (&table.columns[first], &table.columns[**column]);
        one.independent == other.independent && one.unit == other.unit && !one.name.is_empty()
    };
    let range = |column: usize| {
        let (low, high) = table.columns[column]
            .values
            .iter()
            .filter(|value| value.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)));
        high - low
    };
    let most =
        measured.iter().filter(comparable).copied().rev().max_by(|one, other| range(*one).total_cmp(&range(*other)));
    let widest = most.unwrap_or(first);
    data.check_times(widest)?;
    Ok(widest)
}

fn as_json(record: &Record) -> String {
    let measured = |measured: cycles::Measured| json!({ "value": measured.value, "stderr": measured.error });
    let cycles: serde_json::Value = record
        .found
        .cycles
        .iter()
        .map(|cycle| {
            json!({
                "time": measured(cycle.time),
                "turning_point": if cycle.maximum { "maximum" } else { "minimum" },
                "amplitude": measured(cycle.amplitude),
                "period": measured(cycle.period),
                "decrement": measured(cycle.decrement),
                "angular_frequency": measured(cycle.angular_frequency),
                "damping": measured(cycle.damping),
                "offset": measured(cycle.offset),
            })
        })
        .collect();
    let findings: Vec<String> = record.data.findings.iter().map(|finding| finding.text(Language::English)).collect();
    let object = json!({
        "file": record.data.name,
        "observed": record.name,
        "column": record.column + 1,
        "unit": record.unit,
        "time_unit": "s",
        "rows": record.times.len(),
        "findings": findings,
        "columns": columns::as_json(record.data),
        "cycles": cycles,
        "lost_from": record.found.lost,
        "sinusoidal": record.found.sinusoidal,
    });
    format!("{object:#}\n")
}

fn as_csv(record: &Record) -> String {
    let table = cycles::columns(&record.found.cycles, &record.unit, "s");
    let headers: Vec<&str> = table.iter().map(|(head, _)| head.as_str()).collect();
    let columns: Vec<&[f64]> = table.iter().map(|(_, column)| column.as_slice()).collect();
    csv::write(&headers, &columns, Dialect::Commas)
}
