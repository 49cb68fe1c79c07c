//! The words of the errors of a run: names and places in the document.

use crate::adaptive::Stuck;
use crate::{Method, RunError};
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
            states: model.states.iter().map(|state| (state.name(), state.span)).collect(),
            events: model.events.iter().map(|event| event.span).collect(),
            independent: model.independent.name.clone(),
            unit: model.independent.unit.clone(),
            method,
        }
    }

    /// `t = 3.2 s`
    fn moment(&self, time: f64) -> String {
        let value = units::number::shortest(self.unit.from_si(time));
        let text = format!("{} = {value} {}", self.independent, self.unit);
        text.trim_end().to_owned()
    }

    fn error(&self, code: &'static str, message: String, time: f64) -> RunError {
        RunError { code, message, time, span: None, hint: None }
    }

    /// A state that is not finite after a step that started at `time`.
    pub fn not_finite(&self, time: f64, state: &[f64], singular: bool) -> RunError {
        let first = state.iter().position(|value| !value.is_finite()).unwrap_or_default();
        let (name, span) = self.states.get(first).cloned().unwrap_or_default();
        let moment = self.moment(time);
        let (code, message, hint) = if singular {
            let message = format!("the equations have no unique solution for the highest derivatives after {moment}");
            ("singular-equations", message, "the determinant of the masses or coefficients has become zero there")
        } else {
            let overflows = state.get(first).is_some_and(|value| value.is_infinite());
            let fate = if overflows { "grows beyond all numbers" } else { "is not a number any more" };
            let hint = match self.method {
                Method::Rosenbrock => "check the equations for a division by zero or a root of a negative number",
                Method::DormandPrince => "if nothing is divided by zero there, the method `rosenbrock` may help",
                _ => "if nothing is divided by zero there, a smaller step may help",
            };
            ("not-finite", format!("{name} {fate} after {moment}"), hint)
        };
        RunError { span: Some(span), hint: Some(hint.to_owned()), ..self.error(code, message, time) }
    }

    /// An adaptive method that cannot go on from `time`.
    pub fn stuck(&self, stuck: Stuck, time: f64, attempt: &[f64], singular: bool) -> RunError {
        if stuck == Stuck::NotFinite {
            return self.not_finite(time, attempt, singular);
        }
        let message = format!("no step from {} is small enough for the tolerance", self.moment(time));
        let hint = "the solution is not smooth there, or grows beyond all bounds";
        RunError {
            span: self.states.first().map(|(_, span)| *span),
            hint: Some(hint.to_owned()),
            ..self.error("step-too-small", message, time)
        }
    }

    /// Too much work for one row.
    pub fn too_many_steps(&self, limit: usize, time: f64) -> RunError {
        let message = format!("{limit} steps were not enough for one row, at {}", self.moment(time));
        let hint = match self.method {
            Method::Rosenbrock => "a larger tolerance or rows at shorter distances may help",
            _ => "if the equations are stiff, the method `rosenbrock` is made for them",
        };
        RunError {
            span: self.states.first().map(|(_, span)| *span),
            hint: Some(hint.to_owned()),
            ..self.error("too-many-steps", message, time)
        }
    }

    /// Events without end.
    pub fn too_many_events(&self, limit: usize, event: Option<usize>, time: f64) -> RunError {
        let message = format!("more than {limit} events in one step, at {}", self.moment(time));
        let hint = "the events follow one another ever faster, like the last bounces of a ball; \
                    let an event end the motion, or stop before";
        RunError {
            span: event.and_then(|event| self.events.get(event).copied()),
            hint: Some(hint.to_owned()),
            ..self.error("too-many-events", message, time)
        }
    }
}
