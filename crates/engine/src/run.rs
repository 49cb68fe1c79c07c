//! A run: a model in motion and the record of it.

use crate::{History, Readings, RunError, Setup, Stepper};
use model::{Model, NodeId};

/// The greatest size of a history in bytes; a run that reaches it pauses.
pub const CAPACITY: usize = 64 << 20;

/// How far [`Run::advance`] got.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Advance {
    /// One row further, on the grid.
    Step,
    /// To the next point of the grid, with one or more events on the way; each left two rows.
    Event,
    /// Not at all: the history is full.
    Full,
}

/// A model in motion and the record of it.
#[derive(Clone, Debug)]
pub struct Run {
    setup: Setup,
    stepper: Stepper,
    history: History,
    rates: Readings,
    /// The states at both ends of an interval.
    ends: [Vec<f64>; 2],
}

impl Run {
    /// Checks the setup, computes the initial state and records it as the first row.
    ///
    /// # Errors
    /// A step or tolerance that is not positive, an initial state that is not finite, a method that cannot treat the model.
    pub fn start(model: &Model, setup: Setup) -> Result<Self, RunError> {
        let stepper = Stepper::new(model, &setup)?;
        let history = History::new(stepper.initial().to_vec(), setup.parameters.clone());
        let rates: Vec<NodeId> = model.states.iter().map(|state| state.derivative).collect();
        let state = stepper.state().to_vec();
        Ok(Self { rates: Readings::new(model, &rates), setup, stepper, history, ends: [state.clone(), state] })
    }

    /// Goes on to the next point of the grid t_n = n h.
    ///
    /// # Errors
    /// A state that is no longer finite, too many events in one step, a step size that has become too small. The rows
    /// recorded before stay.
    pub fn advance(&mut self) -> Result<Advance, RunError> {
        if self.history.bytes() >= CAPACITY {
            return Ok(Advance::Full);
        }
        let history = &mut self.history;
        let events = self.stepper.advance(|time, state, jumped| history.push(time, state, jumped))?;
        Ok(if events == 0 { Advance::Step } else { Advance::Event })
    }

    /// What has been recorded.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// What the run was started with, but with the parameters in force for the next step.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// The state at the start.
    pub fn initial(&self) -> &[f64] {
        self.history.initial()
    }

    /// The independent variable at the last row.
    pub fn time(&self) -> f64 {
        self.stepper.time()
    }

    /// The state at the last row.
    pub fn state(&self) -> &[f64] {
        self.stepper.state()
    }

    /// Changes the parameters from the next step on, one value for each; the state stays.
    pub fn set_parameters(&mut self, parameters: Vec<f64>) {
        if parameters.len() != self.setup.parameters.len() || parameters == self.setup.parameters {
            return;
        }
        self.history.push_parameters(parameters.clone());
        self.setup.parameters.clone_from(&parameters);
        self.stepper.set_parameters(parameters);
    }

    /// Drops the rows after `row` and goes on from there, with the parameters then in force. Of the rows around a jump
    /// the last is kept: what has happened there does not happen again.
    pub fn truncate(&mut self, row: usize) {
        let history = &mut self.history;
        let mut row = row.min(history.len() - 1);
        while row + 1 < history.len() && history.time(row + 1) == history.time(row) {
            row += 1;
        }
        history.truncate(row);
        self.setup.parameters = history.parameters(row).to_vec();
        let after_jump = row > 0 && history.segment(row) != history.segment(row - 1);
        let [state, _] = &mut self.ends;
        history.state(row, state);
        self.stepper.resume(history.time(row), state, self.setup.parameters.clone(), after_jump);
    }

    /// Drops all rows but the last, where they have been written elsewhere; the run goes on as if they were there.
    pub fn forget(&mut self) {
        self.history.forget();
    }

    /// The state at any time up to the last row: between two rows the cubic with the values and slopes of both (Hermite),
    /// and the first or last row outside.
    pub fn interpolate(&mut self, time: f64, out: &mut [f64]) {
        let history = &self.history;
        let row = history.row_at(time);
        history.state(row, out);
        let next = row + 1;
        if next >= history.len() || history.segment(next) != history.segment(row) || time <= history.time(row) {
            return;
        }
        let [from, to] = &mut self.ends;
        history.state(row, from);
        history.state(next, to);
        let (start, end) = (history.time(row), history.time(next));
        let (size, part) = (end - start, (time - start) / (end - start));
        let (parameters, initial) = (history.parameters(next), history.initial());
        out.copy_from_slice(self.rates.at(parameters, initial, start, from));
        let end_rates = self.rates.at(parameters, initial, end, to);
        for (k, value) in out.iter_mut().enumerate() {
            *value = hermite(part, from[k], to[k], size * *value, size * end_rates[k]);
        }
    }
}

/// The cubic with the values `from` and `to` and the slopes `leaving` and `arriving` at 0 and 1. Where the slopes have
/// nothing to do with the change in between, because it went too fast for the rows, the straight line.
fn hermite(part: f64, from: f64, to: f64, leaving: f64, arriving: f64) -> f64 {
    let change = to - from;
    let steepest = leaving.abs().max(arriving.abs());
    let plausible = 10.0 * from.abs().max(to.abs());
    if steepest > plausible || steepest.is_nan() {
        return from + part * change;
    }
    let rest = 1.0 - part;
    from + part * (change + rest * (rest * (leaving - change) - part * (arriving - change)))
}
