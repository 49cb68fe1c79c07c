//! A second drawing of the scene with other values, such as the measured level beside the computed one.

/// Source that a value of the scene depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Follows {
    /// Neither measured nor computed motion: parameters, the time.
    Nothing,
    /// Measured values.
    Measured,
    /// Computed values, possibly together with measured ones.
    Computed,
}

/// The scene with other values.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// Source of each value of the scene.
    pub follows: Vec<Follows>,
    /// Names of the data sources, for the legend.
    pub sources: Vec<String>,
    /// Values at the time shown; `None` if there are none at this time.
    pub values: Option<Vec<f64>>,
}
