//! A second drawing of the scene, with values that others give: the level that was measured beside the one computed.

/// What a value of the scene follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Follows {
    /// Nothing that moves by itself: parameters, the time.
    Nothing,
    /// What is measured.
    Measured,
    /// What is only computed, perhaps beside what is measured.
    Computed,
}

/// The scene with other values.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    /// What each value of the scene follows.
    pub follows: Vec<Follows>,
    /// Where the values come from, for the legend.
    pub sources: Vec<String>,
    /// The values at the time shown; none where there are none at this time.
    pub values: Option<Vec<f64>>,
}
