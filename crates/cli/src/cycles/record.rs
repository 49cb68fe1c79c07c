//! Selection of the column and the part of a file that is analysed.

use crate::arguments::Cycles;
use crate::failure::Failure;
use analysis::cycles;
use runner::names::Observe;
use runner::records::{Measured, limits};
use runner::{listed, quoted};
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
    let part = |column: usize| part_of(data, column, arguments);
    let (times, values) = part(column)?;
    let found = cycles::cycles(&times, &values).map_err(|reason| {
        let reason = reason.text(Language::English, &|value| format!("{value:.1}"));
        let others = oscillating(data, column, &part);
        let hint = match others.len() {
            0 => "choose another column with --observe NAME=COLUMN, or another part with --from and --until".to_owned(),
            1 => format!("{} oscillates: write --observe {}", others[0].0, others[0].1),
            _ => {
                let named = |(label, _): &(String, String)| label.clone();
                let option = |(_, option): &(String, String)| format!("--observe {option}");
                let (labels, options) = (others.iter().map(named), others.iter().map(option).collect::<Vec<_>>());
                format!("{} oscillate: write {}", listed(labels), options.join(" or "))
            }
        };
        Failure::with_hint(format!("{}: {name}, {} rows. {reason}", data.name, times.len()), hint)
    })?;
    let unit = table.columns[column].unit.as_ref().map(|unit| unit.text.clone()).unwrap_or_default();
    Ok(Record { data, column, name, unit, times, values, found })
}

/// Times, in seconds, and values of a column in the part stated in the arguments.
fn part_of(data: &Measured, column: usize, arguments: &Cycles) -> Result<(Vec<f64>, Vec<f64>), Failure> {
    let table = &data.table;
    let time = table.columns.get(table.columns[column].independent);
    let time_unit = time.and_then(|time| time.unit.as_ref());
    let part = limits(arguments.from.as_deref(), arguments.until.as_deref(), time_unit)?;
    let rows = time.map(|time| time.si(None)).unwrap_or_default().into_iter().zip(&table.columns[column].values);
    Ok(rows
        .filter(|(time, value)| part.contains(time) && value.is_finite())
        .map(|(time, value)| (time, *value))
        .unzip())
}

/// Labels of the measured columns other than `but` that oscillate, with the texts that select them.
fn oscillating(
    data: &Measured,
    but: usize,
    part: &dyn Fn(usize) -> Result<(Vec<f64>, Vec<f64>), Failure>,
) -> Vec<(String, String)> {
    // Upper bound of the columns that are tried, and of those that are named.
    const TRIED: usize = 24;
    const NAMED: usize = 4;
    let usable =
        |column: &usize| *column != but && data.check_roles(*column).is_ok() && data.check_times(*column).is_ok();
    let oscillates =
        |column: &usize| part(*column).is_ok_and(|(times, values)| cycles::cycles(&times, &values).is_ok());
    let columns = data.table.observed_columns().filter(usable).take(TRIED).filter(oscillates).take(NAMED);
    columns.map(|column| (data.called(column), quoted(data.table.typed(column)))).collect()
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
