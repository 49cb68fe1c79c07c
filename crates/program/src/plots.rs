//! Plots: what is drawn against what.

use crate::Compiled;
use serde::{Deserialize, Serialize};

/// A figure: `"Phase portrait": y' against y`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plot {
    /// The title, to be passed through [`crate::Program::text`].
    pub title: String,
    /// What is drawn along the horizontal axis.
    pub x: Curve,
    /// What is drawn; those of equal dimension share an axis.
    pub curves: Vec<Curve>,
}

/// One expression of a plot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// As written: `y'`.
    pub expression: String,
    /// The author's label of the name, where the expression is one.
    pub label: Option<String>,
    /// Its value; always a number.
    pub value: Compiled,
}
