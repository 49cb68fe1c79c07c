//! Number of digits of a value that its error justifies.

use super::plain::exponent;

/// True if an error determines the digits of a value: it is positive, finite and greater than rounding errors of double
/// precision.
pub(super) fn is_error(value: f64, error: f64) -> bool {
    const ROUNDING: f64 = 1e-14;
    value.is_finite() && error.is_finite() && error > 0.0 && error >= ROUNDING * value.abs()
}

/// Decimal exponent of the last digit written of an error after `±`.
pub(super) fn last_digit(error: f64) -> i32 {
    let text = format!("{error:.1e}");
    exponent(error, 2) - i32::from(text.starts_with(['1', '2']))
}
