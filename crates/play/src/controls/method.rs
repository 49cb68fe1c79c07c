//! Integration method and step.

use crate::{Basis, Course, Refusal, number, words};
use engine::{Cause, Method, Run, RunError, Setup};

/// A method in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct MethodView {
    /// Name in the engine: `rk4`.
    pub name: &'static str,
    /// Name in the chosen language.
    pub label: String,
    /// True if this method is in use.
    pub selected: bool,
    /// Reason why it cannot integrate this model, in the chosen language; empty if it can.
    pub refused: String,
}

impl Basis {
    /// Reason why a method cannot integrate the model; `None` if it can, or if the run fails for another reason.
    pub(crate) fn method_refusal(&self, method: Method) -> Option<Refusal> {
        let setup = Setup { method, ..self.defaults().clone() };
        match Run::start(&self.program().model, setup) {
            Err(RunError { cause: Cause::NotSecondOrder(_), .. }) => Some(Refusal::Method { method }),
            _ => None,
        }
    }
}

impl Basis {
    /// All integration methods.
    pub fn methods(&self, at: &Course) -> Vec<MethodView> {
        let view = |method: Method| MethodView {
            name: method.name(),
            label: words::method_name(self.language(), method).to_owned(),
            selected: method == at.begun().method,
            refused: self.method_refusal(method).map(|refusal| self.refusal_text(&refusal)).unwrap_or_default(),
        };
        Method::ALL.into_iter().map(view).collect()
    }

    /// Step in the unit of the independent variable, and the text of that unit.
    pub fn step_text(&self, at: &Course) -> (String, String) {
        let unit = &self.model().independent.unit;
        (
            number::plain(unit.from_si(at.begun().step), crate::basis::input::DIGITS, self.style()),
            number::unit_text(&unit.text),
        )
    }
}
