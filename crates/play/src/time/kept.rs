//! A run kept for comparison, and the ghost: the rows discarded last.

use crate::plots::traces::Traces;
use crate::time::recipe::Recipe;

/// Maximum number of kept runs; more cannot be distinguished in a plot.
pub const MOST_KEPT: usize = 5;

/// A kept run in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptView {
    /// Identifier, unique while the document is open.
    pub id: u32,
    /// Name from its differences to the present run: `b = 200 kg/s`.
    pub name: String,
    /// True if it is drawn.
    pub shown: bool,
    /// Dash pattern of its lines, see [`figure::Style::Faded`].
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
    /// State at the time of the recipe, SI.
    pub state: Vec<f64>,
}

/// Values of a kept run at its time.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptValues {
    /// Name from its differences to the document's own run.
    pub name: String,
    /// Time shown when it was kept, SI.
    pub time: f64,
    /// Parameters at the end, SI, one value per parameter of the model.
    pub parameters: Vec<f64>,
    /// State at this time, SI, one value per state of the model.
    pub state: Vec<f64>,
}

/// The rows discarded last.
#[derive(Clone, Debug)]
pub(crate) struct Ghost {
    pub traces: Traces,
}
