//! Standard errors of observed values: stated, or columns of the files.

use crate::names::Assignment;
use crate::records::{Measured, find};
use crate::refusal::Refusal;
use crate::values::{Reader, positive};
use analysis::fit::{Observation, Task};
use analysis::lookup::LookupError;
use program::Compiled;
use units::{Unit, Words, words};

/// `--error y=VALUE` or `--error y=COLUMN`. `data`: the files, each with the columns of its observations.
pub(super) fn errors(
    reader: &mut Reader,
    task: &mut Task,
    (data, columns): (&[Measured], &[Vec<usize>]),
    error: &Assignment,
    observed: &[(String, Compiled)],
) -> Result<(), Refusal> {
    let Some(place) = observed.iter().position(|(name, _)| *name == error.name) else {
        return Err(Refusal::unknown("observed quantity", &error.name, observed.iter().map(|(name, _)| name.as_str())));
    };
    for ((record, measured), columns) in task.records.iter_mut().zip(data).zip(columns) {
        let observation: &mut Observation = &mut record.observations[place];
        let called = |value: &String| match measured.table.column(value) {
            Err(LookupError::Unknown) => Ok(None),
            _ => {
                find(&measured.name, &measured.table, value, &|name| format!("--error {}={name}", error.name)).map(Some)
            }
        };
        let column = if error.value.parse::<f64>().is_ok() { None } else { called(&error.value)? };
        let errors = match column {
            Some(column) => column_errors(measured, column, columns[place], &observed[place].1.unit)?,
            None => {
                let what = format!("--error {}", error.name);
                let unit = &observed[place].1.unit;
                let value = positive(&what, reader.value(&what, &error.value, unit, &task.parameters)?)?;
                vec![value; observation.values.len()]
            }
        };
        observation.errors = Some(errors);
    }
    Ok(())
}

/// Uses the standard errors that the files contain for an observed quantity, as written by `meniscus track`, with a
/// note.
pub(super) fn errors_of_files(
    task: &mut Task,
    (data, columns): (&[Measured], &[Vec<usize>]),
    (place, name, unit): (usize, &str, &Unit),
    note: &mut dyn FnMut(&Words),
) -> Result<(), Refusal> {
    for ((record, measured), columns) in task.records.iter_mut().zip(data).zip(columns) {
        let Some(column) = measured.table.errors_of(columns[place]) else { continue };
        record.observations[place].errors = Some(column_errors(measured, column, columns[place], unit)?);
        let (file, called) = (&measured.name, measured.called(column));
        note(&words!("{file}: the standard errors of {name} are those of its column {called}"));
    }
    Ok(())
}

/// Standard errors of the column `observed`, SI, one per row that has a time and a value.
fn column_errors(measured: &Measured, column: usize, observed: usize, unit: &Unit) -> Result<Vec<f64>, Refusal> {
    let table = &measured.table;
    let own = &table.columns[column];
    // Errors without a unit are in that of their values.
    let unit =
        table.columns[observed].unit.as_ref().filter(|of_values| of_values.dimension == unit.dimension).unwrap_or(unit);
    if let Some(given) = own.unit.as_ref().filter(|given| given.dimension != unit.dimension) {
        return Err(Refusal::request(format!(
            "{}: {} is in {given}, and what is observed is in {unit}",
            measured.name,
            measured.called(column)
        )));
    }
    Ok(of_values(measured, observed, &own.si(Some(unit))))
}

/// Entries of a list of rows that belong to the values of an observed column: those of rows with a time and a value.
pub(super) fn of_values<T: Copy>(measured: &Measured, column: usize, rows: &[T]) -> Vec<T> {
    let table = &measured.table;
    let rows = rows.iter().zip(&table.columns[column].values).zip(table.times_of(column));
    rows.filter(|((_, value), time)| value.is_finite() && time.is_finite()).map(|((row, _), _)| *row).collect()
}
