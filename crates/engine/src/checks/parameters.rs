//! The parameters that a check supposes, and what follows from them before the run.

use crate::{Readings, Setup};
use program::{Assignment, Model, NodeId, Program};

/// The document's own parameters with those set that a check supposes; each is computed from those before it.
pub fn supposed(program: &Program, setup: &[Assignment]) -> Vec<f64> {
    let mut parameters = Setup::of(program).parameters;
    for assignment in setup {
        let value = at_start(&program.model, &parameters, assignment.value.node);
        if let Some(parameter) = parameters.get_mut(assignment.parameter) {
            *parameter = value;
        }
    }
    parameters
}

/// What does not change during a run with these parameters.
pub(super) fn at_start(model: &Model, parameters: &[f64], node: NodeId) -> f64 {
    let nodes: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
    let zeros = vec![0.0; nodes.len()];
    let initial = Readings::new(model, &nodes).at(parameters, &zeros, 0.0, &zeros).to_vec();
    let mut readings = Readings::new(model, &[node]);
    readings.at(parameters, &initial, 0.0, &initial).first().copied().unwrap_or(f64::NAN)
}
