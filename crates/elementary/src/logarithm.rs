//! The natural logarithm: `k ln(2) + log(1 + f)` with `1 + f` between sqrt(1/2) and sqrt(2), and `log(1 + f)` as a series in
//! `s = f/(2 + f)` (the method of FreeBSD's `e_log.c`, 1993, by Sun Microsystems).

use crate::exponential::LN_2;
use crate::pair::{Pair, is_between, split};

/// Bits of sqrt(1/2).
const LEAST: u64 = 0x3fe6_a09e_667f_3bcd;

/// Coefficients of `(log((1 + s)/(1 - s))/s - 2)/s^2` in powers of `s^2`.
const SERIES: [f64; 7] = [
    0.666_666_666_666_673_4,
    0.399_999_999_994_165_3,
    0.285_714_287_420_704_4,
    0.222_221_985_992_927_53,
    0.181_835_632_105_645_93,
    0.153_140_743_771_379_32,
    0.147_957_489_789_950_52,
];

/// True if the lanes compute this argument: a positive normal number.
#[inline(always)]
pub(crate) fn is_plain(x: f64) -> bool {
    is_between(x, f64::MIN_POSITIVE, f64::MAX)
}

/// Logarithm of a plain number.
#[inline(always)]
pub(crate) fn plain_ln(x: f64) -> f64 {
    let (significand, exponent) = split(x, LEAST);
    let f = significand - 1.0;
    let s = f / (2.0 + f);
    let square = s * s;
    let [a, b, c, d, e, g, h] = SERIES;
    let series = a + square * (b + square * (c + square * (d + square * (e + square * (g + square * h)))));
    let half = 0.5 * f * f;
    let beyond = exponent * LN_2[1] - (half - s * (half + square * series));
    Pair::sum(exponent * LN_2[0], f).corrected(beyond).value()
}

/// Natural logarithm of `x`: NaN for a negative number, minus infinity for 0.
pub fn ln(x: f64) -> f64 {
    if is_plain(x) { plain_ln(x) } else { libm::log(x) }
}
