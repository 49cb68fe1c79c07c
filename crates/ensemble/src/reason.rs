//! Why runs are made one by one.

use engine::{Interpreted, RunError};

/// Reason why runs of a model cannot be made in lanes.
#[derive(Clone, Debug, PartialEq)]
pub enum NoLanes {
    /// A run with the stated parameters cannot begin.
    Refused(RunError),
    /// The method, the kind of time or a linear system.
    Interpreted(Interpreted),
    /// They are not wanted.
    Unwanted,
    /// Buttons are pressed.
    Presses,
    /// Changes that depend on the independent variable alone, but not linearly.
    ChangesInTime,
    /// Events, switches that jump or changes at stated times, where solutions at given times are wanted.
    NotSmooth,
}
