//! A run together with what is read along it.

use crate::{Advance, Readings, Routine, Run, RunError, Setup};
use program::{Model, NodeId};

/// Rows beyond so many bytes are dropped when they have been read, so that no run is too long.
const HISTORY: usize = 1 << 20;

/// A run and the values that are read along it.
#[derive(Debug)]
pub(super) struct Side {
    run: Run,
    readings: Readings,
    /// About how many floating-point operations a reading takes.
    cost: u64,
    state: Vec<f64>,
    /// The first row that has not been read.
    row: usize,
}

impl Side {
    pub fn start(model: &Model, setup: Setup, roots: &[NodeId]) -> Result<Self, RunError> {
        let readings = Readings::new(model, roots);
        let cost = 8 + Routine::compile(model, roots).work();
        let run = Run::start(model, setup)?;
        Ok(Self { run, readings, cost, state: vec![0.0; model.states.len()], row: 0 })
    }

    /// The time of the last row.
    pub fn time(&self) -> f64 {
        let history = self.run.history();
        history.time(history.len() - 1)
    }

    /// Goes on to the next row, taking what this costs off `work`. Whether it got there.
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

    /// The next row that has not been read: its time and what is read there.
    pub fn next_row(&mut self) -> Option<(f64, &[f64])> {
        let history = self.run.history();
        let row = self.row;
        if row >= history.len() {
            return None;
        }
        self.row += 1;
        Some((history.time(row), self.readings.at_row(history, row)))
    }

    /// Lets what happens at a time up to the last row happen. An event that ends the run is met again by [`Self::advance`].
    pub fn finish(&mut self, time: f64) {
        let _ = self.run.finish(time);
    }

    /// What is read at a time up to the last row, behind the events of that moment; between two rows from the interpolated
    /// state.
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
