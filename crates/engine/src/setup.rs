//! What a run is started with.

use crate::{Method, RunError, fixed};
use model::Model;

/// What a run is started with; all values SI. The independent variable starts at 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// One for each of the model's parameters.
    pub parameters: Vec<f64>,
    /// How to integrate.
    pub method: Method,
    /// The distance of the rows; with methods of fixed step also the step.
    pub step: f64,
    /// The error allowed in each step of an adaptive method, relative to the state.
    pub tolerance: f64,
    /// A state to start from instead of the model's initial values.
    pub start: Option<Vec<f64>>,
}

impl Setup {
    /// The step where the document does not say, in SI units of the independent variable.
    pub const STEP: f64 = 0.05;
    /// The tolerance where the document does not say.
    pub const TOLERANCE: f64 = 1e-6;
    /// Multiples of a greater step could be infinite.
    pub const GREATEST_STEP: f64 = 1e290;
    /// What rounding lets an adaptive method reach.
    pub const LEAST_TOLERANCE: f64 = 1e-14;

    /// The model's own values, the classical Runge-Kutta method and a step of 0.05 s.
    pub fn defaults(model: &Model) -> Self {
        Self {
            parameters: model.parameters.iter().map(|parameter| parameter.value).collect(),
            method: Method::default(),
            step: Self::STEP,
            tolerance: Self::TOLERANCE,
            start: None,
        }
    }

    /// Whether a run of `model` can start with this.
    pub(crate) fn check(&self, model: &Model) -> Result<(), RunError> {
        let refuse = |code, message: String, span, hint: &str| {
            Err(RunError { code, message, time: 0.0, span, hint: Some(hint.to_owned()) })
        };
        let states = model.states.len();
        if self.parameters.len() != model.parameters.len() {
            let message =
                format!("{} parameters given, the model has {}", self.parameters.len(), model.parameters.len());
            return refuse("wrong-parameters", message, None, "give one value for each parameter");
        }
        if let Some(index) = self.parameters.iter().position(|value| !value.is_finite()) {
            let parameter = &model.parameters[index];
            let message = format!("the parameter {} is not a finite number", parameter.name);
            return refuse("parameter-not-finite", message, Some(parameter.span), "give it a value");
        }
        if let Some(start) = self.start.as_ref().filter(|start| start.len() != states) {
            let message = format!("{} start values given, the model has {states} states", start.len());
            return refuse("wrong-start", message, None, "give one value for each state");
        }
        if !(self.step > 0.0 && self.step < Setup::GREATEST_STEP) {
            let message = "the step is not a positive, finite number".to_owned();
            return refuse("step-not-positive", message, None, "the usual step is 0.05 s");
        }
        if self.method.adaptive() && !(self.tolerance >= Setup::LEAST_TOLERANCE && self.tolerance < 1.0) {
            let message =
                format!("the tolerance is not between {} and 1", units::number::shortest(Setup::LEAST_TOLERANCE));
            return refuse("bad-tolerance", message, None, "the usual tolerance is 1e-6");
        }
        if self.method == Method::VelocityVerlet
            && let Some(state) = fixed::not_of_second_order(model).and_then(|first| model.states.get(first))
        {
            let order = model.states.iter().filter(|other| other.variable == state.variable).count();
            let message = format!(
                "velocity-verlet is for equations of second order; that for {} is of order {order}",
                state.variable
            );
            return refuse("not-second-order", message, Some(state.span), "use the method `rk4`");
        }
        Ok(())
    }
}

/// The initial values are finite.
pub(crate) fn check_initial(model: &Model, initial: &[f64]) -> Result<(), RunError> {
    match model.states.iter().zip(initial).find(|(_, value)| !value.is_finite()) {
        None => Ok(()),
        Some((state, _)) => Err(RunError {
            code: "initial-not-finite",
            message: format!("the initial value of {} is not a finite number", state.name()),
            time: 0.0,
            span: Some(state.span),
            hint: Some("change the parameters it depends on".to_owned()),
        }),
    }
}
