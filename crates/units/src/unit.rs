//! Units: a dimension, a factor to SI and the text that names it.

use crate::Dimension;
use std::ops::Range;

/// A unit of measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// What it measures.
    pub dimension: Dimension,
    /// SI value of one of it.
    pub factor: f64,
    /// As the author wrote it, blanks normalised: `kg/m^3`, `Pa s`; empty for a pure number.
    pub text: String,
}

/// Why a text is no unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitError {
    /// Where in the text.
    pub range: Range<usize>,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub hint: Option<String>,
}
