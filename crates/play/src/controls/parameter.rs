//! Parameters: values for their controls, and setters.

use crate::basis::input::DIGITS;
use crate::controls::slider::Mapping;
use crate::{Basis, Course, Slider, number};
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

impl Basis {
    /// All parameters that readers see, in the order of the text.
    pub fn parameters(&self, at: &Course) -> Vec<ParameterView> {
        self.model().shown_parameters().filter_map(|(index, _)| self.parameter(at, index)).collect()
    }

    /// All parameters by groups of the document, in the order of the text.
    pub fn parameter_groups(&self, at: &Course) -> Vec<ParameterGroup> {
        let shown: Vec<(usize, &Parameter)> = self.model().shown_parameters().collect();
        let groups = shown.chunk_by(|(_, one), (_, next)| one.group == next.group);
        let view = |group: &[(usize, &Parameter)]| {
            let name = group.first().and_then(|(_, first)| first.group.as_deref()).map_or("", |name| self.text(name));
            let parameters = group.iter().filter_map(|&(index, _)| self.parameter(at, index)).collect();
            ParameterGroup { name: name.to_owned(), parameters }
        };
        groups.map(view).collect()
    }

    /// One parameter; `None` for an unknown index, and for a parameter that readers do not see.
    pub fn parameter(&self, at: &Course, index: usize) -> Option<ParameterView> {
        let parameter = self.model().parameters.get(index).filter(|parameter| parameter.is_shown())?;
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
