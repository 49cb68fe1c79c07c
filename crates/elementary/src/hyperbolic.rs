//! Hyperbolic functions. With `x = n ln(2) + r` and `t = 4^-n`
//!
//! ```text
//! 2 sinh(x) / 2^n = (1 - t) cosh(r) + (1 + t) sinh(r)
//! 2 cosh(x) / 2^n = (1 + t) cosh(r) + (1 - t) sinh(r)
//! ```
//!
//! The terms of first order in `r` and all sums have their rounding errors, so that nothing cancels.

use crate::exponential::{even_and_odd, reduced};
use crate::pair::{Pair, power_of_two, signed};

/// Largest argument computed: sinh and cosh are infinite beyond.
const MOST: f64 = 711.0;

/// Beyond this the hyperbolic tangent is 1.
const MOST_OF_TANH: f64 = 19.5;

/// `4^-n` is negligible for larger `n`.
const MOST_FOLDINGS: f64 = 40.0;

/// Magnitude of `x`, at most `most`; NaN for NaN.
#[inline(always)]
fn magnitude(x: f64, most: f64) -> f64 {
    let magnitude = x.abs();
    if magnitude > most { most } else { magnitude }
}

/// `4^-n`.
#[inline(always)]
fn fading(n: f64) -> f64 {
    power_of_two(-2.0 * if n > MOST_FOLDINGS { MOST_FOLDINGS } else { n })
}

/// `one cosh(r) + other sinh(r)`, given `linear`, which is `other * r.high`.
#[inline(always)]
fn combined(one: Pair, other: f64, r: Pair, linear: Pair) -> Pair {
    let (even, odd) = even_and_odd(r.high);
    let beyond = (even + r.high * r.low) * one.high + (odd + r.low) * other;
    Pair::sum(one.high, linear.high).corrected(one.low + linear.low + beyond)
}

/// Hyperbolic sine of `x`. Every argument is plain.
#[inline(always)]
pub(crate) fn plain_sinh(x: f64) -> f64 {
    let (r, n) = reduced(magnitude(x, MOST));
    let t = fading(n);
    let sum = combined(Pair::difference(1.0, t), 1.0 + t, r, Pair::sum(r.high, t * r.high));
    // Twice the sum, so that the power of two is finite.
    signed(2.0 * sum.value() * power_of_two(n - 2.0), x)
}

/// Hyperbolic cosine of `x`. Every argument is plain.
#[inline(always)]
pub(crate) fn plain_cosh(x: f64) -> f64 {
    let (r, n) = reduced(magnitude(x, MOST));
    let t = fading(n);
    let sum = combined(Pair::sum(1.0, t), 1.0 - t, r, Pair::difference(r.high, t * r.high));
    2.0 * sum.value() * power_of_two(n - 2.0)
}

/// Hyperbolic tangent of `x`. Every argument is plain: `(e^y - 1)/(e^y + 1)` with `y = 2|x|`, both divided by the power of two in `e^y`.
#[inline(always)]
pub(crate) fn plain_tanh(x: f64) -> f64 {
    let (r, n) = reduced(2.0 * magnitude(x, MOST_OF_TANH));
    let (even, odd) = even_and_odd(r.high);
    let beyond = (odd + even) + (r.low + r.low * r.high);
    let t = power_of_two(-n);
    let (less, more) = (Pair::difference(1.0, t), Pair::sum(1.0, t));
    let side = |one: Pair| {
        let sum = Pair::sum(one.high, r.high).corrected(one.low + beyond);
        Pair::sum(sum.high, sum.low)
    };
    signed(side(less).over(side(more)).value(), x)
}

/// Hyperbolic sine of `x`.
pub fn sinh(x: f64) -> f64 {
    plain_sinh(x)
}

/// Hyperbolic cosine of `x`.
pub fn cosh(x: f64) -> f64 {
    plain_cosh(x)
}

/// Hyperbolic tangent of `x`.
pub fn tanh(x: f64) -> f64 {
    plain_tanh(x)
}
