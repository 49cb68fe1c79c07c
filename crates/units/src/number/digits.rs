//! How many digits of a value its error makes known.

use super::plain::exponent;

/// Whether an error says how many digits of a value are known: one that is positive, finite, and greater than what computing in
/// doubles leaves of its own.
pub(super) fn is_error(value: f64, error: f64) -> bool {
    const ROUNDING: f64 = 1e-14;
    value.is_finite() && error.is_finite() && error > 0.0 && error >= ROUNDING * value.abs()
}

/// The exponent of the last digit that is written of an error after `±`.
pub(super) fn last_digit(error: f64) -> i32 {
    let text = format!("{error:.1e}");
    exponent(error, 2) - i32::from(text.starts_with(['1', '2']))
}
