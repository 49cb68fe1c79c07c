//! The functions for many numbers at once. Each result has the bits of the scalar function.

use crate::{arctangent, circular, exponential, hyperbolic, logarithm, power};

/// Numbers computed together: two registers of eight lanes, or more of fewer.
const LANES: usize = 16;

/// Replaces each value by `plain` of it in lanes, where all values of a block are plain; otherwise by `scalar`.
#[inline(always)]
fn each(values: &mut [f64], is_plain: impl Fn(f64) -> bool, plain: impl Fn(f64) -> f64, scalar: impl Fn(f64) -> f64) {
    let (blocks, rest) = values.as_chunks_mut::<LANES>();
    for block in blocks {
        if block.iter().fold(true, |all, &value| all & is_plain(value)) {
            block.iter_mut().for_each(|value| *value = plain(*value));
        } else {
            block.iter_mut().for_each(|value| *value = scalar(*value));
        }
    }
    rest.iter_mut().for_each(|value| *value = scalar(*value));
}

/// [`each`] for functions of two numbers; the results replace the values of `first`.
#[inline(always)]
fn each_of_two(
    first: &mut [f64],
    second: &[f64],
    is_plain: impl Fn(f64, f64) -> bool,
    plain: impl Fn(f64, f64) -> f64,
    scalar: impl Fn(f64, f64) -> f64,
) {
    let count = first.len().min(second.len());
    let ((blocks, rest), (others, beside)) =
        (first[..count].as_chunks_mut::<LANES>(), second[..count].as_chunks::<LANES>());
    for (block, other) in blocks.iter_mut().zip(others) {
        let pairs = block.iter().zip(other);
        if pairs.fold(true, |all, (&a, &b)| all & is_plain(a, b)) {
            block.iter_mut().zip(other).for_each(|(a, &b)| *a = plain(*a, b));
        } else {
            block.iter_mut().zip(other).for_each(|(a, &b)| *a = scalar(*a, b));
        }
    }
    rest.iter_mut().zip(beside).for_each(|(a, &b)| *a = scalar(*a, b));
}

/// Replaces each angle, rad, by its sine.
#[inline(always)]
pub fn sin_all(values: &mut [f64]) {
    each(values, circular::is_plain, circular::plain_sin, circular::sin);
}

/// Replaces each angle, rad, by its cosine.
#[inline(always)]
pub fn cos_all(values: &mut [f64]) {
    each(values, circular::is_plain, circular::plain_cos, circular::cos);
}

/// Replaces each angle, rad, by its tangent.
#[inline(always)]
pub fn tan_all(values: &mut [f64]) {
    each(values, circular::is_plain, circular::plain_tan, circular::tan);
}

/// Replaces each value by its exponential function.
#[inline(always)]
pub fn exp_all(values: &mut [f64]) {
    each(values, exponential::is_plain, exponential::plain_exp, exponential::exp);
}

/// Replaces each value by its natural logarithm.
#[inline(always)]
pub fn ln_all(values: &mut [f64]) {
    each(values, logarithm::is_plain, logarithm::plain_ln, logarithm::ln);
}

/// Replaces each value by its hyperbolic sine.
#[inline(always)]
pub fn sinh_all(values: &mut [f64]) {
    each(values, |_| true, hyperbolic::plain_sinh, hyperbolic::sinh);
}

/// Replaces each value by its hyperbolic cosine.
#[inline(always)]
pub fn cosh_all(values: &mut [f64]) {
    each(values, |_| true, hyperbolic::plain_cosh, hyperbolic::cosh);
}

/// Replaces each value by its hyperbolic tangent.
#[inline(always)]
pub fn tanh_all(values: &mut [f64]) {
    each(values, |_| true, hyperbolic::plain_tanh, hyperbolic::tanh);
}

/// Replaces each value by its arctangent, rad.
#[inline(always)]
pub fn atan_all(values: &mut [f64]) {
    each(values, |_| true, arctangent::plain_atan, arctangent::atan);
}

/// Replaces each height by the angle of the point with this height and the width at the same place, rad. Both have one length.
#[inline(always)]
pub fn atan2_all(heights: &mut [f64], widths: &[f64]) {
    each_of_two(heights, widths, arctangent::is_plain, arctangent::plain_atan2, arctangent::atan2);
}

/// Replaces each base by its power with the exponent at the same place. Both have one length.
#[inline(always)]
pub fn pow_all(bases: &mut [f64], exponents: &[f64]) {
    each_of_two(bases, exponents, power::is_plain, power::plain_pow, power::pow);
}
