//! Parameters: values for their controls, and setters.

use crate::controls::input::DIGITS;
use crate::controls::slider::Mapping;
use crate::removed::Removed;
use crate::{Announcement, Play, Refusal, Slider, number, words};
use engine::Setup;
use program::{Choices, Parameter};

/// A parameter, for its control.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterView {
    /// Index into [`program::Model::parameters`].
    pub index: usize,
    /// ASCII name, `h_l`.
    pub name: String,
    /// Label in the chosen language; the name if there is none.
    pub label: String,
    /// Unit as displayed, `kg/m³`; empty for a pure number.
    pub unit: String,
    /// Value, SI.
    pub value: f64,
    /// Value in the unit, for the field: `0,05`.
    pub text: String,
    /// Value with unit, for `aria-valuetext`: `0,05 m²`.
    pub spoken: String,
    /// Options of a switch (off and on) or a choice; empty for a number.
    pub choices: Vec<ChoiceView>,
    /// True for a switch (on or off).
    pub is_switch: bool,
    /// Least and greatest value as displayed, without unit: `("2", "9")`.
    pub range: Option<(String, String)>,
    /// Slider; `None` without a range.
    pub slider: Option<Slider>,
    /// True if it has its default value.
    pub is_default: bool,
    /// True if changing it restarts the run.
    pub restarts: bool,
}

/// Parameters under one heading.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterGroup {
    /// Heading in the chosen language; empty for parameters before the first group of the document.
    pub name: String,
    /// Parameters in the order of the text.
    pub parameters: Vec<ParameterView>,
}

/// One option of a switch or a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceView {
    /// Value of the parameter for this option.
    pub value: f64,
    /// Text of the option in the chosen language.
    pub text: String,
}

impl Play {
    /// All parameters that readers see, in the order of the text.
    pub fn parameters(&self) -> Vec<ParameterView> {
        self.model().shown_parameters().filter_map(|(index, _)| self.parameter(index)).collect()
    }

    /// All parameters by groups of the document, in the order of the text.
    pub fn parameter_groups(&self) -> Vec<ParameterGroup> {
        let shown: Vec<(usize, &Parameter)> = self.model().shown_parameters().collect();
        let groups = shown.chunk_by(|(_, one), (_, next)| one.group == next.group);
        let view = |group: &[(usize, &Parameter)]| {
            let name = group.first().and_then(|(_, first)| first.group.as_deref()).map_or("", |name| self.text(name));
            let parameters = group.iter().filter_map(|&(index, _)| self.parameter(index)).collect();
            ParameterGroup { name: name.to_owned(), parameters }
        };
        groups.map(view).collect()
    }

    /// One parameter; `None` for an unknown index, and for a parameter that readers do not see.
    pub fn parameter(&self, index: usize) -> Option<ParameterView> {
        let parameter = self.model().parameters.get(index).filter(|parameter| parameter.is_shown())?;
        let &value = self.course.parameters().get(index)?;
        let shown = |value: f64| number::plain(parameter.unit.from_si(value), DIGITS, self.style);
        Some(ParameterView {
            index,
            name: parameter.name.clone(),
            label: self.parameter_label(index).to_owned(),
            unit: number::unit_text(&parameter.unit.text),
            value,
            text: shown(value),
            spoken: self.parameter_value_text(index, value),
            choices: self.choices(index),
            is_switch: parameter.choices == Choices::Switch,
            range: parameter.range.map(|(low, high)| (shown(low), shown(high))),
            slider: Mapping::of(parameter).map(|mapping| mapping.slider(value)),
            is_default: value == parameter.value,
            restarts: parameter.restarts,
        })
    }

    /// Options of a switch or a choice.
    fn choices(&self, index: usize) -> Vec<ChoiceView> {
        let values = match self.model().parameters.get(index).map(|parameter| &parameter.choices) {
            None | Some(Choices::Numbers | Choices::Seed) => Vec::new(),
            Some(Choices::Switch) => vec![0.0, 1.0],
            Some(Choices::Texts(texts)) => texts.iter().map(|&text| f64::from(text)).collect(),
        };
        let view = |value| ChoiceView { value, text: self.parameter_value_text(index, value) };
        values.into_iter().map(view).collect()
    }

    /// Text of a parameter value (SI): `50 kg/s`, `yes`, `Water`.
    pub fn parameter_value_text(&self, index: usize, value: f64) -> String {
        let Some(parameter) = self.model().parameters.get(index) else { return String::new() };
        match parameter.choices {
            Choices::Numbers | Choices::Seed => self.quantity_text(value, &parameter.unit),
            Choices::Switch => words::truth(self.language, value != 0.0).to_owned(),
            Choices::Texts(_) => {
                parameter.word(value, &self.model().texts).map_or_else(String::new, |text| self.text(text).to_owned())
            }
        }
    }

    /// Sets a parameter to an SI value. If an initial value depends on it, the run restarts; otherwise it takes effect
    /// from the next step.
    pub fn set_parameter(&mut self, index: usize, value: f64) -> Result<(), Refusal> {
        let value = self.admit(index, value)?;
        let mut parameters = self.course.parameters().to_vec();
        let Some(old) = parameters.get_mut(index) else {
            return Ok(());
        };
        if old.to_bits() == value.to_bits() {
            return Ok(());
        }
        *old = value;
        self.change_parameters(parameters);
        self.announce(Announcement::ParameterSet(index, value));
        Ok(())
    }

    /// Sets a parameter from typed text: a number in the parameter's unit, a number with a unit of the same dimension,
    /// or an expression for its present value. The text shown in the field leaves the value unchanged.
    pub fn set_parameter_text(&mut self, index: usize, text: &str) -> Result<(), Refusal> {
        let unknown = || Refusal::Unknown { name: index.to_string() };
        let (view, parameter) = self.parameter(index).zip(self.model().parameters.get(index)).ok_or_else(unknown)?;
        match self.read_field(text, &view.text, &parameter.unit)? {
            Some(value) => self.set_parameter(index, value),
            None => Ok(()),
        }
    }

    /// Sets a parameter to the value at a slider position.
    pub fn slide(&mut self, index: usize, position: u32) {
        let Some(mapping) = self.model().parameters.get(index).and_then(Mapping::of) else {
            return;
        };
        // Slider values lie within the range, so this cannot be refused.
        let _ = self.set_parameter(index, mapping.value(position));
    }

    /// Resets one parameter to its default.
    pub fn restore_default(&mut self, index: usize) {
        if let Some(value) = self.model().parameters.get(index).map(|parameter| parameter.value) {
            let _ = self.set_parameter(index, value);
        }
    }

    /// Resets all parameters to their defaults. If the run started from a state set by hand or with drawn curves, it
    /// restarts with the document's initial values and curves.
    pub fn restore_defaults(&mut self) {
        let parameters = self.defaults.parameters.clone();
        if self.is_started_by_hand() || self.course.begun().drawings != self.defaults.drawings {
            let before = Setup { parameters: self.course.parameters().to_vec(), ..self.course.begun().clone() };
            let drawings = self.defaults.drawings.clone();
            self.restart(Setup { parameters, start: None, drawings, ..before.clone() });
            self.can_undo(Removed::Start(before));
        } else {
            self.overwrite_parameters(parameters);
        }
        self.announce(Announcement::DefaultsRestored);
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

    /// Sets all parameters (SI). Restarts the run if an initial value depends on a changed one.
    pub(crate) fn change_parameters(&mut self, parameters: Vec<f64>) {
        let old = self.course.parameters();
        if old == parameters {
            return;
        }
        let deciding = |(index, parameter): (usize, &Parameter)| {
            (parameter.restarts && old.get(index) != parameters.get(index)).then_some(index)
        };
        let decides = self.model().parameters.iter().enumerate().find_map(deciding);
        self.revision.parameters += 1;
        if decides.is_some() || self.course.history().is_none() {
            let setup = Setup { parameters, start: None, ..self.course.begun().clone() };
            let begun = self.course.front() > 0.0 || self.is_started_by_hand();
            self.restart(setup);
            if let (Some(index), true) = (decides, begun) {
                self.announce(Announcement::Restarted(index));
            }
        } else {
            self.branch();
            self.course.give_up_presses();
            self.course.set_parameters(&self.program.model, parameters);
            self.traces.truncate(self.course.rows().saturating_sub(1));
            self.revision.transport += 1;
            self.frame_changed();
        }
    }
}
