//! Labels and texts of parameters, states and values; values that parameters take.

use super::Basis;
use crate::values::symbol::symbol;
use crate::words::refusal_text;
use crate::{Refusal, number, words};
use program::{Assignment, Choices, Compiled, Kind, NodeId, State};
use units::Unit;

/// Maximum digits of a count; beyond these it is not exact in double precision.
const COUNT_DIGITS: usize = 15;

impl Basis {
    /// Text of a refusal in the chosen language.
    pub fn refusal_text(&self, refusal: &Refusal) -> String {
        refusal_text(self.language(), refusal)
    }

    /// Texts such as `y(0) = 0.3 m` for each state of a start set by hand.
    pub(crate) fn start_texts(&self, start: &[f64]) -> Vec<String> {
        let text = |(state, &value): (&State, &f64)| {
            format!("{}(0) = {}", symbol(&state.name()), self.quantity_text(value, &state.unit))
        };
        self.model().states.iter().zip(start).map(text).collect()
    }

    /// Text of a step: `h = 0.01 s`.
    pub(crate) fn step_words(&self, step: f64) -> String {
        format!("h = {}", self.quantity_text(step, &self.model().independent.unit))
    }

    /// True if a value is an integer and displayed as such.
    pub(crate) fn is_count(&self, node: NodeId, unit: &Unit) -> bool {
        unit.text.is_empty() && self.whole().get(node.0 as usize).is_some_and(|whole| *whole)
    }

    /// An integer with all its digits.
    pub(crate) fn count(&self, value: f64) -> String {
        number::plain(value, COUNT_DIGITS, self.style())
    }

    /// A text or truth value in the chosen language.
    pub(crate) fn word_value(&self, compiled: &Compiled, value: f64) -> String {
        if !value.is_finite() {
            return number::DASH.to_owned();
        }
        match compiled.kind {
            Kind::Text => {
                self.model().texts.get(value as usize).map_or(number::DASH, |text| self.text(text)).to_owned()
            }
            _ => words::truth(self.language(), value != 0.0).to_owned(),
        }
    }

    /// Text of a parameter value: `b = 200 kg/s`.
    pub(crate) fn parameter_text(&self, index: usize, value: f64) -> String {
        self.model().parameters.get(index).map_or_else(String::new, |parameter| {
            format!("{} = {}", symbol(&parameter.name), self.parameter_value_text(index, value))
        })
    }

    /// Text of a parameter value (SI): `50 kg/s`, `yes`, `Water`.
    pub fn parameter_value_text(&self, index: usize, value: f64) -> String {
        let Some(parameter) = self.model().parameters.get(index) else { return String::new() };
        match parameter.choices {
            Choices::Numbers | Choices::Seed => self.quantity_text(value, &parameter.unit),
            Choices::Switch => words::truth(self.language(), value != 0.0).to_owned(),
            Choices::Texts(_) => {
                parameter.word(value, &self.model().texts).map_or_else(String::new, |text| self.text(text).to_owned())
            }
        }
    }

    /// Label of a parameter in the chosen language; its name if it has none.
    pub fn parameter_label(&self, index: usize) -> &str {
        let Some(parameter) = self.model().parameters.get(index) else {
            return "";
        };
        parameter.label.as_deref().map_or(parameter.name.as_str(), |label| self.text(label))
    }

    /// Returns the value (SI), clamped to the range against rounding, or the reason why the parameter cannot take it.
    pub fn admit(&self, index: usize, value: f64) -> Result<f64, Refusal> {
        let parameter = self.model().parameters.get(index).filter(|parameter| parameter.is_shown());
        let parameter = parameter.ok_or_else(|| Refusal::Unknown { name: index.to_string() })?;
        let name = self.parameter_label(index).to_owned();
        if !parameter.takes(value) {
            return Err(Refusal::NoValue { name });
        }
        let Some((low, high)) = parameter.range else {
            return Ok(value);
        };
        // A value typed in another unit may miss the end of the range by rounding.
        let slack = (high - low) * 1e-12;
        if value < low - slack {
            Err(Refusal::TooSmall { name, least: self.quantity_text(low, &parameter.unit) })
        } else if value > high + slack {
            Err(Refusal::TooLarge { name, greatest: self.quantity_text(high, &parameter.unit) })
        } else {
            Ok(value.max(low).min(high))
        }
    }

    /// Label of a state in the chosen language; its name if it has none.
    pub(crate) fn state_label(&self, index: usize) -> String {
        let Some(state) = self.model().states.get(index) else {
            return String::new();
        };
        state.label.as_deref().map_or_else(|| state.name(), |label| self.text(label).to_owned())
    }

    /// Name and displayed value of each assigned parameter: `rho` and `13534 kg/m³`.
    pub(crate) fn assigned(&self, assignments: &[Assignment], parameters: &[f64]) -> Vec<(String, String)> {
        let assigned = |assignment: &Assignment| {
            let parameter = self.model().parameters.get(assignment.parameter)?;
            let value = parameters.get(assignment.parameter)?;
            Some((parameter.name.clone(), self.parameter_value_text(assignment.parameter, *value)))
        };
        assignments.iter().filter_map(assigned).collect()
    }

    /// Returns the parameters if every assigned value is allowed.
    pub(crate) fn admit_assignments(
        &self,
        assignments: &[Assignment],
        mut parameters: Vec<f64>,
    ) -> Result<Vec<f64>, Refusal> {
        for assignment in assignments {
            if let Some(value) = parameters.get_mut(assignment.parameter) {
                *value = self.admit(assignment.parameter, *value)?;
            }
        }
        Ok(parameters)
    }
}
