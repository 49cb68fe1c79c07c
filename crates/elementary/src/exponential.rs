//! The exponential function: 2^n e^r with `|r|` at most ln(2)/2, where even and odd part of `e^r` are one polynomial each.

use crate::pair::{Pair, nearest, power_of_two};
use core::f64::consts::LOG2_E;

/// ln(2) in two parts; a product of the first, which has 40 bits, with an exponent is exact.
pub(crate) const LN_2: [f64; 2] = [0.693_147_180_559_208_2, 7.371_002_565_167_799e-13];

/// Coefficients of `(cosh(r) - 1)/r^2` in powers of `r^2`.
const EVEN: [f64; 6] = [
    0.5,
    0.041_666_666_666_666_685,
    0.001_388_888_888_887_328_3,
    2.480_158_734_920_199e-5,
    2.755_725_182_003_897_3e-7,
    2.092_177_034_163_309e-9,
];

/// Coefficients of `(sinh(r)/r - 1)/r^2` in powers of `r^2`.
const ODD: [f64; 5] = [
    0.166_666_666_666_666_77,
    0.008_333_333_333_321_386,
    0.000_198_412_698_868_147_73,
    2.755_724_345_324_970_4e-6,
    2.510_932_067_536_984_2e-8,
];

/// `x` minus the multiple `n` of ln(2) that is nearest, and `n`.
#[inline(always)]
pub(crate) fn reduced(x: f64) -> (Pair, f64) {
    let n = nearest(x * LOG2_E);
    (Pair::difference(x - n * LN_2[0], n * LN_2[1]), n)
}

/// `cosh(r) - 1` and `sinh(r) - r`.
#[inline(always)]
pub(crate) fn even_and_odd(r: f64) -> (f64, f64) {
    let square = r * r;
    let [a, b, c, d, e, f] = EVEN;
    let even = square * (a + square * (b + square * (c + square * (d + square * (e + square * f)))));
    let [a, b, c, d, e] = ODD;
    let odd = r * square * (a + square * (b + square * (c + square * (d + square * e))));
    (even, odd)
}

/// e^r for `|r|` up to ln(2)/2.
#[inline(always)]
pub(crate) fn near_one(r: Pair) -> f64 {
    let (even, odd) = even_and_odd(r.high);
    Pair::sum(1.0, r.high).corrected(r.low + (odd + even)).value()
}

/// `x` times 2^n for `n` from -2040 to 2040. The first product is exact for `x` near 1, so that a subnormal result is rounded
/// once.
#[inline(always)]
pub(crate) fn scaled(x: f64, n: f64) -> f64 {
    let half = nearest(0.5 * n);
    x * power_of_two(half) * power_of_two(n - half)
}

/// True if the lanes compute this argument: the result is a normal number.
#[inline(always)]
pub(crate) fn is_plain(x: f64) -> bool {
    x.abs() <= 708.0
}

/// e^x of a plain argument.
#[inline(always)]
pub(crate) fn plain_exp(x: f64) -> f64 {
    let (r, n) = reduced(x);
    near_one(r) * power_of_two(n)
}

/// e^x.
pub fn exp(x: f64) -> f64 {
    if is_plain(x) {
        return plain_exp(x);
    }
    // Beyond these bounds the result is infinite or 0.
    let (r, n) = reduced(if x.is_nan() { x } else { x.clamp(-746.0, 710.0) });
    scaled(near_one(r), n)
}
