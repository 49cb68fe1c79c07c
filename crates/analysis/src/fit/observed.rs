//! How one measured column was fitted, and how the rest of it was predicted.

use units::Unit;

/// How one observation was fitted. Columns are of equal length: all measured values that are no gap, in the order of time.
#[derive(Clone, Debug)]
pub struct ObservationFit {
    /// Which record.
    pub record: usize,
    /// Which of its observations.
    pub observation: usize,
    /// `y'`
    pub name: String,
    /// The unit to show it in.
    pub unit: Unit,
    /// Whether it was computed from another one.
    pub derived: bool,
    /// The clock's readings.
    pub times: Vec<f64>,
    /// What was measured.
    pub measured: Vec<f64>,
    /// The model's values; NaN where it has none.
    pub fitted: Vec<f64>,
    /// Whether the value was in the fitted part.
    pub inside: Vec<bool>,
    /// How many of the first rows lie before the initial values of the equations of motion, so that nothing is predicted of
    /// them.
    pub early: usize,
    /// The root of the mean square of measured minus fitted in the fitted part.
    pub rmse: f64,
    /// The coefficient of determination in the fitted part.
    pub r2: f64,
    /// What was predicted outside.
    pub outside: Option<Outside>,
}

/// How well the rest of a record was predicted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outside {
    /// How many values.
    pub n: usize,
    /// The root of the mean square of measured minus predicted.
    pub rmse: f64,
}

impl Outside {
    /// Several parts taken together.
    pub fn together(parts: impl Iterator<Item = Self>) -> Self {
        let (n, squares) =
            parts.fold((0, 0.0), |(n, squares), part| (n + part.n, squares + part.n as f64 * part.rmse * part.rmse));
        Self { n, rmse: (squares / n.max(1) as f64).sqrt() }
    }
}

impl ObservationFit {
    /// How many values the model has in a part of the rows, and the root of the mean square of measured minus fitted there;
    /// `wanted` gets the time of a row, and whether it was in the fitted part.
    pub fn error_where(&self, wanted: impl Fn(f64, bool) -> bool) -> Outside {
        let part = self.residuals_where(wanted);
        let squares = part.iter().fold(0.0, |sum, residual| sum + residual * residual);
        Outside { n: part.len(), rmse: (squares / part.len().max(1) as f64).sqrt() }
    }

    /// Measured minus fitted in the fitted part.
    pub(super) fn inside_residuals(&self) -> Vec<f64> {
        self.residuals_where(|_, inside| inside)
    }

    fn residuals_where(&self, wanted: impl Fn(f64, bool) -> bool) -> Vec<f64> {
        let rows = self.times.iter().zip(&self.inside).zip(self.measured.iter().zip(&self.fitted));
        rows.skip(self.early)
            .filter(|((time, inside), _)| wanted(**time, **inside))
            .map(|(_, (measured, fitted))| measured - fitted)
            .collect()
    }

    /// Adds the first rows, of which nothing is predicted: times and values.
    pub(super) fn add_early(&mut self, rows: &[(f64, f64)]) {
        self.early = rows.len();
        for &(time, value) in rows {
            self.times.push(time);
            self.measured.push(value);
            self.fitted.push(f64::NAN);
            self.inside.push(false);
        }
    }

    /// Computes the summary of the columns.
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
