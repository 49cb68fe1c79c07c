//! Powers: the logarithm to base 2 as a sum of two numbers, its product with the exponent, and the exponential function of
//! what is left beside a whole number (the method of FreeBSD's `e_pow.c`, 2004, by Sun Microsystems, with 26 bits in the
//! leading parts).

use crate::exponential::{near_one, scaled};
use crate::pair::{Pair, halves, is_between, nearest, split, upper};
use core::f64::consts::LN_2;

/// Bits of sqrt(3)/2.
const LEAST: u64 = 0x3feb_b67a_e858_4caa;

/// sqrt(3/2): a larger significand is divided by 3/2.
const MIDDLE: f64 = 1.224_744_871_391_589;

/// log2(3/2) in two parts.
const LOG2_3_2: Pair = Pair { high: 0.584_962_487_220_764_2, low: 1.350_039_202_129_749e-8 };

/// 2/(3 ln(2)) in two parts, and rounded.
const SCALE: Pair = Pair { high: 0.961_796_686_053_276_1, low: 7.872_699_542_894_897e-9 };
const SCALE_ROUNDED: f64 = 0.961_796_693_925_975_6;

/// ln(2) in two parts, of which the first has 26 bits.
const LN_2_PARTS: Pair = Pair { high: 0.693_147_167_563_438_4, low: 1.299_650_689_388_988_9e-8 };

/// Coefficients of `3 (atanh(s)/s - 1 - s^2/3)/s^4` in powers of `s^2`.
const SERIES: [f64; 6] = [
    0.599_999_999_999_994_6,
    0.428_571_428_578_518_93,
    0.333_333_329_829_759_33,
    0.272_728_121_862_551_63,
    0.230_660_903_875_986_56,
    0.206_970_093_211_272_97,
];

/// Powers of two beyond which a result is infinite or 0.
const EXPONENTS: [f64; 2] = [-1080.0, 1025.0];

/// True if the lanes compute this power: of a positive normal number, with an exponent that is not huge.
#[inline(always)]
pub(crate) fn is_plain(base: f64, exponent: f64) -> bool {
    const HUGE: f64 = 1e18;
    is_between(base, f64::MIN_POSITIVE, f64::MAX) & (exponent.abs() <= HUGE)
}

/// Logarithm to base 2 of a positive normal number. The first part has 26 bits, the sum about 70.
#[inline(always)]
fn log2(x: f64) -> Pair {
    let (significand, exponent) = split(x, LEAST);
    let (unit, unit_log) = if significand > MIDDLE { (1.5, LOG2_3_2) } else { (1.0, Pair { high: 0.0, low: 0.0 }) };
    // s = (significand - unit)/(significand + unit), whose logarithm is 2 s + 2/3 s^3 + ...
    let difference = significand - unit;
    let inverse = 1.0 / (significand + unit);
    let s = difference * inverse;
    let s_upper = upper(s);
    let sum_upper = upper(significand + unit);
    let sum_lower = significand - (sum_upper - unit);
    let s_lower = inverse * ((difference - s_upper * sum_upper) - s_upper * sum_lower);
    let square = s * s;
    let [a, b, c, d, e, f] = SERIES;
    let series = a + square * (b + square * (c + square * (d + square * (e + square * f))));
    let beyond = square * square * series + s_lower * (s_upper + s);
    // 3 + s^2 + ..., times s, times 2/(3 ln(2)).
    let square = s_upper * s_upper;
    let factor_upper = upper(3.0 + square + beyond);
    let factor_lower = beyond - ((factor_upper - 3.0) - square);
    let product = s_upper * factor_upper;
    let product_beyond = s_lower * factor_upper + factor_lower * s;
    let product_upper = upper(product + product_beyond);
    let product_lower = product_beyond - (product_upper - product);
    let high = SCALE.high * product_upper;
    let low = SCALE.low * product_upper + product_lower * SCALE_ROUNDED + unit_log.low;
    let sum = upper(((high + low) + unit_log.high) + exponent);
    Pair { high: sum, low: low - (((sum - exponent) - unit_log.high) - high) }
}

/// Power of a plain base and exponent.
#[inline(always)]
pub(crate) fn plain_pow(base: f64, exponent: f64) -> f64 {
    let log = log2(base);
    let (above, below) = halves(exponent);
    let high = above * log.high;
    let low = below * log.high + exponent * log.low;
    let n = nearest(high + low);
    let rest = high - n;
    let rest_upper = upper(rest + low);
    let rest_lower = low - (rest_upper - rest);
    let leading = rest_upper * LN_2_PARTS.high;
    let beyond = rest_lower * LN_2 + rest_upper * LN_2_PARTS.low;
    let r = leading + beyond;
    let r_low = beyond - (r - leading);
    let [least, most] = EXPONENTS;
    let bounded = if n > most { most } else { n };
    let bounded = if bounded < least { least } else { bounded };
    let value = scaled(near_one(Pair { high: r, low: r_low + r_low * r }), bounded);
    let value = if n > most { f64::INFINITY } else { value };
    let value = if n < least { 0.0 } else { value };
    // A square is rounded as a product, which the language makes of a power with a constant exponent.
    if exponent == 2.0 { base * base } else { value }
}

/// `base` to the power of `exponent`: NaN for a negative base and an exponent that is not whole.
pub fn pow(base: f64, exponent: f64) -> f64 {
    if is_plain(base, exponent) {
        plain_pow(base, exponent)
    } else if exponent == 2.0 {
        base * base
    } else {
        libm::pow(base, exponent)
    }
}
