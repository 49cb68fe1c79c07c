//! What the pins of a plot read.

/// What the pins are called in the plot.
pub const LETTERS: [&str; 2] = ["A", "B"];

/// The words of a plot's pins.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pinned {
    /// What each of them reads.
    pub(super) readings: Vec<String>,
    /// How far the second is from the first.
    pub(super) difference: String,
}
