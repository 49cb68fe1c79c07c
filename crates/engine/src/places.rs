//! The errors of a run in words, with names and places in the document.

use crate::adaptive::Stalled;
use crate::{Method, RunError};
use model::{Model, Span};
use units::{Words, words};

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

    /// `t = 3.2 s`; in Spanish `3,2 s`.
    fn moment(&self, time: f64) -> Words {
        let (name, unit) = (&self.independent, &self.unit);
        let value = units::number::shortest(unit.from_si(time));
        let spanish = value.replace('.', ",");
        if unit.text.is_empty() {
            words!("{name} = {value}", "{name} = {spanish}")
        } else {
            words!("{name} = {value} {unit}", "{spanish} {unit}")
        }
    }

    fn error(&self, code: &'static str, message: Words, time: f64) -> RunError {
        RunError { time, ..RunError::at_start(code, message) }
    }

    /// A state that is not finite after a step that started at `time`.
    pub fn not_finite(&self, time: f64, state: &[f64], singular: bool) -> RunError {
        let first = state.iter().position(|value| !value.is_finite()).unwrap_or_default();
        let (name, span) = self.states.get(first).cloned().unwrap_or_default();
        let moment = self.moment(time);
        let error = if singular {
            let message = words!(
                "the equations have no unique solution for the highest derivatives after {moment}",
                "las ecuaciones no tienen solución única para las derivadas de mayor orden después de {moment}",
                moment = moment
            );
            self.error("singular-equations", message, time).with_hint(words(
                "the determinant of the masses or coefficients has become zero there",
                "el determinante de las masas o los coeficientes se anula allí",
            ))
        } else {
            let fate = match state.get(first) {
                Some(value) if value.is_infinite() => words("grows beyond all numbers", "deja de ser un número finito"),
                _ => words("is not a number any more", "deja de ser un número"),
            };
            let message = words!(
                "{name} {fate} after {moment}",
                "{name} {fate} después de {moment}",
                fate = fate,
                moment = moment
            );
            self.error("not-finite", message, time).with_hint(match self.method {
                Method::Rosenbrock => words(
                    "check the equations for a division by zero or a root of a negative number",
                    "busca en las ecuaciones una división entre cero o la raíz de un número negativo",
                ),
                Method::DormandPrince => words(
                    "if nothing is divided by zero there, the method `rosenbrock` may help",
                    "si allí no se divide entre cero, puede ayudar el método `rosenbrock`",
                ),
                _ => words(
                    "if nothing is divided by zero there, a smaller step may help",
                    "si allí no se divide entre cero, puede ayudar un paso menor",
                ),
            })
        };
        error.with_span(Some(span))
    }

    /// An adaptive method that cannot go on from `time`.
    pub fn stalled(&self, stalled: Stalled, time: f64, attempt: &[f64], singular: bool) -> RunError {
        if stalled == Stalled::NotFinite {
            return self.not_finite(time, attempt, singular);
        }
        let message = words!(
            "no step from {moment} is small enough for the tolerance",
            "ningún paso desde {moment} es bastante pequeño para la tolerancia",
            moment = self.moment(time)
        );
        let hint = words(
            "the solution is not smooth there, or grows beyond all bounds",
            "la solución no es suave allí, o crece sin límite",
        );
        self.error("step-too-small", message, time).with_hint(hint).with_span(self.first_state())
    }

    /// Too much work for one row.
    pub fn too_many_steps(&self, limit: usize, time: f64) -> RunError {
        let message = words!(
            "{limit} steps were not enough for one row, at {moment}",
            "{limit} pasos no bastaron para una fila, en {moment}",
            moment = self.moment(time)
        );
        let hint = match self.method {
            Method::Rosenbrock => words(
                "a larger tolerance or rows at shorter distances may help",
                "puede ayudar una tolerancia mayor o filas más próximas",
            ),
            _ => words(
                "if the equations are stiff, the method `rosenbrock` is made for them",
                "si las ecuaciones son rígidas, el método `rosenbrock` está hecho para ellas",
            ),
        };
        self.error("too-many-steps", message, time).with_hint(hint).with_span(self.first_state())
    }

    /// Events without end.
    pub fn too_many_events(&self, limit: usize, event: Option<usize>, time: f64) -> RunError {
        let message = words!(
            "more than {limit} events in one step, at {moment}",
            "más de {limit} eventos en un paso, en {moment}",
            moment = self.moment(time)
        );
        let hint = words(
            "the events follow one another ever faster, like the last bounces of a ball; let an event end the motion, or \
             stop before",
            "los eventos se suceden cada vez más deprisa, como los últimos botes de una pelota; haz que un evento termine \
             el movimiento, o detente antes",
        );
        let span = event.and_then(|event| self.events.get(event).copied());
        self.error("too-many-events", message, time).with_hint(hint).with_span(span)
    }

    fn first_state(&self) -> Option<Span> {
        self.states.first().map(|(_, span)| *span)
    }
}
