//! The cycles of a column, and what is looked at of them.

use analysis::cycles::{Cycles, NoCycles, Quantity};
use units::Unit;

/// What the view of cycles shows.
#[derive(Debug)]
pub(crate) struct CycleView {
    /// Whether it is open.
    pub open: bool,
    /// The record's id, and the column.
    pub chosen: Option<(u32, usize)>,
    /// What is drawn.
    pub quantity: Quantity,
    /// Whether it is drawn against the amplitude and not against the time.
    pub against_amplitude: bool,
    /// What was found.
    pub found: Option<Found>,
}

impl Default for CycleView {
    fn default() -> Self {
        Self { open: false, chosen: None, quantity: Quantity::Period, against_amplitude: false, found: None }
    }
}

/// The cycles of a column, in its unit and that of the independent variable.
#[derive(Debug)]
pub(crate) struct Found {
    /// The first and the last reading of the clock.
    pub ends: (f64, f64),
    /// The cycles, or the reason why there are none.
    pub cycles: Result<Cycles, NoCycles>,
    /// The column's unit.
    pub unit: Unit,
    /// What the column measures; empty if nothing of the document.
    pub name: String,
    /// The reading of the clock, SI, at which the model begins.
    pub origin: f64,
}
