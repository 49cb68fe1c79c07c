//! Reading of measured data: text, spreadsheets, and Tracker projects.

use crate::arguments::assignments::{Assignment, Observe};
use crate::arguments::variable::{Stated, choices, choose, find};
use crate::failure::Failure;
use crate::terminal::quoted::quoted;
use analysis::finding::Finding;
use analysis::import::{self, Format};
use analysis::inspection::{Derived, doubtful_times, inspect};
use analysis::origin::UnitOrigin;
use analysis::reading::{self, ReadingError};
use analysis::table::Table;
use analysis::{tracker, workbook};
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::Arc;
use units::{Words, words};

/// Maximum size of a file, in bytes.
const MOST_BYTES: u64 = 256 << 20;

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

/// Reads a file of measured data; `-` is the standard input.
pub fn read(path: &Path, stated: Stated) -> Result<Measured, Failure> {
    let (name, bytes) = if path == Path::new("-") {
        let name = "the standard input";
        (name.to_owned(), bounded(&mut std::io::stdin().lock(), Path::new(name))?)
    } else {
        let failure = |error: std::io::Error| Failure::file("read", path, &error);
        let metadata = std::fs::metadata(path).map_err(failure)?;
        if metadata.is_dir() {
            return Err(Failure::request(format!("cannot read {}: it is a directory", path.display())));
        }
        if metadata.len() > MOST_BYTES {
            return Err(too_large(path));
        }
        (path.display().to_string(), bounded(&mut File::open(path).map_err(failure)?, path)?)
    };
    let kept = (bytes.len() <= MOST_CARRIED).then(|| bytes.clone());
    let contents = reading::read(bytes, MOST_BYTES as usize);
    let import = contents.map_err(|error| refused(&name, error))?.import;
    let mut table = import.table;
    state_units(&name, &mut table, stated.units)?;
    let mut findings = import.findings;
    findings.extend(choose(&name, &mut table, stated)?.map(Finding::Role));
    let inspection = inspect(&table);
    findings.extend(inspection.findings);
    findings.extend(doubtful_times(&table));
    Ok(Measured { name, table, findings, derived: inspection.derived, format: import.format, bytes: kept })
}

fn refused(name: &str, error: ReadingError) -> Failure {
    let error = Arc::new(error);
    let of_hint = error.clone();
    let why = Words::each(move |language| error.message(language));
    Failure::in_words(
        words!("cannot read {name}: {why}"),
        Words::each(move |language| of_hint.hint(language).to_owned()),
    )
}

fn too_large(path: &Path) -> Failure {
    Failure::with_hint(
        format!("cannot read {}: it is larger than {} MB", path.display(), MOST_BYTES >> 20),
        "a measurement is a table of time and a few quantities; export only those",
    )
}

/// Reads all bytes. Stops early if they cannot be a table or exceed [`MOST_BYTES`].
fn bounded(source: &mut dyn Read, path: &Path) -> Result<Vec<u8>, Failure> {
    let failure = |error: std::io::Error| Failure::file("read", path, &error);
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
fn state_units(file: &str, table: &mut Table, units: &[Assignment]) -> Result<(), Failure> {
    for Assignment { name, value } in units {
        let unit = import::unit(value.trim_matches(['[', ']'])).ok_or_else(|| {
            Failure::with_hint(format!("--unit {name}={value}: `{value}` is not a known unit"), "write --unit t=ms")
        })?;
        let found = find(file, table, name, &|name| format!("--unit {name}={value}"))?;
        let called = table.columns.get(found).map(|column| column.name.clone()).unwrap_or_default();
        let all_bodies = called.to_lowercase() == name.to_lowercase() && !called.is_empty();
        for (index, column) in table.columns.iter_mut().enumerate() {
            if index != found && !(all_bodies && column.name == called) {
                continue;
            }
            if column.origin.unit == UnitOrigin::Clock {
                return Err(Failure::request(format!(
                    "--unit {name}={value}: {file} holds clock times there, which are read in seconds"
                )));
            }
            // The stated unit is that of the numbers in the file, so an earlier conversion is undone.
            if let Some(conversion) = column.origin.conversion.take() {
                column.values.iter_mut().for_each(|value| *value = conversion.number(*value));
            }
            column.unit = Some(unit.clone());
            column.origin.unit = UnitOrigin::Person;
        }
    }
    Ok(())
}

impl Measured {
    /// Index of the column for an observed quantity: the stated one, or the one of the quantity's name. In a file
    /// without a header it is the first column that is not in `taken`.
    pub fn column(&self, observe: &Observe, taken: &[usize]) -> Result<usize, Failure> {
        let table = &self.table;
        let which = observe.column.as_deref().unwrap_or(&observe.quantity);
        if observe.column.is_none() && table.columns.iter().all(|column| column.name.is_empty()) {
            let column = table.observed_columns().find(|column| !taken.contains(column)).ok_or_else(|| {
                Failure::with_hint(
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
            return Err(Failure::with_hint(
                format!("{}: {label} is what the others are measured against", self.name),
                "choose another independent variable with --against COLUMN",
            ));
        }
        self.check_times(column)?;
        Ok(column)
    }

    /// Refuses a column with an ambiguous independent variable. The hint shows the choices.
    pub fn check_roles(&self, column: usize) -> Result<(), Failure> {
        let table = &self.table;
        if !table.is_open(column) {
            return Ok(());
        }
        Err(Failure::with_hint(
            format!("{}: it is open what {} is measured against", self.name, self.called(column)),
            choices(table),
        ))
    }

    /// Refuses a column whose times are missing, constant, or in an unknown unit.
    pub fn check_times(&self, column: usize) -> Result<(), Failure> {
        let table = &self.table;
        let independent = table.columns.get(column).map_or(column, |column| column.independent);
        let name = self.called(independent);
        let unit = table.columns.get(independent).filter(|time| time.unit.is_none());
        if let Some(text) = unit.and_then(|time| time.origin.unit.unknown()) {
            return Err(Failure::with_hint(
                format!("{}: `{text}`, the unit of {name}, is not a known unit", self.name),
                format!("state it, such as --unit {}=ms", quoted(name)),
            ));
        }
        if !table.has_times(column) {
            return Err(Failure::with_hint(
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
    pub fn check_unit(&self, column: usize) -> Result<(), Failure> {
        let found =
            self.table.columns.get(column).filter(|column| column.unit.is_none()).map(|column| &column.origin.unit);
        let Some(UnitOrigin::Unknown(text)) = found else { return Ok(()) };
        let name = self.called(column);
        Err(Failure::with_hint(
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
