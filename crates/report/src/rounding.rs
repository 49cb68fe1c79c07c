//! The [numbers](units::number) of a report.

use units::Unit;
use units::number::{self, Style};

pub use units::number::{DASH, unit_text as unit};

/// A value and its standard error, `9.6093(21)`, as [`number::concise`] writes them.
pub fn with_error(value: f64, error: Option<f64>, comma: bool) -> String {
    number::concise(value, error, Style::comma(comma))
}

/// A standard error with two significant digits: `0.0020`.
pub fn error(value: f64, comma: bool) -> String {
    number::steady(value, 2, Style::comma(comma))
}

/// As [`number::plain`].
pub fn plain(value: f64, digits: usize, comma: bool) -> String {
    number::plain(value, digits, Style::comma(comma))
}

/// As [`number::steady`].
pub fn significant(value: f64, digits: usize, comma: bool) -> String {
    number::steady(value, digits, Style::comma(comma))
}

/// As [`number::fixed`].
pub fn fixed(value: f64, decimals: usize, comma: bool) -> String {
    number::fixed(value, decimals, Style::comma(comma))
}

/// As [`number::near_one`].
pub fn share(value: f64, comma: bool) -> String {
    number::near_one(value, Style::comma(comma))
}

/// A unit in which differences of about `size` (SI) are easy to read, as [`Unit::for_residuals`] finds it. The part of
/// `shown` that it is, and how it is printed.
pub fn readable(shown: &Unit, size: f64) -> (f64, String) {
    let unit = shown.for_residuals(shown.from_si(size).abs());
    (unit.factor / shown.factor, number::unit_text(&unit.text))
}
