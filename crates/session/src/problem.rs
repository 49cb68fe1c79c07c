//! Why a run cannot start or go on, in the session's language.

use crate::Session;
use crate::symbol::symbol;
use engine::{Method, RunError};
use model::Span;
use units::Language;

/// Why the run cannot go on, in the session's language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// A stable name.
    pub code: &'static str,
    /// What is wrong, a sentence.
    pub message: String,
    /// What to do; may be empty.
    pub hint: String,
    /// Where in the document's source, if there is a place.
    pub span: Option<Span>,
}

impl Session {
    /// Why the run cannot go on; only while the moment where it stopped is shown.
    pub fn problem(&self) -> Option<Problem> {
        let error = self.course.error().filter(|_| !self.course.is_scrubbed())?;
        let (message, hint) = match self.language {
            Language::English => (error.message.clone(), error.hint.clone().unwrap_or_default()),
            Language::Spanish => self.spanish(error),
        };
        Some(Problem {
            code: error.code,
            message: sentence(&message, error.code == "not-finite"),
            hint: sentence(&hint, false),
            span: error.span,
        })
    }

    /// Message and hint in Spanish; the engine's own words for what has none.
    fn spanish(&self, error: &RunError) -> (String, String) {
        let at = self.time_words(error.time);
        let state = self.state_at(error.span);
        let (message, hint) = match error.code {
            "not-finite" => (
                format!("{state} deja de ser un número finito después de {at}"),
                match self.course.begun().method {
                    Method::Rosenbrock => {
                        "busca en las ecuaciones una división entre cero o la raíz de un número negativo"
                    }
                    Method::DormandPrince => "si allí no se divide entre cero, puede ayudar el método de Rosenbrock",
                    _ => "si allí no se divide entre cero, puede ayudar un paso menor",
                },
            ),
            "singular-equations" => (
                format!("las ecuaciones no tienen solución única para las derivadas más altas después de {at}"),
                "el determinante de las masas o los coeficientes se anula allí",
            ),
            "step-too-small" => (
                format!("ningún paso desde {at} es bastante pequeño para la tolerancia"),
                "la solución no es suave allí, o crece sin límite",
            ),
            "too-many-steps" => (
                format!("hacen falta demasiados pasos para una fila en {at}"),
                "las ecuaciones son rígidas; el método de Rosenbrock está hecho para ellas",
            ),
            "too-many-events" => (
                format!("hay demasiados sucesos en un paso en {at}"),
                "los sucesos se siguen cada vez más deprisa, como los últimos botes de una pelota",
            ),
            "initial-not-finite" => (
                format!("el valor inicial de {state} no es un número finito"),
                "cambia los parámetros de los que depende",
            ),
            "not-second-order" => (
                "el método de Verlet solo sirve para ecuaciones de segundo orden".to_owned(),
                "usa el método de Runge-Kutta",
            ),
            "step-not-positive" => ("el paso no es un número positivo".to_owned(), "lo habitual son 0,05 s"),
            "bad-tolerance" => ("la tolerancia no está entre 0 y 1".to_owned(), "lo habitual es 1e-6"),
            "unknown-method" => {
                let named = self.document.method.as_deref().unwrap_or_default();
                (format!("no hay ningún método «{named}»"), "elige uno de la lista")
            }
            _ => {
                return (error.message.clone(), error.hint.clone().unwrap_or_default());
            }
        };
        (message, hint.to_owned())
    }

    /// The symbol of the state whose initial value stands at a place.
    fn state_at(&self, span: Option<Span>) -> String {
        let state = self.model().states.iter().find(|state| Some(state.span) == span);
        state.map_or_else(String::new, |state| symbol(&state.name()))
    }
}

/// With a full stop, and with a capital letter unless it begins with a name.
fn sentence(text: &str, named: bool) -> String {
    let mut characters = text.chars();
    match characters.next() {
        None => String::new(),
        Some(_) if named => format!("{text}."),
        Some(first) => format!("{}{}.", first.to_uppercase(), characters.as_str()),
    }
}
