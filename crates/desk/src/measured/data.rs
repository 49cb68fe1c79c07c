//! The columns in use, and the state of residuals and outline.

use engine::{Readings, Routine};
use program::Compiled;

/// A column in use, in SI units.
#[derive(Clone, Debug)]
pub(crate) struct Measured {
    /// Id of the record.
    pub record: u32,
    /// Index of the column in the record.
    pub column: usize,
    /// Name of the record.
    pub record_name: String,
    /// Quantity of the document that it measures.
    pub name: String,
    pub observed: Compiled,
    /// Model times, SI, ascending, without gaps in the data. One per value.
    pub times: Vec<f64>,
    pub values: Vec<f64>,
    /// Standard errors of the values, not finite if missing; empty if the record has no such column.
    pub errors: Vec<f64>,
    /// True for values that are left out of fits, one per value; empty if none are.
    pub excluded: Vec<bool>,
    /// Longest interval between two times that is not a gap.
    pub pause: f64,
}

/// State of the computation of a column's residuals.
#[derive(Debug)]
pub(crate) struct Residuals {
    pub readings: Readings,
    /// Number of values that have been processed.
    pub passed: usize,
}

impl Measured {
    /// True if the value of this row is left out of fits.
    pub fn excludes(&self, row: usize) -> bool {
        self.excluded.get(row).copied().unwrap_or(false)
    }

    /// Value at a time, linearly interpolated between its neighbours; `None` in a gap and outside the data.
    pub fn at(&self, time: f64) -> Option<f64> {
        let next = self.times.partition_point(|&at| at < time);
        let (after, value) = (*self.times.get(next)?, *self.values.get(next)?);
        if after == time {
            return Some(value);
        }
        let (before, from) = (*self.times.get(next.checked_sub(1)?)?, *self.values.get(next - 1)?);
        let part = (time - before) / (after - before);
        (after - before <= self.pause).then_some(from + part * (value - from))
    }
}

/// Program that evaluates the scene with measured values.
#[derive(Debug)]
pub(crate) struct Outline {
    pub routine: Routine,
    /// Indices in [`super::MeasuredData`] of the columns that replace computed values.
    pub columns: Vec<usize>,
    /// The parameters, followed by the measured values.
    pub inputs: Vec<f64>,
    pub values: Vec<f64>,
}
