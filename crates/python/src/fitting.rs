//! Fits from Python arguments.

use crate::arguments::{Options, is_several, text};
use crate::disk::record;
use crate::errors::{refused, value_error};
use crate::fit::Fit;
use crate::settings::seat;
use analysis::fit::Loss;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use runner::Refusal;
use runner::fitting::{FitSettings, Fitted, Theory, fit_as_json, fit_as_text, task};
use runner::names::{Observe, observe};
use runner::records::{Measured, measured};
use std::path::PathBuf;

/// Measured data as they are given.
pub enum Record {
    /// A file.
    File(PathBuf),
    /// Columns, written as text.
    Columns(String),
}

/// One record, or several.
pub fn records(data: &Bound<'_, PyAny>, several: bool) -> PyResult<Vec<Record>> {
    let is_table = data.hasattr("keys")?;
    if several && !is_table {
        data.try_iter()?.map(|one| one_record(&one?)).collect()
    } else {
        Ok(vec![one_record(data)?])
    }
}

fn one_record(data: &Bound<'_, PyAny>) -> PyResult<Record> {
    if !data.hasattr("keys")? {
        return Ok(Record::File(data.extract()?));
    }
    let units = data.getattr("units").ok().filter(|units| units.is_instance_of::<PyDict>());
    let mut columns = Vec::new();
    for name in data.call_method0("keys")?.try_iter()? {
        let name = name?;
        let heading: String = name.extract()?;
        let unit: Option<String> = units.as_ref().and_then(|units| units.get_item(&name).ok()?.extract().ok());
        let heading = match unit.filter(|unit| !unit.is_empty()) {
            Some(unit) => format!("{heading} [{unit}]"),
            None => heading,
        };
        let numbers = data.get_item(&name)?.call_method1("__getitem__", (pyo3::types::PySlice::full(data.py()),));
        let numbers: Vec<f64> = match numbers {
            Ok(numbers) if numbers.hasattr("tolist")? => numbers.call_method0("tolist")?.extract()?,
            _ => data.get_item(&name)?.extract()?,
        };
        columns.push((heading, numbers));
    }
    Ok(Record::Columns(csv(&columns)?))
}

/// Columns as the text of a file. Numbers read back as the same bits; NaN is an empty cell.
fn csv(columns: &[(String, Vec<f64>)]) -> PyResult<String> {
    let rows = columns.first().map_or(0, |(_, numbers)| numbers.len());
    if columns.iter().any(|(_, numbers)| numbers.len() != rows) {
        return Err(value_error("the columns differ in length"));
    }
    let quoted = |name: &str| format!("\"{}\"", name.replace('"', "\"\""));
    let mut text = columns.iter().map(|(name, _)| quoted(name)).collect::<Vec<_>>().join(",");
    for row in 0..rows {
        let cell = |number: f64| if number.is_finite() { format!("{number:?}") } else { String::new() };
        let cells = columns.iter().map(|(_, numbers)| cell(numbers[row]));
        text.push('\n');
        text.push_str(&cells.collect::<Vec<_>>().join(","));
    }
    text.push('\n');
    Ok(text)
}

/// Takes the settings of a fit.
pub fn settings(observed: &Bound<'_, PyAny>, options: &Options) -> PyResult<FitSettings> {
    let mut quantities = Vec::new();
    if let Ok(columns) = observed.cast::<PyDict>() {
        for (quantity, column) in columns {
            let column = if column.is_instance_of::<PyString>() { column.extract()? } else { text(&column)? };
            quantities.push(Observe { quantity: quantity.extract()?, column: Some(column) });
        }
    } else {
        for text in crate::arguments::names(observed)? {
            quantities.push(observe(&text).map_err(value_error)?);
        }
    }
    Ok(FitSettings {
        observe: quantities,
        against: options.names("against")?.unwrap_or_default(),
        unit: options.assignments("unit")?,
        seat: seat(options)?,
        vary: list(options, "vary")?,
        share: list(options, "share")?,
        fix: options.assignments("fix")?,
        start: options.assignments("start")?,
        bounds: bounds(options)?,
        error: options.assignments("error")?,
        loss: loss(options.get::<String>("loss")?.as_deref())?,
        from: options.value("begin")?,
        until: options.value("until")?,
    })
}

/// Names, also with commas between them.
fn list(options: &Options, name: &str) -> PyResult<Vec<String>> {
    let names = options.names(name)?.unwrap_or_default();
    Ok(names.iter().flat_map(|names| names.split(',')).map(|name| name.trim().to_owned()).collect())
}

/// Ranges by name: texts `1..2`, or pairs in which `None` is no bound.
fn bounds(options: &Options) -> PyResult<Vec<runner::names::Assignment>> {
    let Some(given) = options.take("bounds")? else { return Ok(Vec::new()) };
    let given = given.cast_into::<PyDict>().map_err(|_| value_error("bounds must be a dictionary"))?;
    let end = |value: Bound<'_, PyAny>| if value.is_none() { Ok(String::new()) } else { text(&value) };
    let mut bounds = Vec::new();
    for (name, range) in given {
        let value = if is_several(&range) {
            let (low, high): (Bound<'_, PyAny>, Bound<'_, PyAny>) = range.extract()?;
            format!("{} .. {}", end(low)?, end(high)?)
        } else {
            range.extract()?
        };
        bounds.push(runner::names::Assignment { name: name.extract()?, value });
    }
    Ok(bounds)
}

fn loss(name: Option<&str>) -> PyResult<Loss> {
    match name {
        None | Some("least-squares") => Ok(Loss::Squares),
        Some("huber") => Ok(Loss::Huber),
        Some("tukey") => Ok(Loss::Tukey),
        Some(other) => Err(value_error(format!("loss is least-squares, huber or tukey, not {other}"))),
    }
}

/// Reads records for a theory.
pub fn read(records: &[Record], theory: &Theory, settings: &FitSettings) -> Result<Vec<Measured>, Refusal> {
    let one = |(place, one): (usize, &Record)| {
        let (name, bytes) = match one {
            Record::File(path) => (path.display().to_string(), record(path)?),
            Record::Columns(text) => (format!("record {}", place + 1), text.clone().into_bytes()),
        };
        measured(name, bytes, settings.stated(&theory.document))
    };
    records.iter().enumerate().map(one).collect()
}

/// Fits a theory.
pub fn fit(py: Python<'_>, theory: Theory, records: &[Record], settings: &FitSettings, profile: bool) -> PyResult<Fit> {
    if profile && settings.loss != Loss::Squares {
        return Err(value_error("profile needs least squares: with another loss the profile has no probability"));
    }
    let done = py.detach(|| {
        let mut theory = theory;
        let data = read(records, &theory, settings)?;
        let task = task(&mut theory.document, &data, settings, &mut |_| {})?;
        let fitted = Fitted::complete(theory, task, profile, &mut |_| {})?;
        Ok((fit_as_json(&fitted, &data).to_string(), fit_as_text(&fitted, &notes(&data)), fitted))
    });
    let (json, text, fitted) = done.map_err(|refusal| refused(py, &refusal))?;
    Fit::new(py, &json, text, &fitted)
}

/// Findings about each record, in sentences.
pub fn notes(data: &[Measured]) -> Vec<Vec<String>> {
    let notes = |one: &Measured| one.findings.iter().map(|finding| finding.text(units::Language::English)).collect();
    data.iter().map(notes).collect()
}
