//! Expressions evaluated along a run.

use crate::{History, Routine};
use program::{Model, NodeId};

/// A set of expressions evaluated at rows or states of a run. Changed parameters are taken into account.
#[derive(Clone, Debug)]
pub struct Readings {
    routine: Routine,
    values: Vec<f64>,
    state: Vec<f64>,
    /// Parameters of the last preparation of the routine.
    parameters: Vec<f64>,
    initial: Vec<f64>,
    prepared: bool,
}

impl Readings {
    /// Compiles `roots`, nodes of the model's graph.
    pub fn new(model: &Model, roots: &[NodeId]) -> Self {
        Self {
            routine: Routine::compile(model, roots),
            values: vec![0.0; roots.len()],
            state: vec![0.0; model.states.len()],
            parameters: Vec::new(),
            initial: Vec::new(),
            prepared: false,
        }
    }

    /// Values at a recorded row, one per root, SI units.
    pub fn at_row(&mut self, history: &History, row: usize) -> &[f64] {
        self.prepare(history.parameters(row), history.initial());
        history.state(row, &mut self.state);
        self.routine.evaluate(history.time(row), &self.state, &mut self.values);
        &self.values
    }

    /// Values at any state, one per root; arguments and values in SI units.
    pub fn at(&mut self, parameters: &[f64], initial: &[f64], time: f64, state: &[f64]) -> &[f64] {
        self.prepare(parameters, initial);
        self.routine.evaluate(time, state, &mut self.values);
        &self.values
    }

    fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        if self.prepared && self.parameters == parameters && self.initial == initial {
            return;
        }
        self.parameters.clear();
        self.parameters.extend_from_slice(parameters);
        self.initial.clear();
        self.initial.extend_from_slice(initial);
        self.prepared = true;
        self.routine.prepare(parameters, initial);
    }
}
