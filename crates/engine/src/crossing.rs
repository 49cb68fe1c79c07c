//! Where within a step something happens.

/// Where something happens within a step, counted from its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Crossing {
    /// The last moment at which it has not happened.
    pub low: f64,
    /// The next number.
    pub high: f64,
}

impl Crossing {
    /// The same counted from `start`.
    pub fn since(self, start: f64) -> Self {
        Self { low: self.low - start, high: self.high - start }
    }
}
