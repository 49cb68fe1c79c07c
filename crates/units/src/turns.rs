//! Cycles and angles: two ways to count turns, which have the same dimension.

/// Exponents of the symbols in a unit that count turns: `rad/s^2` has the angle once, `1/Hz` the cycle -1 times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Turns {
    /// Exponent of hertz.
    pub(crate) cycles: f64,
    /// Exponent of radians, degrees and revolutions per minute, which are angular velocities.
    pub(crate) angles: f64,
}

impl Turns {
    pub(crate) const NONE: Self = Self { cycles: 0.0, angles: 0.0 };

    /// The exponents of a product with the power `exponent` of another unit.
    pub(crate) fn times(self, other: Self, exponent: f64) -> Self {
        Self { cycles: self.cycles + exponent * other.cycles, angles: self.angles + exponent * other.angles }
    }
}
