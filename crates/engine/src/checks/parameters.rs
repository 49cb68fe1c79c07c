//! Parameters of a check, and values known before its run.

use crate::{Readings, Setup};
use program::{Assignment, Model, NodeId, Program, Question};

/// The parameters of the document with the assignments of a check applied in order, one value per parameter, SI units.
pub fn supposed(program: &Program, setup: &[Assignment]) -> Vec<f64> {
    let mut parameters = Setup::of(program).parameters;
    assign(&program.model, &mut parameters, setup);
    parameters
}

/// Sets parameters (SI units) one after the other: each value follows from the parameters, and the initial values that they give, as the
/// assignments before it have left them.
pub fn assign(model: &Model, parameters: &mut [f64], assignments: &[Assignment]) {
    for assignment in assignments {
        let value = at_start(model, parameters, assignment.value.node);
        if let Some(parameter) = parameters.get_mut(assignment.parameter) {
            *parameter = value;
        }
    }
}

/// Right answer of a question with the parameters of the document and those that it assumes, SI units; NaN for a question without a
/// number.
pub fn answer(program: &Program, question: &Question) -> f64 {
    let supposed = supposed(program, &question.setup);
    question.number().map_or(f64::NAN, |asked| at_start(&program.model, &supposed, asked.right.node))
}

/// Value of a node that is constant during a run with these parameters, SI units.
pub(super) fn at_start(model: &Model, parameters: &[f64], node: NodeId) -> f64 {
    let nodes: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
    let zeros = vec![0.0; nodes.len()];
    let initial = Readings::new(model, &nodes).at(parameters, &zeros, 0.0, &zeros).to_vec();
    let mut readings = Readings::new(model, &[node]);
    readings.at(parameters, &initial, 0.0, &initial).first().copied().unwrap_or(f64::NAN)
}
