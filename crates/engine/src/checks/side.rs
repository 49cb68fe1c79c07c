//! A run with expressions evaluated at its rows.

use crate::{Advance, Readings, Routine, Run, RunError, Setup};
use program::{Model, NodeId};

/// History size in bytes above which rows already evaluated are dropped, so that long runs fit in memory.
const HISTORY: usize = 1 << 20;

/// A run with expressions evaluated at its rows.
#[derive(Debug)]
pub(super) struct Side {
    run: Run,
    readings: Readings,
    /// Approximate number of floating-point operations per evaluation.
    cost: u64,
    state: Vec<f64>,
    /// Index of the first row that is not evaluated.
    row: usize,
}

impl Side {
    pub fn start(model: &Model, setup: Setup, roots: &[NodeId]) -> Result<Self, RunError> {
        let readings = Readings::new(model, roots);
        let cost = 8 + Routine::compile(model, roots).work();
        let run = Run::start(model, setup)?;
        Ok(Self { run, readings, cost, state: vec![0.0; model.states.len()], row: 0 })
    }

    /// The time of the last row, SI units.
    pub fn time(&self) -> f64 {
        let history = self.run.history();
        history.time(history.len() - 1)
    }

    /// Advances to the next row and subtracts the cost from `work`. Returns true if the row is reached.
    pub fn advance(&mut self, work: &mut u64) -> Result<bool, RunError> {
        if self.run.history().bytes() > HISTORY && self.row == self.run.history().len() {
            self.run.forget();
            self.row = 1;
        }
        let before = self.run.work();
        let outcome = self.run.advance_within(*work);
        let rows = (self.run.history().len() - self.row) as u64;
        let spent = (self.run.work() - before).saturating_add(rows.saturating_mul(self.cost)).max(1);
        *work = work.saturating_sub(spent);
        match outcome? {
            Advance::Step | Advance::Event => Ok(true),
            Advance::Partial => Ok(false),
            Advance::Full => {
                *work = 0;
                Ok(false)
            }
        }
    }

    /// The next row that is not evaluated: its time and the values of the roots, SI units.
    pub fn next_row(&mut self) -> Option<(f64, &[f64])> {
        let history = self.run.history();
        let row = self.row;
        if row >= history.len() {
            return None;
        }
        self.row += 1;
        Some((history.time(row), self.readings.at_row(history, row)))
    }

    /// Processes the events up to `time`, at most that of the last row. An event that ends the run is reported again by
    /// [`Self::advance`].
    pub fn finish(&mut self, time: f64) {
        let _ = self.run.finish(time);
    }

    /// Values of the roots at `time`, at most that of the last row, after the events of that moment; between two rows from
    /// the interpolated state. SI units.
    pub fn at(&mut self, time: f64) -> &[f64] {
        self.finish(time);
        let last = self.time();
        let time = if last <= time * (1.0 + crate::ROUNDING) { time.max(last) } else { time };
        self.run.interpolate(time, &mut self.state);
        let history = self.run.history();
        let parameters = history.parameters(history.len() - 1);
        self.readings.at(parameters, history.initial(), time, &self.state)
    }
}
