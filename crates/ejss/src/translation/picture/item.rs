//! Element of a drawing.

use super::super::facts::{Facts, Role};
use super::super::value::Value;
use crate::prose::visible;
use units::markup::escaped;

/// Element of the drawing.
#[derive(Clone, Debug, Default)]
pub(super) struct Item {
    pub tag: &'static str,
    /// Name of the element in the simulation.
    pub name: String,
    /// Attributes that are points.
    pub points: Vec<(&'static str, [Value; 2])>,
    /// Attributes that are lengths of the frame.
    pub lengths: Vec<(&'static str, Value)>,
    /// Attributes that are angles.
    pub angles: Vec<(&'static str, Value)>,
    /// Attributes that are written as they are.
    pub plain: Vec<(&'static str, String)>,
    pub visible: Option<Value>,
    /// Text and values between the tags.
    pub text: Vec<Value>,
    pub children: Vec<Item>,
    /// State that is dragged.
    pub drag: Option<String>,
}

impl Item {
    pub fn values(&self) -> Vec<&Value> {
        let mut values: Vec<&Value> = self.points.iter().flat_map(|(_, point)| point).collect();
        values.extend(self.lengths.iter().chain(&self.angles).map(|(_, value)| value));
        values.extend(&self.visible);
        values.extend(&self.text);
        values.extend(self.children.iter().flat_map(Self::values));
        values
    }

    pub fn quantity(&self) -> Option<&str> {
        let of_point = self.points.iter().flat_map(|(_, point)| point).find_map(|value| match value {
            Value::Name(name) => Some(name.as_str()),
            _ => None,
        });
        of_point.or_else(|| self.children.iter().find_map(Self::quantity))
    }
}

/// Text between tags of a scene: no markup, and braces twice.
pub(super) fn in_text(text: &str) -> String {
    escaped(&visible(text)).replace('{', "{{").replace('}', "}}").replace('`', "'")
}

/// True if a value is exactly a state.
pub(super) fn is_state(facts: &Facts, value: &Value) -> bool {
    matches!(value, Value::Name(name) if facts.role(name) == Some(Role::State))
}
