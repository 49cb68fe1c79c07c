//! What a run is started with.

use crate::{Method, RunError, fixed};
use model::Model;
use units::{Words, words};

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
        let refuse = |code, message: Words, span, hint: Words| {
            Err(RunError::at_start(code, message).with_hint(hint).with_span(span))
        };
        let states = model.states.len();
        if self.parameters.len() != model.parameters.len() {
            let (given, needed) = (self.parameters.len(), model.parameters.len());
            let message = words!(
                "{given} parameters given, the model has {needed}",
                "se dieron {given} parámetros y el modelo tiene {needed}"
            );
            let hint = words("give one value for each parameter", "da un valor para cada parámetro");
            return refuse("wrong-parameters", message, None, hint);
        }
        if let Some(index) = self.parameters.iter().position(|value| !value.is_finite()) {
            let parameter = &model.parameters[index];
            let message = words!(
                "the parameter {} is not a finite number",
                "el parámetro {} no es un número finito",
                parameter.name
            );
            let hint = words("give it a value", "dale un valor");
            return refuse("parameter-not-finite", message, Some(parameter.span), hint);
        }
        if let Some(start) = self.start.as_ref().filter(|start| start.len() != states) {
            let given = start.len();
            let message = words!(
                "{given} start values given, the model has {states} states",
                "se dieron {given} valores iniciales y el modelo tiene {states} estados"
            );
            let hint = words("give one value for each state", "da un valor para cada estado");
            return refuse("wrong-start", message, None, hint);
        }
        if !(self.step > 0.0 && self.step < Setup::GREATEST_STEP) {
            let message =
                words("the step is not a positive, finite number", "el paso no es un número positivo y finito");
            let hint = words("the usual step is 0.05 s", "el paso habitual es 0,05 s");
            return refuse("step-not-positive", message, None, hint);
        }
        if self.method.adaptive() && !(self.tolerance >= Setup::LEAST_TOLERANCE && self.tolerance < 1.0) {
            let least = units::number::shortest(Setup::LEAST_TOLERANCE);
            let message =
                words!("the tolerance is not between {least} and 1", "la tolerancia no está entre {least} y 1");
            let hint = words("the usual tolerance is 1e-6", "la tolerancia habitual es 1e-6");
            return refuse("bad-tolerance", message, None, hint);
        }
        if self.method == Method::VelocityVerlet
            && let Some(state) = fixed::not_of_second_order(model).and_then(|first| model.states.get(first))
        {
            let order = model.states.iter().filter(|other| other.variable == state.variable).count();
            let message = words!(
                "velocity-verlet is for equations of second order; that for {} is of order {order}",
                "velocity-verlet es para ecuaciones de segundo orden; la de {} es de orden {order}",
                state.variable
            );
            let hint = words("use the method `rk4`", "usa el método `rk4`");
            return refuse("not-second-order", message, Some(state.span), hint);
        }
        Ok(())
    }
}

/// The initial values are finite.
pub(crate) fn check_initial(model: &Model, initial: &[f64]) -> Result<(), RunError> {
    match model.states.iter().zip(initial).find(|(_, value)| !value.is_finite()) {
        None => Ok(()),
        Some((state, _)) => {
            let message = words!(
                "the initial value of {} is not a finite number",
                "el valor inicial de {} no es un número finito",
                state.name()
            );
            let hint = words("change the parameters it depends on", "cambia los parámetros de los que depende");
            Err(RunError::at_start("initial-not-finite", message).with_hint(hint).with_span(Some(state.span)))
        }
    }
}
