//! Parameters: what their controls show, and setting them.

use crate::{Refusal, Session};

/// A parameter as its control shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterView {
    /// Which of [`model::Model::parameters`].
    pub index: usize,
    /// The ASCII name, `h_l`; typeset it with [`model::typeset_name`].
    pub name: String,
    /// The label in the session's language; the name where there is none.
    pub label: String,
    /// The unit for people, `kg/m³`; empty for a pure number.
    pub unit: String,
    /// The value, SI.
    pub value: f64,
    /// The value in the unit, for the field: `0,05`.
    pub text: String,
    /// The value with its unit, for `aria-valuetext`: `0,05 m²`.
    pub spoken: String,
    /// Least and greatest value for people, without unit: `("2", "9")`.
    pub range: Option<(String, String)>,
    /// The slider; `None` without a range.
    pub slider: Option<Slider>,
    /// Whether it has its default value.
    pub is_default: bool,
    /// Whether changing it starts the run anew.
    pub restarts: bool,
}

/// A slider with whole positions, 0 to `positions`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slider {
    /// The greatest position.
    pub positions: u32,
    /// The present one.
    pub position: u32,
    /// How many positions a large step (Page Up) is.
    pub page: u32,
}

impl Session {
    /// All parameters, in the order of the text.
    pub fn parameters(&self) -> Vec<ParameterView> {
        (0..self.model().parameters.len())
            .filter_map(|index| self.parameter(index))
            .collect()
    }

    /// One parameter.
    pub fn parameter(&self, index: usize) -> Option<ParameterView> {
        let _ = index;
        None
    }

    /// Sets a parameter to an SI value. One on which an initial value depends starts the run anew; any other takes
    /// effect from the next step on.
    pub fn set_parameter(&mut self, index: usize, value: f64) -> Result<(), Refusal> {
        let _ = (index, value);
        Ok(())
    }

    /// Sets a parameter from what was typed: a number in the parameter's unit, or with a unit of the same dimension.
    pub fn set_parameter_text(&mut self, index: usize, text: &str) -> Result<(), Refusal> {
        let _ = (index, text);
        Ok(())
    }

    /// Sets a parameter to the value at a position of its slider.
    pub fn slide(&mut self, index: usize, position: u32) {
        let _ = (index, position);
    }

    /// Sets one parameter to its default.
    pub fn reset_parameter(&mut self, index: usize) {
        let _ = index;
    }

    /// Sets all parameters to their defaults.
    pub fn reset_parameters(&mut self) {}
}
