//! Values and points that a plot over a parameter takes from a run.

use engine::Folds;
use program::{Sweep, Taken};
use serde::{Deserialize, Serialize};

/// Values taken from a run so far.
#[derive(Clone, Debug)]
pub(super) struct Taking {
    /// Intermediate results of the aggregates.
    pub(super) folds: Folds,
    /// Values at the previous row, for points.
    before: Option<Vec<f64>>,
    /// Points, SI units: one value per curve for each of them.
    pub(super) points: Vec<f64>,
}

/// Values and points of a complete run, SI units. A run that cannot start has neither points nor values.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TakenRun {
    /// One value per curve for each point.
    pub(super) points: Vec<f64>,
    /// One value per curve; empty if the run has failed.
    pub(super) values: Vec<f64>,
}

impl Taking {
    /// Before the first row.
    pub fn new(sweep: &Sweep) -> Self {
        Self { folds: Folds::new(&sweep.aggregates), before: None, points: Vec::new() }
    }

    /// Takes the values read at a row; `time` and values in SI units.
    pub fn take(&mut self, sweep: &Sweep, time: f64, values: &[f64]) {
        if time > sweep.until * (1.0 + engine::ROUNDING) {
            return;
        }
        if sweep.is_of_points() {
            self.add_points(sweep, time, values);
            self.before = Some(values.to_vec());
        } else {
            self.folds.take(&sweep.aggregates, time, values);
        }
    }

    /// Adds one point per curve: the values at this row, or, if an event has fired since the previous row, those of that row.
    fn add_points(&mut self, sweep: &Sweep, time: f64, values: &[f64]) {
        let before = self.before.as_deref();
        let taken = match (sweep.at, before) {
            (None, _) => Some(values),
            (Some(_), Some(before)) if values.last() > before.last() => Some(before),
            (Some(_), _) => None,
        };
        let counts = |taken: &Taken| matches!(taken, Taken::Points(from) if time >= *from);
        let is_full = self.points.len() / sweep.taken.len().max(1) >= Sweep::MOST_POINTS / sweep.count().max(1);
        let Some(values) = taken.filter(|_| !is_full && sweep.taken.iter().any(counts)) else { return };
        let points = sweep.taken.iter().zip(values);
        self.points.extend(points.map(|(taken, value)| if counts(taken) { *value } else { f64::NAN }));
    }
}
