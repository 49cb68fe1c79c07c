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
    /// Between `low`, where it has not happened, and `high`, where it has; `happened` is asked in between.
    pub fn find(low: f64, high: f64, mut happened: impl FnMut(f64) -> bool) -> Self {
        // Non-negative numbers are ordered like their bits, so this ends at neighbours after at most 63 halvings.
        let (mut low, mut high) = (low.to_bits(), high.to_bits());
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if happened(f64::from_bits(middle)) { high = middle } else { low = middle }
        }
        Self { low: f64::from_bits(low), high: f64::from_bits(high) }
    }

    /// The same counted from `start`.
    pub fn since(self, start: f64) -> Self {
        Self { low: self.low - start, high: self.high - start }
    }
}
