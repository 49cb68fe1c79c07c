//! The words of the errors of a run: names and places in the document.

use crate::adaptive::Stuck;
use crate::{Method, RunError, Setup, fixed, number};
use model::{Model, Span};

/// Names and places of a model's states and events.
#[derive(Clone, Debug)]
pub(crate) struct Places {
    states: Vec<(String, Span)>,
    events: Vec<Span>,
    independent: String,
    unit: units::Unit,
    method: Method,
}

impl Places {
    pub fn new(model: &Model, method: Method) -> Self {
        Self {
            states: model
                .states
                .iter()
                .map(|state| (state.name(), state.span))
                .collect(),
            events: model.events.iter().map(|event| event.span).collect(),
            independent: model.independent.name.clone(),
            unit: model.independent.unit.clone(),
            method,
        }
    }

    /// `t = 3.2 s`
    fn moment(&self, time: f64) -> String {
        let value = number::shortest(self.unit.from_si(time));
        let text = format!("{} = {value} {}", self.independent, self.unit);
        text.trim_end().to_owned()
    }

    fn error(&self, code: &'static str, message: String, time: f64) -> RunError {
        RunError {
            code,
            message,
            time,
            span: None,
            hint: None,
        }
    }

    /// A state that is not finite after a step that started at `time`.
    pub fn not_finite(&self, time: f64, state: &[f64], singular: bool) -> RunError {
        let first = state
            .iter()
            .position(|value| !value.is_finite())
            .unwrap_or_default();
        let (name, span) = self.states.get(first).cloned().unwrap_or_default();
        let moment = self.moment(time);
        let (code, message, hint) = if singular {
            let message = format!(
                "the equations have no unique solution for the highest derivatives after {moment}"
            );
            (
                "singular-equations",
                message,
                "the determinant of the masses or coefficients has become zero there",
            )
        } else {
            let overflows = state.get(first).is_some_and(|value| value.is_infinite());
            let fate = if overflows {
                "grows beyond all numbers"
            } else {
                "is not a number any more"
            };
            let hint = match self.method {
                Method::Rosenbrock => {
                    "check the equations for a division by zero or a root of a negative number"
                }
                Method::DormandPrince => {
                    "if nothing is divided by zero there, the method `rosenbrock` may help"
                }
                _ => "if nothing is divided by zero there, a smaller step may help",
            };
            ("not-finite", format!("{name} {fate} after {moment}"), hint)
        };
        RunError {
            span: Some(span),
            hint: Some(hint.to_owned()),
            ..self.error(code, message, time)
        }
    }

    /// An adaptive method that cannot go on from `time`.
    pub fn stuck(&self, stuck: Stuck, time: f64, attempt: &[f64], singular: bool) -> RunError {
        if stuck == Stuck::NotFinite {
            return self.not_finite(time, attempt, singular);
        }
        let message = format!(
            "no step from {} is small enough for the tolerance",
            self.moment(time)
        );
        let hint = "the solution is not smooth there, or grows beyond all bounds";
        RunError {
            span: self.states.first().map(|(_, span)| *span),
            hint: Some(hint.to_owned()),
            ..self.error("step-too-small", message, time)
        }
    }

    /// Too much work for one row.
    pub fn too_many_steps(&self, limit: usize, time: f64) -> RunError {
        let message = format!(
            "{limit} steps were not enough for one row, at {}",
            self.moment(time)
        );
        let hint = match self.method {
            Method::Rosenbrock => "a larger tolerance or rows at shorter distances may help",
            _ => "the equations are stiff; the method `rosenbrock` is made for them",
        };
        RunError {
            span: self.states.first().map(|(_, span)| *span),
            hint: Some(hint.to_owned()),
            ..self.error("too-many-steps", message, time)
        }
    }

    /// Events without end.
    pub fn too_many_events(&self, limit: usize, event: Option<usize>, time: f64) -> RunError {
        let message = format!(
            "more than {limit} events in one step, at {}",
            self.moment(time)
        );
        let hint = "the events follow one another ever faster, like the last bounces of a ball; \
                    let an event end the motion, or stop before";
        RunError {
            span: event.and_then(|event| self.events.get(event).copied()),
            hint: Some(hint.to_owned()),
            ..self.error("too-many-events", message, time)
        }
    }
}

/// Whether a run can start with `setup`.
pub(crate) fn check(model: &Model, setup: &Setup) -> Result<(), RunError> {
    let refuse = |code, message: String, span, hint: &str| {
        Err(RunError {
            code,
            message,
            time: 0.0,
            span,
            hint: Some(hint.to_owned()),
        })
    };
    let states = model.states.len();
    if setup.parameters.len() != model.parameters.len() {
        let message = format!(
            "{} parameters given, the model has {}",
            setup.parameters.len(),
            model.parameters.len()
        );
        return refuse(
            "wrong-parameters",
            message,
            None,
            "give one value for each parameter",
        );
    }
    if let Some(index) = setup.parameters.iter().position(|value| !value.is_finite()) {
        let parameter = &model.parameters[index];
        let message = format!("the parameter {} is not a finite number", parameter.name);
        return refuse(
            "parameter-not-finite",
            message,
            Some(parameter.span),
            "give it a value",
        );
    }
    if let Some(start) = setup.start.as_ref().filter(|start| start.len() != states) {
        let message = format!(
            "{} start values given, the model has {states} states",
            start.len()
        );
        return refuse(
            "wrong-start",
            message,
            None,
            "give one value for each state",
        );
    }
    if !(setup.step > 0.0 && setup.step.is_finite()) {
        let message = "the step is not a positive number".to_owned();
        return refuse(
            "step-not-positive",
            message,
            None,
            "the usual step is 0.05 s",
        );
    }
    if setup.method.adaptive()
        && !(setup.tolerance >= Setup::LEAST_TOLERANCE && setup.tolerance < 1.0)
    {
        let message = format!(
            "the tolerance is not between {} and 1",
            number::shortest(Setup::LEAST_TOLERANCE)
        );
        return refuse(
            "bad-tolerance",
            message,
            None,
            "the usual tolerance is 1e-6",
        );
    }
    if setup.method == Method::VelocityVerlet
        && let Some(state) =
            fixed::not_of_second_order(model).and_then(|first| model.states.get(first))
    {
        let order = model
            .states
            .iter()
            .filter(|other| other.variable == state.variable)
            .count();
        let message = format!(
            "velocity-verlet is for equations of second order; that for {} is of order {order}",
            state.variable
        );
        return refuse(
            "not-second-order",
            message,
            Some(state.span),
            "use the method `rk4`",
        );
    }
    Ok(())
}

/// The initial values are finite.
pub(crate) fn check_initial(model: &Model, initial: &[f64]) -> Result<(), RunError> {
    match model
        .states
        .iter()
        .zip(initial)
        .find(|(_, value)| !value.is_finite())
    {
        None => Ok(()),
        Some((state, _)) => Err(RunError {
            code: "initial-not-finite",
            message: format!(
                "the initial value of {} is not a finite number",
                state.name()
            ),
            time: 0.0,
            span: Some(state.span),
            hint: Some("change the parameters it depends on".to_owned()),
        }),
    }
}
