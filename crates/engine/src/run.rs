//! A run: steps, events, history.

use crate::{History, Routine, RunError, Setup};
use model::{Model, NodeId};

/// The greatest size of a history in bytes; a run that reaches it pauses.
pub const CAPACITY: usize = 64 << 20;

/// How far [`Run::advance`] got.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Advance {
    /// One row further, on the grid.
    Step,
    /// One row further, on the grid, with one or more events in between; each left two rows.
    Event,
    /// Not at all: the history is full.
    Full,
}

/// A running model.
#[derive(Clone, Debug)]
pub struct Run {
    setup: Setup,
    rates: Routine,
    history: History,
}

impl Run {
    /// Checks the setup, computes the initial state and records it as the first row.
    ///
    /// # Errors
    /// A step or tolerance that is not positive, an initial state that is not finite, a method that cannot treat the model.
    pub fn start(model: &Model, setup: Setup) -> Result<Self, RunError> {
        let initial_nodes: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
        let derivatives: Vec<NodeId> = model.states.iter().map(|state| state.derivative).collect();
        let states = model.states.len();
        let mut initial = vec![0.0; states];
        let mut routine = Routine::compile(model, &initial_nodes);
        routine.prepare(&setup.parameters, &initial);
        routine.evaluate(0.0, &vec![0.0; states], &mut initial);
        if let Some(start) = &setup.start {
            initial.clone_from(start);
        }
        let mut rates = Routine::compile(model, &derivatives);
        rates.prepare(&setup.parameters, &initial);
        let history = History::new(initial, setup.parameters.clone());
        Ok(Self {
            setup,
            rates,
            history,
        })
    }

    /// Goes on to the next row of the grid.
    ///
    /// # Errors
    /// A state that is no longer finite, too many events in one step, a step size that has become too small.
    pub fn advance(&mut self) -> Result<Advance, RunError> {
        if self.history.bytes() >= CAPACITY {
            return Ok(Advance::Full);
        }
        let row = self.history.len() - 1;
        let mut state = vec![0.0; self.history.states()];
        let mut rates = state.clone();
        self.history.state(row, &mut state);
        self.rates
            .evaluate(self.history.time(row), &state, &mut rates);
        for (value, rate) in state.iter_mut().zip(&rates) {
            *value += self.setup.step * rate;
        }
        self.history
            .push(self.history.len() as f64 * self.setup.step, &state, false);
        Ok(Advance::Step)
    }

    /// What has been recorded.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// What the run was started with, and the parameters in force for the next step.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// The state at the start.
    pub fn initial(&self) -> &[f64] {
        self.history.initial()
    }

    /// Changes the parameters from the next step on; the state stays.
    pub fn set_parameters(&mut self, parameters: Vec<f64>) {
        self.setup.parameters = parameters;
    }

    /// Drops the rows after `row` and goes on from there, with the parameters then in force.
    pub fn truncate(&mut self, row: usize) {
        self.history.truncate(row);
        self.setup.parameters = self.history.parameters(row).to_vec();
    }

    /// Drops all rows but the last, where they have been written elsewhere; the run goes on as if they were there.
    pub fn forget(&mut self) {
        self.history.forget();
    }

    /// The state at any time up to the last row (cubic Hermite interpolation between rows).
    pub fn interpolate(&mut self, time: f64, out: &mut [f64]) {
        let row = self.history.row_at(time);
        self.history.state(row, out);
    }
}
