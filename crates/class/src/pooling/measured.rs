//! Result of one group.

/// Result of a group, in any unit that is common to all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The value.
    pub value: f64,
    /// Its standard error, above 0.
    pub error: f64,
}
