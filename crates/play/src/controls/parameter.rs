//! Parameters: values for their controls, and setters.

use crate::basis::input::DIGITS;
use crate::controls::slider::Mapping;
use crate::removed::Removed;
use crate::{Announcement, Basis, Changes, Course, Play, Refusal, Slider, number};
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
    /// Sets a parameter to an SI value. If an initial value depends on it, the run restarts; otherwise it takes effect
    /// from the next step.
    pub fn set_parameter(&mut self, index: usize, value: f64) -> Result<(), Refusal> {
        let value = self.basis.admit(index, value)?;
        let mut parameters = self.course().parameters().to_vec();
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
        let (view, parameter) =
            self.basis.parameter(self.course(), index).zip(self.model().parameters.get(index)).ok_or_else(unknown)?;
        match self.basis.read_field(self.course(), text, &view.text, &parameter.unit)? {
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
        let parameters = self.basis.defaults().parameters.clone();
        if self.is_started_by_hand() || self.course().begun().drawings != self.basis.defaults().drawings {
            let before = Setup { parameters: self.course().parameters().to_vec(), ..self.course().begun().clone() };
            let drawings = self.basis.defaults().drawings.clone();
            self.restart(Setup { parameters, start: None, drawings, ..before.clone() });
            self.can_undo(Removed::Start(before));
        } else {
            self.overwrite_parameters(parameters);
        }
        self.announce(Announcement::DefaultsRestored);
    }

    /// Sets all parameters (SI). Restarts the run if an initial value depends on a changed one.
    pub(crate) fn change_parameters(&mut self, parameters: Vec<f64>) {
        let old = self.course().parameters();
        if old == parameters {
            return;
        }
        let deciding = |(index, parameter): (usize, &Parameter)| {
            (parameter.restarts && old.get(index) != parameters.get(index)).then_some(index)
        };
        let decides = self.model().parameters.iter().enumerate().find_map(deciding);
        self.note(Changes::PARAMETERS);
        if decides.is_some() || self.course().history().is_none() {
            let setup = Setup { parameters, start: None, ..self.course().begun().clone() };
            let begun = self.course().front() > 0.0 || self.is_started_by_hand();
            self.restart(setup);
            if let (Some(index), true) = (decides, begun) {
                self.announce(Announcement::Restarted(index));
            }
        } else {
            self.branch();
            let changes = self.line.set_parameters(self.basis.model(), parameters);
            self.note(changes);
        }
    }
}

impl Basis {
    /// All parameters, in the order of the text.
    pub fn parameters(&self, at: &Course) -> Vec<ParameterView> {
        (0..self.model().parameters.len()).filter_map(|index| self.parameter(at, index)).collect()
    }

    /// All parameters by groups of the document, in the order of the text.
    pub fn parameter_groups(&self, at: &Course) -> Vec<ParameterGroup> {
        let mut views = self.parameters(at).into_iter();
        let groups = self.model().parameters.chunk_by(|one, next| one.group == next.group);
        groups
            .map(|group| {
                let name = group.first().and_then(|first| first.group.as_deref()).map_or("", |name| self.text(name));
                ParameterGroup { name: name.to_owned(), parameters: views.by_ref().take(group.len()).collect() }
            })
            .collect()
    }

    /// One parameter; `None` for an unknown index.
    pub fn parameter(&self, at: &Course, index: usize) -> Option<ParameterView> {
        let parameter = self.model().parameters.get(index)?;
        let &value = at.parameters().get(index)?;
        let shown = |value: f64| number::plain(parameter.unit.from_si(value), DIGITS, self.style());
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
}
