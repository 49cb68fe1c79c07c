//! The cycles of a column.

use analysis::cycles::{Cycles, NoCycles};
use units::Unit;

/// Cycles of a column, in the units of the column and of the independent variable.
#[derive(Debug)]
pub(crate) struct Found {
    /// First and last time of the column, in the unit of the independent variable.
    pub ends: (f64, f64),
    /// The cycles, or the reason why none were found.
    pub cycles: Result<Cycles, NoCycles>,
    /// Unit of the values.
    pub unit: Unit,
    /// Quantity of the document that the column measures; empty if it measures none.
    pub name: String,
    /// Clock reading at which the model begins, SI.
    pub origin: f64,
}
