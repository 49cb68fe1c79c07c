//! A run kept for comparison, and the ghost: the rows that were given up last.

use crate::plots::traces::Traces;
use crate::time::recipe::Recipe;

/// How many runs can be kept: no more can be distinguished in a plot.
pub const MOST_KEPT: usize = 5;

/// A kept run in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptView {
    /// Names the run as long as it exists.
    pub id: u32,
    /// What distinguishes it: `b = 200 kg/s`.
    pub name: String,
    /// Whether it is drawn.
    pub shown: bool,
    /// Which dash pattern it is drawn with: [`figure::Style::Kept`].
    pub pattern: u8,
}

/// A run kept for comparison.
#[derive(Clone, Debug)]
pub(crate) struct Kept {
    pub id: u32,
    pub recipe: Recipe,
    pub shown: bool,
    pub pattern: u8,
    pub traces: Traces,
}

/// The rows that were given up last.
#[derive(Clone, Debug)]
pub(crate) struct Ghost {
    pub traces: Traces,
}
