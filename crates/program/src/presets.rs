//! Presets: named sets of parameter values.

use crate::Compiled;
use serde::{Deserialize, Serialize};

/// A named set of parameter values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Preset {
    /// The name of its group, such as `Liquid`.
    pub group: Option<String>,
    /// Its name.
    pub name: String,
    /// What it sets.
    pub values: Vec<Assignment>,
}

/// A parameter and the value it gets.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Assignment {
    /// Which of [`crate::Model::parameters`].
    pub parameter: usize,
    /// The value, SI, in terms of parameters only. Assignments are made in their order: each value is computed from the
    /// parameters as those before it have left them.
    pub value: Compiled,
}
