//! Texts of the pins of a plot.

/// Names of the pins in the plot.
pub const LETTERS: [&str; 2] = ["A", "B"];

/// Texts of the pins of a plot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pinned {
    /// Read-out of each pin.
    pub(super) readings: Vec<String>,
    /// Difference of the second pin from the first.
    pub(super) difference: String,
}
