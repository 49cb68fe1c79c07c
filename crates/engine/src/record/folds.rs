//! Numbers of a whole run, taken row by row: maximum, minimum, mean, integral.

use super::history::History;
use super::readings::Readings;
use crate::methods::stepper::ROUNDING;
use program::{Aggregate, AggregateKind};

/// Intermediate results of aggregates of one run.
#[derive(Clone, Debug, Default)]
pub struct Folds {
    folds: Vec<Fold>,
    /// Time (SI) and operands at the previous row.
    before: Option<(f64, Vec<f64>)>,
}

/// Intermediate result of an aggregate.
#[derive(Clone, Copy, Debug, Default)]
struct Fold {
    value: Option<f64>,
    /// Duration over which the integral has been taken, SI.
    duration: f64,
}

impl Folds {
    /// Before the first row.
    pub fn new(aggregates: &[Aggregate]) -> Self {
        Self { folds: vec![Fold::default(); aggregates.len()], before: None }
    }

    /// Takes the next row: its time (SI), and the operands of the aggregates there.
    pub fn take(&mut self, aggregates: &[Aggregate], time: f64, operands: &[f64]) {
        for (number, (fold, of)) in self.folds.iter_mut().zip(aggregates).enumerate() {
            let before = self.before.as_ref().and_then(|(time, values)| Some((*time, *values.get(number)?)));
            if let Some(value) = operands.get(number) {
                fold.take(of, before, time, *value);
            }
        }
        match &mut self.before {
            Some((before, values)) => {
                *before = time;
                values.clear();
                values.extend_from_slice(operands);
            }
            none => *none = Some((time, operands.to_vec())),
        }
    }

    /// Values of `readings` (SI) at the last row of a run up to `until` (SI), with the aggregates as further parameters; NaN for
    /// an aggregate that has not begun to count. `None` if there is no such row.
    pub fn values_at_end<'a>(
        &self,
        aggregates: &[Aggregate],
        readings: &'a mut Readings,
        history: &History,
        until: f64,
    ) -> Option<&'a [f64]> {
        let last = until * (1.0 + ROUNDING);
        let row = (0..history.len()).rev().find(|row| history.time(*row) <= last)?;
        let mut state = vec![0.0; history.states()];
        history.state(row, &mut state);
        let begun = [history.parameters(row), history.initial()];
        Some(self.values(aggregates, readings, begun, (history.time(row), &state)))
    }

    /// Values of `readings` (SI) at the last row of a run, its time and state, as [`Folds::values_at_end`]. `begun`: parameters and
    /// initial values of the run. All in SI units.
    pub fn values<'a>(
        &self,
        aggregates: &[Aggregate],
        readings: &'a mut Readings,
        [parameters, initial]: [&[f64]; 2],
        (time, state): (f64, &[f64]),
    ) -> &'a [f64] {
        if self.folds.is_empty() {
            return readings.at(parameters, initial, time, state);
        }
        let parameters: Vec<f64> = parameters.iter().copied().chain(self.results(aggregates)).collect();
        readings.at(&parameters, initial, time, state)
    }

    /// Result of each aggregate, SI units; NaN for one that has not begun to count.
    pub fn results(&self, aggregates: &[Aggregate]) -> impl Iterator<Item = f64> {
        self.folds.iter().zip(aggregates).map(|(fold, of)| fold.result(of))
    }
}

impl Fold {
    /// Adds the value at `time` (SI); `before` holds time and value at the previous row.
    fn take(&mut self, of: &Aggregate, before: Option<(f64, f64)>, time: f64, value: f64) {
        if time < of.from {
            return;
        }
        match of.kind {
            AggregateKind::Maximum => self.value = Some(self.value.map_or(value, |greatest| greatest.max(value))),
            AggregateKind::Minimum => self.value = Some(self.value.map_or(value, |least| least.min(value))),
            // Trapezoidal rule; the spacing of the rows may vary.
            AggregateKind::Mean | AggregateKind::Integral => {
                let Some((start, first)) = before.filter(|(start, _)| *start >= of.from) else { return };
                let area = (time - start) * (first + value) / 2.0;
                self.value = Some(self.value.unwrap_or(0.0) + area);
                self.duration += time - start;
            }
        }
    }

    fn result(self, of: &Aggregate) -> f64 {
        match (self.value, of.kind) {
            (Some(area), AggregateKind::Mean) => area / self.duration,
            (value, _) => value.unwrap_or(f64::NAN),
        }
    }
}
