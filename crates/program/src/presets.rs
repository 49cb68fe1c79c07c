//! Presets: named sets of parameter values.

use crate::Compiled;
use serde::{Deserialize, Serialize};

/// A named set of parameter values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Preset {
    /// Name of the group, such as `Liquid`.
    pub group: Option<String>,
    /// Name of the preset.
    pub name: String,
    /// Parameters and their values.
    pub values: Vec<Assignment>,
}

/// A parameter and its new value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Assignment {
    /// Index in [`crate::Model::parameters`].
    pub parameter: usize,
    /// New value, SI units; depends on parameters only. Assignments are applied in order: each value is computed from the
    /// parameters left by the previous ones.
    pub value: Compiled,
}
