//! `meniscus cycles`: analysis of an oscillation cycle by cycle, without a theory.

mod figure;
mod record;
mod text;

use crate::arguments::{Cycles, CyclesFormat};
use crate::data;
use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output;
use analysis::csv::{self, Dialect};
use analysis::cycles;
use record::{Record, record};
use runner::records::{Stated, columns_as_json, columns_as_text};
use serde_json::json;
use units::Language;

/// Reads the data, finds the cycles and writes them.
pub fn run(arguments: &Cycles, terminal: Terminal) -> Result<(), Failure> {
    let data = data::read(
        &arguments.data,
        Stated { units: &arguments.unit, against: &arguments.against, dates: arguments.dates, ..Stated::default() },
    )?;
    let record = record(&data, arguments)?;
    let format = format(arguments);
    let text = match format {
        CyclesFormat::Text => text::table(&record),
        CyclesFormat::Json => as_json(&record),
        CyclesFormat::Csv => as_csv(&record),
        CyclesFormat::Svg => figure::svg(&record),
    };
    output::deliver(arguments.output.as_deref(), std::slice::from_ref(&arguments.data), text.as_bytes())?;
    // CSV and SVG cannot contain these notes.
    if matches!(format, CyclesFormat::Csv | CyclesFormat::Svg) {
        terminal.print(&columns_as_text(&data));
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
        "column": record.data.table.number(record.column),
        "unit": record.unit,
        "time_unit": "s",
        "rows": record.times.len(),
        "findings": findings,
        "columns": columns_as_json(record.data),
        "cycles": cycles,
        "lost_from": record.found.lost,
        "sinusoidal": record.found.sinusoidal,
        "correlation": record.found.correlation,
        "drift": record.found.drift.as_ref().map(|drift| json!({ "from": drift.from, "to": drift.to })),
        "cut_off": record.found.cut_off.map(|cut| json!({ "rows": cut.rows, "low": cut.low, "high": cut.high })),
        "sentences": text::sentences(record),
    });
    format!("{object:#}\n")
}

fn as_csv(record: &Record) -> String {
    let table = cycles::columns(&record.found.cycles, &record.unit, "s");
    let headers: Vec<&str> = table.iter().map(|(head, _)| head.as_str()).collect();
    let columns: Vec<&[f64]> = table.iter().map(|(_, column)| column.as_slice()).collect();
    csv::write(&headers, &columns, Dialect::Commas)
}
