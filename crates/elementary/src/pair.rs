//! Numbers as sums of two, and the operations on bits that the functions share.
//!
//! Sums with their rounding error are those of T. J. Dekker, *A floating-point technique for extending the available
//! precision*, Numer. Math. 18 (1971) 224. A product is exact because its factors have at most 26 bits.

/// The sign bit.
pub(crate) const SIGN: u64 = 1 << 63;

/// 1.5 * 2^52: a number of magnitude below 2^51 plus this is rounded to a whole number, which its lowest bits contain.
pub(crate) const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// An unevaluated sum of two numbers. `low` is a correction, about the rounding error of `high`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    pub high: f64,
    pub low: f64,
}

impl Pair {
    /// `a + b` with its error. Exact if `a` is 0 or not smaller than `b` in magnitude.
    #[inline(always)]
    pub fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        Self { high, low: (a - high) + b }
    }

    /// `a - b` with its error, under the condition of [`Pair::sum`].
    #[inline(always)]
    pub fn difference(a: f64, b: f64) -> Self {
        let high = a - b;
        Self { high, low: (a - high) - b }
    }

    /// The sum of the two, rounded.
    #[inline(always)]
    pub fn value(self) -> f64 {
        self.high + self.low
    }

    /// The pair with `more` added to its correction.
    #[inline(always)]
    pub fn corrected(self, more: f64) -> Self {
        Self { low: self.low + more, ..self }
    }

    /// `self / divisor` to about 75 bits. `high` has 26 bits.
    #[inline(always)]
    pub fn over(self, divisor: Self) -> Self {
        let inverse = 1.0 / divisor.high;
        let high = upper(self.high * inverse);
        let (above, below) = halves(divisor.high);
        let rest = ((self.high - high * above) - high * below) + (self.low - high * divisor.low);
        Self { high, low: rest * inverse }
    }
}

/// `x` with the lowest 27 bits of its significand cleared: 26 remain.
#[inline(always)]
pub(crate) fn upper(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & !0x7ff_ffff)
}

/// [`upper`] part of `x` and the rest, whose sum is `x`.
#[inline(always)]
pub(crate) fn halves(x: f64) -> (f64, f64) {
    let upper = upper(x);
    (upper, x - upper)
}

/// The whole number that is nearest to `x`, even in a tie; `|x| < 2^51`.
#[inline(always)]
pub(crate) fn nearest(x: f64) -> f64 {
    (x + ROUNDER) - ROUNDER
}

/// 2^n for a whole number `n` from -1022 to 1023.
#[inline(always)]
pub(crate) fn power_of_two(n: f64) -> f64 {
    f64::from_bits((n + (ROUNDER + 1023.0)).to_bits() << 52)
}

/// Significand and exponent of a positive normal number: the significand is at least that of the bits `least`, a number
/// between 0.5 and 1, and less than twice that.
#[inline(always)]
pub(crate) fn split(x: f64, least: u64) -> (f64, f64) {
    const FRACTION: u64 = (1 << 52) - 1;
    // A number between 2^52 and 2^53 has its unit in its lowest bit.
    const WHOLE: f64 = 4_503_599_627_370_496.0;
    let bits = x.to_bits().wrapping_add(1.0_f64.to_bits() - least);
    let exponent = f64::from_bits((bits >> 52) | WHOLE.to_bits()) - (WHOLE + 1023.0);
    (f64::from_bits((bits & FRACTION) + least), exponent)
}

/// `magnitude` with the sign of `x`, for a magnitude without a sign.
#[inline(always)]
pub(crate) fn signed(magnitude: f64, x: f64) -> f64 {
    f64::from_bits(magnitude.to_bits() ^ (x.to_bits() & SIGN))
}

/// True if `x` is from `least` to `most`.
#[allow(clippy::manual_range_contains, reason = "`contains` branches, which lanes cannot")]
#[inline(always)]
pub(crate) fn is_between(x: f64, least: f64, most: f64) -> bool {
    (x >= least) & (x <= most)
}
