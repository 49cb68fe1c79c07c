//! The one writer of numbers for people, and the way back from what people type.
//!
//! The policy, the same in page, report, figure and program:
//!
//! - A value and its error end at the same digit and share one unit and one power of ten: `0.387 ± 0.004`,
//!   `(1.20 ± 0.05)×10⁶`. The error has two significant digits if its first is 1 or 2, else one ([`with_error`]); in the short
//!   form `9.6093(21)` it always has two ([`concise`]). An error below 10⁻¹⁴ of its value is rounding, and not written.
//! - Between 0.001 and 10⁶ a number is written out, and below that as long as five decimals are enough. Elsewhere a
//!   unit that takes prefixes gets one (`0.5 mm/s`), and only where that is not possible a power of ten is taken out. Its
//!   exponent is a multiple of three, as those of the prefixes are.
//! - All numbers of a group (a column, a quantity in motion, the ticks of an axis) have the same unit, power and number of
//!   decimals ([`Layout`], [`Group`]). So a value that is nothing beside the largest one of its group is written as zero.
//! - Digits before the decimal sign are written in full. A minus sign is a true one, and zero has none. What is not finite
//!   is a dash.
//! - Numbers for programs are exact: [`shortest`] reads back as the same bits.

mod axis;
mod digits;
mod error;
mod exact;
mod group;
mod plain;
mod read;
mod sign;

pub use axis::{axis_unit, common_power, leading_exponent, resolved, scaled_by, tick};
pub use error::{concise, with_error};
pub use exact::{compact, shortest};
pub use group::{Group, Layout};
pub use plain::{decimals, fixed, near_one, plain, roundest, steady};
pub use read::parse;
pub(crate) use sign::symbol_text;
pub use sign::{error_with_unit, superscript, unit_text, with_unit, write_power};

/// How a language writes its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Style {
    /// A comma separates the decimals.
    pub decimal_comma: bool,
}

impl Style {
    /// A decimal point.
    pub const POINT: Self = Self { decimal_comma: false };
    /// A decimal comma.
    pub const COMMA: Self = Self { decimal_comma: true };

    /// The style of a language tag such as `es` or `en-GB`; a point where the language is unknown.
    pub fn of(language: &str) -> Self {
        let primary = language.split(['-', '_']).next().unwrap_or_default();
        let comma = ["es", "de", "fr", "it", "pt", "ca", "gl", "nl", "pl", "ru", "sv", "da", "nb", "fi", "cs", "tr"];
        Self { decimal_comma: comma.contains(&primary.to_ascii_lowercase().as_str()) }
    }

    /// A decimal comma or point.
    pub const fn comma(decimal_comma: bool) -> Self {
        Self { decimal_comma }
    }
}

/// Shown for a number that is not finite.
pub const DASH: &str = "–";
