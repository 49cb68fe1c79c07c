//! Binds a column of a table to an observation of a model.

use super::Observation;
use crate::table::Table;
use program::{Compiled, Model};
use units::{Dimension, Unit};

/// Error for a column that cannot be bound: its unit has another dimension.
#[derive(Clone, Debug, PartialEq)]
pub struct BindError {
    /// Label of the column.
    pub column: String,
    /// Unit in its header.
    pub found: String,
    /// Required dimension.
    pub expected: Dimension,
    /// True if the column is the position in a film without a scale.
    pub lacks_scale: bool,
}

impl std::fmt::Display for BindError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Self { column, found, expected, .. } = self;
        write!(f, "column {column} is in {found}, and what is observed is in {}", Unit::si(*expected))
    }
}

impl std::error::Error for BindError {}

/// Takes a column as a measurement of `observed`, with the name `name`. A column without a unit has the unit of `observed`;
/// times without a unit have that of the model. Rows without a time or a value are left out. Times and values are returned
/// in SI.
///
/// # Errors
/// The unit of the column, or that of its times, has another dimension.
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
        // A model with dimensionless temperatures has them in degrees, like the file.
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
