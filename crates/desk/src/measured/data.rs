//! What is measured, beside the model: records, their columns in use, what computes residuals and the outline in the scene.

use crate::records::record::Record;
use engine::{Readings, Routine};
use play::Follows;
use program::Compiled;

/// The records, and what they are for the document that is open.
#[derive(Debug, Default)]
pub(crate) struct Data {
    /// Oldest first.
    pub records: Vec<Record>,
    /// How many ids records have been given: none is given twice, because fits call records by them.
    pub issued: u32,
    /// The columns in use of those that are drawn.
    pub measured: Vec<Measured>,
    /// How far the residuals of each of them have been computed; they stand in the plot of the residuals.
    pub residuals: Vec<Residuals>,
    /// The scene as the measurement has it.
    pub outline: Option<(Outline, Vec<Follows>)>,
    /// Raised whenever points or residuals are others, and not only more.
    pub version: u64,
}

impl Data {
    /// The version of a series of points or residuals in its plot, by its number, for [`figure::Series`].
    pub fn version_of(&self, series: usize) -> u64 {
        // More series than this have no version of their own, and are gone through for each frame.
        const MOST: u64 = 64;
        let series = series as u64 + 1;
        if series < MOST { self.version * MOST + series } else { 0 }
    }
}

/// A column in use, SI.
#[derive(Clone, Debug)]
pub(crate) struct Measured {
    /// The record's id.
    pub record: u32,
    /// What it measures.
    pub name: String,
    pub observed: Compiled,
    /// The model's time, ascending; gaps are left out.
    pub times: Vec<f64>,
    pub values: Vec<f64>,
    /// Their standard errors, not finite where one is missing; empty where the record has none.
    pub errors: Vec<f64>,
    /// Longer pauses than this are gaps.
    pub pause: f64,
}

/// What computes the residuals of a column.
#[derive(Debug)]
pub(crate) struct Residuals {
    pub readings: Readings,
    /// How many of the column's values have been passed.
    pub passed: usize,
}

impl Measured {
    /// The value at a time, between the two neighbours; none in a gap.
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

/// What evaluates the scene with measured values.
#[derive(Debug)]
pub(crate) struct Outline {
    pub routine: Routine,
    /// Which of the measured columns are put in.
    pub columns: Vec<usize>,
    /// The parameters, and after them the measured values.
    pub inputs: Vec<f64>,
    pub values: Vec<f64>,
}
