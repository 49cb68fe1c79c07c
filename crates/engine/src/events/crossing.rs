//! Bisection for the moment of an event within a step.

/// Moment of an event as two neighbouring numbers; usually the time since the start of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Crossing {
    /// Last number at which the event has not happened.
    pub low: f64,
    /// Next representable number.
    pub high: f64,
}

impl Crossing {
    /// Bisects between the moments `low`, where the event has not happened, and `high`, where it has; both are SI and non-negative.
    pub fn find(low: f64, high: f64, mut happened: impl FnMut(f64) -> bool) -> Self {
        // Non-negative numbers are ordered like their bits; bisection of the bits ends at neighbours after at most 63
        // halvings.
        let (mut low, mut high) = (low.to_bits(), high.to_bits());
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if happened(f64::from_bits(middle)) { high = middle } else { low = middle }
        }
        Self { low: f64::from_bits(low), high: f64::from_bits(high) }
    }

    /// This crossing with its moments counted from `start`.
    pub fn since(self, start: f64) -> Self {
        Self { low: self.low - start, high: self.high - start }
    }
}
