//! Checks before a run starts.

use crate::methods::fixed;
use crate::{Cause, Method, RunError, Setup};
use program::Model;

/// Checks that a run of `model` can start with this setup.
pub(crate) fn check(setup: &Setup, model: &Model) -> Result<(), RunError> {
    let (parameters, states) = (model.parameters.len(), model.states.len());
    let start = setup.start.as_ref().map_or(states, Vec::len);
    let cause = if setup.parameters.len() != parameters {
        Cause::WrongParameters(setup.parameters.len(), parameters)
    } else if let Some(index) = setup.parameters.iter().position(|value| !value.is_finite()) {
        Cause::ParameterNotFinite(index)
    } else if start != states {
        Cause::WrongStart(start, states)
    } else if !(setup.step > 0.0 && setup.step < Setup::GREATEST_STEP) {
        Cause::StepNotPositive
    } else if setup.method.adaptive() && !(setup.tolerance >= Setup::LEAST_TOLERANCE && setup.tolerance < 1.0) {
        Cause::BadTolerance
    } else if setup.method == Method::VelocityVerlet
        && let Some(first) = fixed::not_of_second_order(model)
    {
        Cause::NotSecondOrder(first)
    } else {
        return Ok(());
    };
    Err(RunError::at_start(cause))
}
/// Checks that the initial values, one per state, are finite.
pub(crate) fn check_initial(initial: &[f64]) -> Result<(), RunError> {
    match initial.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => Err(RunError::at_start(Cause::InitialNotFinite(index))),
    }
}
