//! Sine, cosine and tangent. The angle is reduced to at most pi/4 by subtracting a multiple of pi/2 in three parts (W. J. Cody
//! and W. Waite, *Software Manual for the Elementary Functions*, 1980, chapter 8): the first two products are exact.

use crate::pair::{Pair, ROUNDER, SIGN, halves, signed};
use core::f64::consts::{FRAC_2_PI, FRAC_PI_4};

/// Largest angle that is reduced here. The number of quarter turns has 16 bits then.
const MOST: f64 = 1e5;

/// pi/2 in three parts; the first two have 37 bits.
const QUARTER: [f64; 3] = [1.570_796_326_792_333_3, 2.563_344_151_583_955_8e-12, 1.056_299_906_698_742_8e-23];

/// Coefficients of `(sin(r)/r - 1)/r^2` in powers of `r^2`.
const SINE: [f64; 6] = [
    -0.166_666_666_666_666_3,
    0.008_333_333_333_321_84,
    -0.000_198_412_698_293_585_06,
    2.755_731_353_854_090_3e-6,
    -2.505_073_440_633_097_8e-8,
    1.589_543_539_169_705_8e-10,
];

/// Coefficients of `(cos(r) - 1 + r^2/2)/r^4` in powers of `r^2`.
const COSINE: [f64; 6] = [
    0.041_666_666_666_666_595,
    -0.001_388_888_888_887_334,
    2.480_158_728_899_978e-5,
    -2.755_731_421_617_315_6e-7,
    2.087_570_525_724_766e-9,
    -1.135_874_186_727_418_5e-11,
];

/// An angle within pi/4 and the number of quarter turns that were subtracted, in the two lowest bits of `quarters`.
struct Reduced {
    angle: Pair,
    quarters: u64,
}

/// Reduces a magnitude of at most [`MOST`].
#[inline(always)]
fn reduced(magnitude: f64) -> Reduced {
    let shifted = magnitude * FRAC_2_PI + ROUNDER;
    let turns = shifted - ROUNDER;
    let rest = magnitude - turns * QUARTER[0];
    // A rest smaller than the second part is a multiple of the last bit of that part: the difference is exact.
    let angle = Pair::difference(rest, turns * QUARTER[1]).corrected(-(turns * QUARTER[2]));
    Reduced { angle, quarters: shifted.to_bits() }
}

/// `sin(r) - r` within pi/4; `square` is that of `r`.
#[inline(always)]
fn sine_series(r: f64, square: f64) -> f64 {
    let [a, b, c, d, e, f] = SINE;
    r * square * (a + square * (b + square * (c + square * (d + square * (e + square * f)))))
}

/// `cos(r) - 1 + square/2` within pi/4.
#[inline(always)]
fn cosine_series(square: f64) -> f64 {
    let [a, b, c, d, e, f] = COSINE;
    square * square * (a + square * (b + square * (c + square * (d + square * (e + square * f)))))
}

/// `sin(angle) - angle.high` within pi/4.
#[inline(always)]
fn sine_beyond(angle: Pair, square: f64) -> f64 {
    sine_series(angle.high, square) + (angle.low - 0.5 * square * angle.low)
}

/// `cos(angle) - 1 + square/2` within pi/4.
#[inline(always)]
fn cosine_beyond(angle: Pair, square: f64) -> f64 {
    cosine_series(square) - angle.high * angle.low
}

/// Sine within pi/4.
#[inline(always)]
fn sine(angle: Pair) -> f64 {
    angle.high + sine_beyond(angle, angle.high * angle.high)
}

/// Cosine within pi/4.
#[inline(always)]
fn cosine(angle: Pair) -> f64 {
    let square = angle.high * angle.high;
    Pair::difference(1.0, 0.5 * square).corrected(cosine_beyond(angle, square)).value()
}

/// True if the lanes compute this angle.
#[inline(always)]
pub(crate) fn is_plain(x: f64) -> bool {
    x.abs() <= MOST
}

/// Sine of a plain angle.
#[inline(always)]
pub(crate) fn plain_sin(x: f64) -> f64 {
    let Reduced { angle, quarters } = reduced(x.abs());
    let value = if quarters & 1 == 0 { sine(angle) } else { cosine(angle) };
    f64::from_bits(value.to_bits() ^ ((quarters & 2) << 62) ^ (x.to_bits() & SIGN))
}

/// Cosine of a plain angle.
#[inline(always)]
pub(crate) fn plain_cos(x: f64) -> f64 {
    let Reduced { angle, quarters } = reduced(x.abs());
    let value = if quarters & 1 == 0 { cosine(angle) } else { sine(angle) };
    f64::from_bits(value.to_bits() ^ ((quarters.wrapping_add(1) & 2) << 62))
}

/// Tangent of a plain angle: the quotient of sine and cosine, both with their rounding errors.
#[inline(always)]
pub(crate) fn plain_tan(x: f64) -> f64 {
    let Reduced { angle, quarters } = reduced(x.abs());
    let square = angle.high * angle.high;
    let (above, below) = halves(angle.high);
    let square_error = ((above * above - square) + 2.0 * above * below) + below * below;
    let sine = Pair::sum(angle.high, sine_beyond(angle, square));
    let cosine = Pair::difference(1.0, 0.5 * square);
    let cosine = Pair::sum(cosine.high, cosine.low + (cosine_beyond(angle, square) - 0.5 * square_error));
    let (numerator, denominator) = if quarters & 1 == 0 { (sine, cosine) } else { (cosine, sine) };
    let value = numerator.over(denominator).value();
    f64::from_bits(value.to_bits() ^ ((quarters & 1) << 63) ^ (x.to_bits() & SIGN))
}

/// Sine of `x`, rad.
pub fn sin(x: f64) -> f64 {
    let magnitude = x.abs();
    if magnitude <= FRAC_PI_4 {
        signed(magnitude + sine_series(magnitude, magnitude * magnitude), x)
    } else if is_plain(x) {
        plain_sin(x)
    } else {
        libm::sin(x)
    }
}

/// Cosine of `x`, rad.
pub fn cos(x: f64) -> f64 {
    let magnitude = x.abs();
    if magnitude <= FRAC_PI_4 {
        let square = magnitude * magnitude;
        Pair::difference(1.0, 0.5 * square).corrected(cosine_series(square)).value()
    } else if is_plain(x) {
        plain_cos(x)
    } else {
        libm::cos(x)
    }
}

/// Tangent of `x`, rad.
pub fn tan(x: f64) -> f64 {
    if is_plain(x) { plain_tan(x) } else { libm::tan(x) }
}
