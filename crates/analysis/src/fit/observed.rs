//! Measured and fitted values of one column, inside and outside the fitted part.

use serde::{Deserialize, Serialize};
use units::Unit;

/// Fit of one observation, SI. All columns have equal length: one entry per measured value that is no gap, in the order of
/// time.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ObservationFit {
    /// Index in [`super::Task::records`].
    pub record: usize,
    /// Index of the observation in its record.
    pub observation: usize,
    /// Name of the observation, for example `y'`.
    pub name: String,
    /// Display unit.
    pub unit: Unit,
    /// True if the column was computed from another one.
    pub derived: bool,
    /// Readings of the clock.
    pub times: Vec<f64>,
    /// Measured values.
    pub measured: Vec<f64>,
    /// Values of the model; NaN where it has none.
    pub fitted: Vec<f64>,
    /// True for values that were fitted.
    pub inside: Vec<bool>,
    /// True for values that a person has left out.
    pub excluded: Vec<bool>,
    /// Number of leading rows before the initial values of the equations of motion: the model predicts nothing there.
    pub early: usize,
    /// Root mean square of measured minus fitted in the fitted part, SI.
    pub rmse: f64,
    /// Coefficient of determination in the fitted part; NaN if all measured values there are equal.
    pub r2: f64,
    /// Prediction error outside the fitted part; `None` if no value lies there.
    pub outside: Option<Outside>,
}

/// Prediction error over a part of the rows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outside {
    /// Number of values.
    pub n: usize,
    /// Root mean square of measured minus predicted, SI.
    pub rmse: f64,
}

impl Outside {
    /// Combines several parts: sum of the counts, root mean square over all values.
    pub fn together(parts: impl Iterator<Item = Self>) -> Self {
        let (n, squares) =
            parts.fold((0, 0.0), |(n, squares), part| (n + part.n, squares + part.n as f64 * part.rmse * part.rmse));
        Self { n, rmse: (squares / n.max(1) as f64).sqrt() }
    }
}

impl ObservationFit {
    /// Number of values and root mean square of measured minus fitted in a part of the rows. `wanted` takes the time of a
    /// row and true if the row is in the fitted part. Rows before the initial values and excluded ones are left out.
    pub fn error_where(&self, wanted: impl Fn(f64, bool) -> bool) -> Outside {
        let part = self.residuals_where(wanted);
        let squares = part.iter().fold(0.0, |sum, residual| sum + residual * residual);
        Outside { n: part.len(), rmse: (squares / part.len().max(1) as f64).sqrt() }
    }

    /// Measured minus fitted (SI), one per value of the fitted part.
    pub(super) fn inside_residuals(&self) -> Vec<f64> {
        self.residuals_where(|_, inside| inside)
    }

    fn residuals_where(&self, wanted: impl Fn(f64, bool) -> bool) -> Vec<f64> {
        let rows = self.times.iter().zip(&self.inside).zip(self.measured.iter().zip(&self.fitted)).zip(&self.excluded);
        rows.skip(self.early)
            .filter(|(((time, inside), _), excluded)| !**excluded && wanted(**time, **inside))
            .map(|((_, (measured, fitted)), _)| measured - fitted)
            .collect()
    }

    /// Appends the rows before the initial values, as (time, value), without fitted values. Call it first.
    pub(super) fn add_early(&mut self, rows: &[(f64, f64)]) {
        self.early = rows.len();
        for &(time, value) in rows {
            self.times.push(time);
            self.measured.push(value);
            self.fitted.push(f64::NAN);
            self.inside.push(false);
            self.excluded.push(false);
        }
    }

    /// Computes `rmse`, `r2` and `outside` from the columns.
    pub(super) fn summarise(&mut self) {
        let residuals = self.inside_residuals();
        let squares = residuals.iter().fold(0.0, |sum, residual| sum + residual * residual);
        let measured = || self.measured.iter().zip(&self.inside).filter(|(_, inside)| **inside).map(|(value, _)| value);
        let count = residuals.len().max(1) as f64;
        let mean = measured().sum::<f64>() / count;
        let spread: f64 = measured().map(|value| (value - mean) * (value - mean)).sum();
        self.rmse = (squares / count).sqrt();
        self.r2 = if spread > 0.0 { 1.0 - squares / spread } else { f64::NAN };
        self.outside = Some(self.error_where(|_, inside| !inside)).filter(|part| part.n > 0);
    }
}
