//! Arguments that several tools have.

use super::answer::Refused;
use rmcp::schemars::{self, JsonSchema, Schema, SchemaGenerator, json_schema};
use runner::Settings;
use runner::names::{Assignment, seat};
use serde::Deserialize;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// A number in the declared unit, a text such as `20 [cm]`, or a truth.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum Given {
    /// A truth, of a switch.
    Truth(bool),
    /// A number in the declared unit.
    Number(f64),
    /// A text: a value with its unit in brackets, an expression, or a word.
    Text(String),
}

/// One line, because many arguments have it, and a client's model reads all of them.
impl JsonSchema for Given {
    fn schema_name() -> Cow<'static, str> {
        "Given".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": ["number", "string", "boolean"] })
    }
}

impl Given {
    /// The text as the command line takes it.
    pub fn text(&self) -> String {
        match self {
            Self::Truth(true) => "on".to_owned(),
            Self::Truth(false) => "off".to_owned(),
            Self::Number(number) => number.to_string(),
            Self::Text(text) => text.clone(),
        }
    }
}

/// Values by name.
pub type GivenByName = BTreeMap<String, Given>;

/// The values as assignments.
pub fn assignments(given: &GivenByName) -> Vec<Assignment> {
    given.iter().map(|(name, value)| Assignment { name: name.clone(), value: value.text() }).collect()
}

/// Settings of a run.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[schemars(inline)]
#[serde(default, deny_unknown_fields)]
pub struct RunSettings {
    /// Parameters and their values: a number in the declared unit, or a text such as "20 [cm]".
    set: GivenByName,
    /// States at the start, in place of the document's initial values.
    start: GivenByName,
    /// Names of presets of the document, applied before `set`.
    preset: Vec<String>,
    /// Presses of buttons: title and time, such as {"Kick": 3.2}.
    press: GivenByName,
    /// Method of integration, such as rk4, dormand-prince, rosenbrock.
    method: Option<String>,
    /// Step, or the distance between rows.
    step: Option<Given>,
    /// Relative tolerance of an adaptive method.
    tolerance: Option<f64>,
    /// End of the run.
    until: Option<Given>,
    /// Number of the seat whose assigned values are taken.
    seat: Option<u32>,
}

impl RunSettings {
    /// The settings as `runner` has them.
    pub fn settings(&self) -> Result<Settings, Refused> {
        Ok(Settings {
            seat: self.seat.map(|number| seat(&number.to_string())).transpose().map_err(Refused::because)?,
            set: assignments(&self.set),
            start: assignments(&self.start),
            preset: self.preset.clone(),
            press: assignments(&self.press),
            method: self.method.clone(),
            step: self.step.as_ref().map(Given::text),
            tolerance: self.tolerance,
            until: self.until.as_ref().map(Given::text),
        })
    }
}
