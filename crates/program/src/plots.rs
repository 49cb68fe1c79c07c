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
    /// The curves that are drawn against something else than `x`, of the same dimension: their places and that.
    pub others: Vec<(usize, Curve)>,
    /// Whether the document asks for a unit of the same length on both axes.
    pub equal: bool,
}

impl Plot {
    /// What a curve is drawn against.
    pub fn x_of(&self, curve: usize) -> &Curve {
        self.others.iter().find(|(place, _)| *place == curve).map_or(&self.x, |(_, x)| x)
    }

    /// All that is drawn along the horizontal axis.
    pub fn abscissas(&self) -> impl Iterator<Item = &Curve> {
        std::iter::once(&self.x).chain(self.others.iter().map(|(_, x)| x))
    }

    /// Everything that is evaluated.
    pub fn expressions(&self) -> impl Iterator<Item = &Curve> {
        self.curves.iter().chain(self.abscissas())
    }
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
