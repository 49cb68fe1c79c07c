//! Formatting of numbers for readers, and parsing of typed numbers.
//!
//! The rules, common to page, report, figure and program:
//!
//! - A value and its error end at the same digit and share unit and power of ten: `0.387 ± 0.004`, `(1.20 ± 0.05)×10⁶`. The
//!   error has two significant digits if its first digit is 1 or 2, otherwise one ([`with_error`]); in the concise form
//!   `9.6093(21)` it always has two ([`concise`]). An error below 10⁻¹⁴ of its value is rounding and is not written.
//! - Numbers from 0.001 to 10⁶ are written in full, smaller ones if five decimals are enough. Otherwise the unit gets a
//!   prefix (`0.5 mm/s`); if that is not possible, a power of ten is factored out. Its exponent is a multiple of three,
//!   like those of the prefixes.
//! - All numbers of a group (a column, a moving quantity, the ticks of an axis) have the same unit, power and number of
//!   decimals ([`Layout`], [`Group`]). A value negligible beside the largest one of its group is therefore written as zero.
//! - All digits before the decimal sign are written. The minus sign is U+2212, and zero has none. A value that is not
//!   finite is written as a dash.
//! - Numbers for programs are exact: [`shortest`] is read back as the same bits by [`decimal()`].

mod axis;
mod decimal;
mod digits;
mod error;
mod exact;
mod group;
mod plain;
mod read;
mod sign;
pub mod typed;

pub use axis::{axis_unit, common_power, leading_exponent, resolved, scaled_by, tick};
pub use decimal::decimal;
pub use error::{concise, with_error};
pub use exact::{compact, shortest};
pub use group::{Group, Layout};
pub use plain::{decimals, fixed, near_one, plain, roundest, steady};
pub use read::parse;
pub(crate) use sign::symbol_text;
pub use sign::{error_with_unit, superscript, unit_text, with_unit, write_power};

/// Style of numbers in a language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Style {
    /// True for a decimal comma, false for a decimal point.
    pub decimal_comma: bool,
}

impl Style {
    /// A decimal point.
    pub const POINT: Self = Self { decimal_comma: false };
    /// A decimal comma.
    pub const COMMA: Self = Self { decimal_comma: true };

    /// Style for a language tag such as `es` or `en-GB`; a decimal point for unknown languages.
    pub fn of(language: &str) -> Self {
        let primary = language.split(['-', '_']).next().unwrap_or_default();
        let comma = ["es", "de", "fr", "it", "pt", "ca", "gl", "nl", "pl", "ru", "sv", "da", "nb", "fi", "cs", "tr"];
        Self { decimal_comma: comma.contains(&primary.to_ascii_lowercase().as_str()) }
    }

    /// A decimal comma if true, otherwise a decimal point.
    pub const fn comma(decimal_comma: bool) -> Self {
        Self { decimal_comma }
    }
}

/// Text for a number that is not finite.
pub const DASH: &str = "–";
