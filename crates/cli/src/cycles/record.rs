//! Selection of the column and the part of a file that is analysed.

use crate::arguments::Cycles;
use crate::failure::Failure;
use analysis::cycles;
use runner::names::Observe;
use runner::records::{Measured, limits};
use units::Language;

/// The analysed record and its cycles.
#[derive(Debug)]
pub struct Record<'a> {
    /// The file.
    pub data: &'a Measured,
    /// Index of the column.
    pub column: usize,
    /// Name of the observed quantity as typed; otherwise the name of the column.
    pub name: String,
    /// Unit of the values; empty if the file states none.
    pub unit: String,
    /// Times of the selected part, in seconds.
    pub times: Vec<f64>,
    /// Values in `unit`, one per time.
    pub values: Vec<f64>,
    /// The cycles.
    pub found: cycles::Cycles,
}

/// Selects the column and the part stated in the arguments, and finds the cycles.
pub fn record<'a>(data: &'a Measured, arguments: &Cycles) -> Result<Record<'a>, Failure> {
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
    let part = limits(arguments.from.as_deref(), arguments.until.as_deref(), time_unit)?;
    let rows = time.map(|time| time.si(None)).unwrap_or_default().into_iter().zip(&table.columns[column].values);
    let (times, values): (Vec<f64>, Vec<f64>) = rows
        .filter(|(time, value)| part.contains(time) && value.is_finite())
        .map(|(time, value)| (time, *value))
        .unzip();
    let found = cycles::cycles(&times, &values).map_err(|reason| {
        let reason = reason.text(Language::English, &|value| format!("{value:.1}"));
        Failure::with_hint(
            format!("{}: {name}, {} rows. {reason}", data.name, times.len()),
            "choose another column with --observe NAME=COLUMN, or another part with --from and --until",
        )
    })?;
    let unit = table.columns[column].unit.as_ref().map(|unit| unit.text.clone()).unwrap_or_default();
    Ok(Record { data, column, name, unit, times, values, found })
}

/// Column with the largest range of values. Considers measured columns with the clock and the unit of the first one.
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
    data.check_roles(widest)?;
    data.check_times(widest)?;
    Ok(widest)
}
