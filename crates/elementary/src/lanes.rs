//! The functions for many numbers at once. Each result has the bits of the scalar function.

use crate::{arctangent, circular, exponential, hyperbolic, logarithm, power};

/// Numbers computed together: a register of the widest processors, or several of others.
const LANES: usize = 8;

/// Replaces each value by `plain` of it in lanes, where all values of a block are plain; otherwise by `scalar`. A macro, because
/// a function that is passed as a value is compiled without the processor features of the caller.
macro_rules! lanes {
    ($values:expr, $is_plain:path, $plain:path, $scalar:path) => {{
        let (blocks, rest) = $values.as_chunks_mut::<LANES>();
        for block in blocks {
            let mut all = true;
            for &value in block.iter() {
                all &= $is_plain(value);
            }
            if all {
                for value in block.iter_mut() {
                    *value = $plain(*value);
                }
            } else {
                for value in block.iter_mut() {
                    *value = $scalar(*value);
                }
            }
        }
        for value in rest {
            *value = $scalar(*value);
        }
    }};
}

/// [`lanes`] for functions of two numbers; the results replace the values of `first`.
macro_rules! lanes_of_two {
    ($first:expr, $second:expr, $is_plain:path, $plain:path, $scalar:path) => {{
        let count = $first.len().min($second.len());
        let (blocks, rest) = $first[..count].as_chunks_mut::<LANES>();
        let (others, beside) = $second[..count].as_chunks::<LANES>();
        for (block, other) in blocks.iter_mut().zip(others) {
            let mut all = true;
            for (&a, &b) in block.iter().zip(other) {
                all &= $is_plain(a, b);
            }
            if all {
                for (a, &b) in block.iter_mut().zip(other) {
                    *a = $plain(*a, b);
                }
            } else {
                for (a, &b) in block.iter_mut().zip(other) {
                    *a = $scalar(*a, b);
                }
            }
        }
        for (a, &b) in rest.iter_mut().zip(beside) {
            *a = $scalar(*a, b);
        }
    }};
}

/// True for functions whose lanes compute every argument.
#[inline(always)]
fn always(_: f64) -> bool {
    true
}

/// Replaces each angle, rad, by its sine.
#[inline(always)]
pub fn sin_all(values: &mut [f64]) {
    lanes!(values, circular::is_plain, circular::plain_sin, circular::sin);
}

/// Replaces each angle, rad, by its cosine.
#[inline(always)]
pub fn cos_all(values: &mut [f64]) {
    lanes!(values, circular::is_plain, circular::plain_cos, circular::cos);
}

/// Replaces each angle, rad, by its tangent.
#[inline(always)]
pub fn tan_all(values: &mut [f64]) {
    lanes!(values, circular::is_plain, circular::plain_tan, circular::tan);
}

/// Replaces each value by its exponential function.
#[inline(always)]
pub fn exp_all(values: &mut [f64]) {
    lanes!(values, exponential::is_plain, exponential::plain_exp, exponential::exp);
}

/// Replaces each value by its natural logarithm.
#[inline(always)]
pub fn ln_all(values: &mut [f64]) {
    lanes!(values, logarithm::is_plain, logarithm::plain_ln, logarithm::ln);
}

/// Replaces each value by its hyperbolic sine.
#[inline(always)]
pub fn sinh_all(values: &mut [f64]) {
    lanes!(values, always, hyperbolic::plain_sinh, hyperbolic::sinh);
}

/// Replaces each value by its hyperbolic cosine.
#[inline(always)]
pub fn cosh_all(values: &mut [f64]) {
    lanes!(values, always, hyperbolic::plain_cosh, hyperbolic::cosh);
}

/// Replaces each value by its hyperbolic tangent.
#[inline(always)]
pub fn tanh_all(values: &mut [f64]) {
    lanes!(values, always, hyperbolic::plain_tanh, hyperbolic::tanh);
}

/// Replaces each value by its arctangent, rad.
#[inline(always)]
pub fn atan_all(values: &mut [f64]) {
    lanes!(values, always, arctangent::plain_atan, arctangent::atan);
}

/// Replaces each height by the angle of the point with this height and the width at the same place, rad. Both have one length.
#[inline(always)]
pub fn atan2_all(heights: &mut [f64], widths: &[f64]) {
    lanes_of_two!(heights, widths, arctangent::is_plain, arctangent::plain_atan2, arctangent::atan2);
}

/// Replaces each base by its power with the exponent at the same place. Both have one length.
#[inline(always)]
pub fn pow_all(bases: &mut [f64], exponents: &[f64]) {
    lanes_of_two!(bases, exponents, power::is_plain, power::plain_pow, power::pow);
}
