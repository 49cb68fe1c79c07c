//! Measured data beside the model: records, the columns in use, and the state of residuals and outline.

use crate::records::record::Record;
use engine::{Readings, Routine};
use play::Follows;
use program::Compiled;

/// The records and the data derived from them for the open document.
#[derive(Debug, Default)]
pub(crate) struct Data {
    /// The records, oldest first.
    pub records: Vec<Record>,
    /// Number of ids issued so far. Ids are never reused, because fits refer to records by id.
    pub issued: u32,
    /// The columns in use of all records that are drawn.
    pub measured: Vec<Measured>,
    /// State of the residuals, one per entry of `measured`.
    pub residuals: Vec<Residuals>,
    /// The outline: the scene drawn with measured values.
    pub outline: Option<(Outline, Vec<Follows>)>,
    /// Incremented whenever points or residuals are replaced, as opposed to appended.
    pub version: u64,
}

impl Data {
    /// Version of a series of points or residuals for [`figure::Series`], by its index in the plot. 0 for series
    /// without one.
    pub fn version_of(&self, series: usize) -> u64 {
        // Series from this number on have no version and are scanned in full for each frame.
        const MOST: u64 = 64;
        let series = series as u64 + 1;
        if series < MOST { self.version * MOST + series } else { 0 }
    }
}

/// A column in use, in SI units.
#[derive(Clone, Debug)]
pub(crate) struct Measured {
    /// Id of the record.
    pub record: u32,
    /// Quantity of the document that it measures.
    pub name: String,
    pub observed: Compiled,
    /// Model times, SI, ascending, without gaps in the data. One per value.
    pub times: Vec<f64>,
    pub values: Vec<f64>,
    /// Standard errors of the values, not finite if missing; empty if the record has no such column.
    pub errors: Vec<f64>,
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
    /// Indices in [`Data::measured`] of the columns that replace computed values.
    pub columns: Vec<usize>,
    /// The parameters, followed by the measured values.
    pub inputs: Vec<f64>,
    pub values: Vec<f64>,
}
