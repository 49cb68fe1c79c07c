//! Reading of measured data: text, spreadsheets, and Tracker projects.

use super::variable::{Stated, choices, choose, find};
use crate::names::{Assignment, Observe};
use crate::quoted::quoted;
use crate::refusal::Refusal;
use analysis::finding::Finding;
use analysis::import::{self, Format};
use analysis::inspection::{Derived, doubtful_times, inspect};
use analysis::origin::UnitOrigin;
use analysis::reading::{Reading, ReadingError};
use analysis::table::Table;
use analysis::{tracker, workbook};
use std::io::{self, Read};
use std::path::Path;
use std::sync::Arc;
use units::{Words, words};

/// Maximum size of a file, in bytes.
pub const MOST_BYTES: u64 = 256 << 20;

/// Maximum size of a file whose data a report carries, in bytes.
const MOST_CARRIED: usize = 1 << 20;

/// A file of measured data.
#[derive(Debug)]
pub struct Measured {
    /// Name for messages.
    pub name: String,
    /// Table of the file.
    pub table: Table,
    /// Findings about the file and the measurement.
    pub findings: Vec<Finding>,
    /// Columns that were computed from others.
    pub derived: Vec<Derived>,
    /// Format of the file.
    pub format: Format,
    /// Content of the file, for the report; `None` if it is too long for one.
    pub bytes: Option<Vec<u8>>,
}

/// Reads measured data from the bytes of a file. `name`: that of the file, for messages.
///
/// # Errors
/// Bytes that are no table, a statement about a column that does not exist, or an unknown unit.
pub fn measured(name: String, bytes: Vec<u8>, stated: Stated) -> Result<Measured, Refusal> {
    let kept = (bytes.len() <= MOST_CARRIED).then(|| bytes.clone());
    let contents = Reading::new(bytes, MOST_BYTES as usize)
        .and_then(|reading| reading.with_dates(stated.dates).complete())
        .map_err(|error| refused(&name, error))?;
    let import = contents.import;
    // Dates whose order was stated are carried as they were understood.
    let kept = kept.and_then(|bytes| match stated.dates {
        Some(_) => Some(contents.text.into_bytes()).filter(|text| !text.is_empty() && text.len() <= MOST_CARRIED),
        None => Some(bytes),
    });
    let mut table = import.table;
    state_units(&name, &mut table, stated.units)?;
    let mut findings = import.findings;
    findings.extend(choose(&name, &mut table, stated)?.map(Finding::Role));
    let inspection = inspect(&table);
    findings.extend(inspection.findings);
    findings.extend(doubtful_times(&table));
    Ok(Measured { name, table, findings, derived: inspection.derived, format: import.format, bytes: kept })
}

fn refused(name: &str, error: ReadingError) -> Refusal {
    let error = Arc::new(error);
    let of_hint = error.clone();
    let why = Words::each(move |language| error.message(language));
    Refusal::in_words(
        words!("cannot read {name}: {why}"),
        Words::each(move |language| of_hint.hint(language).to_owned()),
    )
}

/// Refusal of a file with more than [`MOST_BYTES`].
pub fn too_large(path: &Path) -> Refusal {
    Refusal::with_hint(
        format!("cannot read {}: it is larger than {} MB", path.display(), MOST_BYTES >> 20),
        "a measurement is a table of time and a few quantities; export only those",
    )
}

/// Reads all bytes of a source. Stops early if they cannot be a table or exceed [`MOST_BYTES`].
///
/// # Errors
/// A source that cannot be read, is too large, or is no table.
pub fn bounded(source: &mut dyn Read, path: &Path) -> Result<Vec<u8>, Refusal> {
    let failure = |error: io::Error| Refusal::file("read", path, &error);
    let mut bytes = Vec::new();
    source.take(8192).read_to_end(&mut bytes).map_err(failure)?;
    if !workbook::is_workbook(&bytes) && !tracker::is_project(&bytes) {
        let refused = |error| refused(&path.display().to_string(), ReadingError::Text(error));
        import::look(&bytes).map_err(refused)?;
    }
    source.take(MOST_BYTES).read_to_end(&mut bytes).map_err(failure)?;
    if bytes.len() as u64 > MOST_BYTES { Err(too_large(path)) } else { Ok(bytes) }
}

/// Sets the units of columns that the user states: `t=ms`, `Run 2.Angle=deg`. A name without a body applies to all
/// columns of that name.
fn state_units(file: &str, table: &mut Table, units: &[Assignment]) -> Result<(), Refusal> {
    for Assignment { name, value } in units {
        let found = find(file, table, name, &|name| format!("--unit {name}={value}"))?;
        let called = table.columns.get(found).map(|column| column.name.clone()).unwrap_or_default();
        let (unit, stated) = import::stated_unit(value.trim_matches(['[', ']']), &called).ok_or_else(|| {
            Refusal::with_hint(format!("--unit {name}={value}: `{value}` is not a known unit"), "write --unit t=ms")
        })?;
        let all_bodies = called.to_lowercase() == name.to_lowercase() && !called.is_empty();
        for (index, column) in table.columns.iter_mut().enumerate() {
            if index != found && !(all_bodies && column.name == called) {
                continue;
            }
            if column.origin.unit == UnitOrigin::Clock {
                return Err(Refusal::request(format!(
                    "--unit {name}={value}: {file} holds clock times there, which are read in seconds"
                )));
            }
            // The stated unit is that of the numbers in the file, so an earlier conversion is undone.
            if let Some(conversion) = column.origin.conversion.take() {
                column.values.iter_mut().for_each(|value| *value = conversion.number(*value));
            }
            if let Some(conversion) = stated {
                column.values.iter_mut().for_each(|value| *value = conversion.value(*value));
            }
            column.origin.conversion = stated;
            column.unit = Some(unit.clone());
            column.origin.unit = UnitOrigin::Person;
        }
    }
    Ok(())
}

impl Measured {
    /// Index of the column for an observed quantity: the stated one, or the one of the quantity's name. In a file
    /// without a header it is the first column that is not in `taken`.
    pub fn column(&self, observe: &Observe, taken: &[usize]) -> Result<usize, Refusal> {
        let table = &self.table;
        let which = observe.column.as_deref().unwrap_or(&observe.quantity);
        if observe.column.is_none() && table.columns.iter().all(|column| column.name.is_empty()) {
            let column = table.observed_columns().find(|column| !taken.contains(column)).ok_or_else(|| {
                Refusal::with_hint(
                    format!("{} has no column left for {}", self.name, observe.quantity),
                    format!("choose one with --observe {}=COLUMN", observe.quantity),
                )
            })?;
            self.check_roles(column)?;
            self.check_times(column)?;
            return Ok(column);
        }
        let column = find(&self.name, table, which, &|name| format!("--observe {}={name}", observe.quantity))?;
        self.check_roles(column)?;
        if table.columns.get(column).is_some_and(|found| found.independent == column) {
            let label = table.label(column);
            return Err(Refusal::with_hint(
                format!("{}: {label} is what the others are measured against", self.name),
                "choose another independent variable with --against COLUMN",
            ));
        }
        self.check_times(column)?;
        Ok(column)
    }

    /// Refuses a column with an ambiguous independent variable. The hint shows the choices.
    pub fn check_roles(&self, column: usize) -> Result<(), Refusal> {
        let table = &self.table;
        if !table.is_open(column) {
            return Ok(());
        }
        Err(Refusal::with_hint(
            format!("{}: it is open what {} is measured against", self.name, self.called(column)),
            choices(table),
        ))
    }

    /// Refuses a column whose times are missing, constant, or in an unknown unit.
    pub fn check_times(&self, column: usize) -> Result<(), Refusal> {
        let table = &self.table;
        let independent = table.columns.get(column).map_or(column, |column| column.independent);
        let name = self.called(independent);
        let unit = table.columns.get(independent).filter(|time| time.unit.is_none());
        if let Some(text) = unit.and_then(|time| time.origin.unit.unknown()) {
            return Err(Refusal::with_hint(
                format!("{}: `{text}`, the unit of {name}, is not a known unit", self.name),
                format!("state it, such as --unit {}=ms", quoted(name)),
            ));
        }
        if !table.has_times(column) {
            return Err(Refusal::with_hint(
                format!(
                    "{}: {} cannot be measured against {name}: its times are missing or all the same",
                    self.name,
                    self.called(column)
                ),
                "times are numbers, or clock times such as 10:00:00.050 or 2026-01-02T10:00:00.050",
            ));
        }
        Ok(())
    }

    /// Refuses a column with a unit that Meniscus does not have, because a fit would misinterpret it.
    pub fn check_unit(&self, column: usize) -> Result<(), Refusal> {
        let found =
            self.table.columns.get(column).filter(|column| column.unit.is_none()).map(|column| &column.origin.unit);
        let Some(UnitOrigin::Unknown(text)) = found else { return Ok(()) };
        let name = self.called(column);
        Err(Refusal::with_hint(
            format!("{}: `{text}`, the unit of {name}, is not a known unit", self.name),
            format!("state it, such as --unit {}=cm", quoted(name)),
        ))
    }

    /// Name for messages and headers: `y`, or `column 2` if the file gives no name.
    pub fn called(&self, column: usize) -> String {
        let unnamed = self.table.columns.get(column).is_some_and(|column| column.name.is_empty());
        if unnamed { format!("column {}", self.table.number(column)) } else { self.table.label(column) }
    }
}
