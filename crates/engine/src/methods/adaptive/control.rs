//! Step control of the embedded pairs: a proportional-integral controller (E. Hairer and G. Wanner, *Solving Ordinary Differential
//! Equations II*, 1996, section IV.2).
//!
//! Its powers are computed to seven digits by a few operations without branches, in lanes as well. A step size needs no more digits,
//! and exact powers took longer than the steps of small models.

use std::f64::consts::{LN_2, LOG2_E};

/// Exponent of the error before in the controller.
const INTEGRAL: f64 = 0.04;

/// Factor by which the step grows after an error that is allowed, before it is bounded. `before`: error of the step before, not 0;
/// both in units of the allowed error.
#[inline(always)]
pub fn growth(order: f64, before: f64, error: f64) -> f64 {
    0.9 * power_of_two(INTEGRAL * logarithm(before) - proportional(order) * logarithm(error.max(1e-10)))
}

/// Factor by which the step shrinks after an error that is not allowed, before it is bounded; nearly 0 if the error is not finite.
#[inline(always)]
pub fn shrinkage(order: f64, error: f64) -> f64 {
    0.9 * power_of_two(-proportional(order) * logarithm(error))
}

/// Exponent of the last error.
#[inline(always)]
fn proportional(order: f64) -> f64 {
    1.0 / order - 0.75 * INTEGRAL
}

/// Logarithm to base 2 of the magnitude of a normal number, with an error below 1e-7; about 1024 for a number that is not finite.
#[inline(always)]
fn logarithm(x: f64) -> f64 {
    const ROOT: u64 = std::f64::consts::FRAC_1_SQRT_2.to_bits();
    const ONE: u64 = 1.0_f64.to_bits();
    /// 2^52, in whose last bits a whole number stands.
    const WHOLE: f64 = 4_503_599_627_370_496.0;
    let bits = x.abs().to_bits();
    // The mantissa is between the roots of 1/2 and 2.
    let exponent = bits.wrapping_sub(ROOT).wrapping_add(ONE) >> 52;
    let mantissa = f64::from_bits(bits.wrapping_sub(exponent.wrapping_sub(ONE >> 52) << 52));
    let whole = f64::from_bits(WHOLE.to_bits() | exponent) - (WHOLE + 1023.0);
    // Series of the inverse hyperbolic tangent.
    let s = (mantissa - 1.0) / (mantissa + 1.0);
    let square = s * s;
    let series = s * (1.0 + square * (1.0 / 3.0 + square * (1.0 / 5.0 + square * (1.0 / 7.0))));
    whole + 2.0 * LOG2_E * series
}

/// 2 to the power of `x`, with a relative error below 1e-7, for `x` from -1000 to 1000.
#[inline(always)]
fn power_of_two(x: f64) -> f64 {
    /// Adding it rounds to a whole number, which stands in the last bits then.
    const ROUNDER: f64 = 6_755_399_441_055_744.0;
    let shifted = x + ROUNDER;
    let scale = f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52);
    let r = (x - (shifted - ROUNDER)) * LN_2;
    let series = 1.0
        + r * (1.0
            + r * (1.0 / 2.0
                + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0 + r * (1.0 / 720.0 + r / 5040.0))))));
    scale * series
}

#[cfg(test)]
mod tests {
    use super::{growth, shrinkage};

    #[test]
    fn factors_are_the_powers() {
        for order in [3.0, 4.0, 5.0] {
            let exponent = 1.0 / order - 0.03;
            for place in -60..=60 {
                let error = libm::exp2(f64::from(place) / 2.3);
                let expected = 0.9 / libm::pow(error, exponent);
                assert!((shrinkage(order, error) / expected - 1.0).abs() < 2e-7, "{error}");
                for before in [1e-4, 0.013, 0.7, 1.0] {
                    let expected = 0.9 * libm::pow(before, 0.04) / libm::pow(error.max(1e-10), exponent);
                    assert!((growth(order, before, error) / expected - 1.0).abs() < 2e-7, "{before} {error}");
                }
            }
        }
    }

    #[test]
    fn errors_that_are_not_finite_shrink_the_step() {
        for error in [f64::INFINITY, f64::NAN, -f64::NAN, f64::MAX] {
            assert!(shrinkage(5.0, error) < 1e-40, "{error}");
        }
        assert!(growth(5.0, 1e-4, 0.0) > 10.0);
    }
}
