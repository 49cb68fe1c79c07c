//! Method and step, chosen in the laboratory.

use crate::{Refusal, Session};

/// A method in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct MethodView {
    /// Its name in the engine: `rk4`.
    pub name: &'static str,
    /// Its name in the session's language.
    pub label: String,
    /// Whether it is the one in use.
    pub selected: bool,
    /// Why it cannot integrate this model, in the session's language; empty if it can.
    pub refused: String,
}

impl Session {
    /// The methods.
    pub fn methods(&self) -> Vec<MethodView> {
        Vec::new()
    }

    /// Chooses a method by its name; the run starts anew.
    pub fn set_method(&mut self, name: &str) -> Result<(), Refusal> {
        let _ = name;
        Ok(())
    }

    /// The step (SI).
    pub fn step(&self) -> f64 {
        0.0
    }

    /// The step in the unit of the independent variable, and that unit.
    pub fn step_text(&self) -> (String, String) {
        (String::new(), String::new())
    }

    /// Sets the step from what was typed; the run starts anew.
    pub fn set_step_text(&mut self, text: &str) -> Result<(), Refusal> {
        let _ = text;
        Ok(())
    }
}
