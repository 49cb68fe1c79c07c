//! The cycles of a column, and the settings of their view.

use analysis::cycles::{Cycles, NoCycles, Quantity};
use units::Unit;

/// State of the view of cycles.
#[derive(Debug)]
pub(crate) struct CycleView {
    /// True if the view is open.
    pub open: bool,
    /// Id of the record and index of the column.
    pub chosen: Option<(u32, usize)>,
    /// The quantity that is plotted.
    pub quantity: Quantity,
    /// True if the abscissa is the amplitude, false if it is the time.
    pub against_amplitude: bool,
    /// The cycles of the chosen column; `None` while the view is closed or there is no column.
    pub found: Option<Found>,
}

impl Default for CycleView {
    fn default() -> Self {
        Self { open: false, chosen: None, quantity: Quantity::Period, against_amplitude: false, found: None }
    }
}

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
