//! From a column of a table to an observation of a model.

use super::Observation;
use crate::table::Table;
use program::{Compiled, Model};
use units::{Dimension, Unit};

/// Why a column cannot be what is observed: a unit of another dimension.
#[derive(Clone, Debug, PartialEq)]
pub struct BindError {
    /// The column, by its label.
    pub column: String,
    /// The unit that its header gives.
    pub found: String,
    /// The dimension it must have.
    pub expected: Dimension,
    /// Whether it is the position in a film that has no scale.
    pub lacks_scale: bool,
}

impl std::fmt::Display for BindError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Self { column, found, expected, .. } = self;
        write!(f, "column {column} is in {found}, and what is observed is in {}", Unit::si(*expected))
    }
}

impl std::error::Error for BindError {}

/// Takes a column as a measurement of `observed`, called `name`. A column without a unit has that of what is observed, and
/// times without one have the model's. Rows without a time or a value are left out.
///
/// # Errors
/// The column's unit, or that of its times, has another dimension.
pub fn observation(
    model: &Model,
    table: &Table,
    column: usize,
    name: &str,
    observed: Compiled,
) -> Result<Observation, BindError> {
    let values = in_si(table, column, &observed.unit)?;
    let independent = table.columns.get(column).map_or(column, |column| column.independent);
    let times = in_si(table, independent, &model.independent.unit)?;
    let (times, values) =
        times.into_iter().zip(values).filter(|(time, value)| time.is_finite() && value.is_finite()).unzip();
    Ok(Observation { name: name.to_owned(), observed, times, values, errors: None, derived_from: None })
}

fn in_si(table: &Table, index: usize, unit: &Unit) -> Result<Vec<f64>, BindError> {
    let Some(column) = table.columns.get(index) else { return Ok(Vec::new()) };
    let level = column.origin.conversion.filter(|conversion| conversion.is_level() && unit.dimension.is_none());
    match (&column.unit, level) {
        // A model whose temperatures are bare numbers has them in degrees, as the file.
        (Some(_), Some(degrees)) => Ok(column.values.iter().map(|value| degrees.number(*value)).collect()),
        (Some(own), None) if own.dimension != unit.dimension => Err(BindError {
            column: table.label(index),
            found: own.to_string(),
            expected: unit.dimension,
            lacks_scale: own.dimension.lacks_scale_for(unit.dimension),
        }),
        _ => Ok(column.si(Some(unit))),
    }
}
