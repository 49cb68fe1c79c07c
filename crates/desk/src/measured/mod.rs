//! Measured values beside the simulation's: points over curves, residuals, and the outline in the scene.
//!
//! `MeasuredData::renew` (`points.rs`) converts each column in use to SI (`Record::series`), subtracts the origin of time and
//! the offset, and keeps the result. `begin_residuals` empties the plot of the residuals, an `AddedPlot`. In each frame
//! `Desk::follow` calls `truncate_residuals` if the run has given up rows, and then `follow_residuals`. For each measured
//! time up to the front, `TimeLine::state_at` interpolates the run between rows (`engine::Run::interpolate`),
//! `engine::Readings` evaluates the measured quantity, and the difference goes into the series. Long records take several
//! frames (`MeasuredData::lags`).

mod curves;
pub(crate) mod data;
mod outline;
mod points;
mod residuals;

pub use curves::{CurveAxis, MeasuredCurve};
pub(crate) use curves::{axis, clock};

use crate::records::Records;
use data::{Measured, Outline, Residuals};
use play::{Follows, PlotId};
use program::Model;

/// Measured columns beside the model. They are drawn into plots and the scene of the simulation, which the operations
/// get passed.
#[derive(Debug)]
pub struct MeasuredData {
    /// The columns in use of all records that are drawn.
    columns: Vec<Measured>,
    /// State of the residuals, one per column.
    residuals: Vec<Residuals>,
    /// The plot of the residuals.
    plot: PlotId,
    /// The outline: the scene drawn with measured values.
    outline: Option<(Outline, Vec<Follows>)>,
    /// Incremented whenever points or residuals are replaced, as opposed to appended.
    version: u64,
}

impl MeasuredData {
    /// No columns yet. `plot`: the plot of the residuals.
    pub(crate) fn new(plot: PlotId) -> Self {
        Self { columns: Vec::new(), residuals: Vec::new(), plot, outline: None, version: 0 }
    }

    /// The plot of the residuals.
    pub fn residual_plot(&self) -> PlotId {
        self.plot
    }

    /// Sets the id of the plot of the residuals, which follows the plots of the document.
    pub(crate) fn move_plot(&mut self, plot: PlotId) {
        self.plot = plot;
    }

    /// True if a measured quantity is drawn.
    pub fn has_points(&self) -> bool {
        !self.columns.is_empty()
    }

    /// Record and row of a measured value: id of the record, index of the row in its table. `column`: number of the column
    /// among all that are drawn; `place`: index of the value.
    pub(crate) fn row_of(&self, records: &Records, model: &Model, column: usize, place: usize) -> Option<(u32, usize)> {
        let measured = self.columns.get(column)?;
        let row = records.get(measured.record)?.row_of(measured.column, &model.independent.name, place)?;
        Some((measured.record, row))
    }

    /// Version of a series of points or residuals for [`figure::Series`], by its index in the plot. 0 for series
    /// without one.
    fn version_of(&self, series: usize) -> u64 {
        // Series from this number on have no version and are scanned in full for each frame.
        const MOST: u64 = 64;
        let series = series as u64 + 1;
        if series < MOST { self.version * MOST + series } else { 0 }
    }
}
