//! Errors of units, with their messages.

use crate::{Words, table, words};
use std::fmt;
use std::ops::Range;

/// Reason why a text is not a unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitError {
    /// Stable identifier: `unknown-unit`, `temperature-scale`, `ambiguous-unit` or `malformed-unit`.
    pub code: &'static str,
    /// Byte range in the text.
    pub range: Range<usize>,
    /// Description of the error.
    pub message: Words,
    /// Advice on how to correct it, if any.
    pub hint: Option<Box<Words>>,
    /// Suggested replacement of the text at `range`, if any.
    pub meant: Option<String>,
}

/// The English message.
impl fmt::Display for UnitError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message.english())
    }
}

impl std::error::Error for UnitError {}

/// An error at a byte range of the text, without advice.
pub(crate) fn error(code: &'static str, range: Range<usize>, message: Words) -> UnitError {
    UnitError { code, range, message, hint: None, meant: None }
}

/// Adds advice to an error.
pub(crate) fn hinting(mut error: UnitError, hint: Words) -> UnitError {
    error.hint = Some(Box::new(hint));
    error
}

/// Error of an exponent beyond its bound.
pub(crate) fn too_high(range: Range<usize>) -> UnitError {
    error("malformed-unit", range, words("an exponent of this unit is too large"))
}

/// Error of a temperature scale in the place of a unit. In a product or quotient it is one of differences.
pub(crate) fn temperature_scale(text: &str, range: Range<usize>) -> UnitError {
    hinting(
        error(
            "temperature-scale",
            range,
            words!("{text} is a scale with a zero of its own, so it cannot be multiplied like a unit"),
        ),
        words("give temperatures in [K] (20 degC is 293.15 [K]); a difference of 1 degC is 1 [K], as in [J/(kg degC)]"),
    )
}

/// Error of an unknown symbol, with a suggestion if one is similar.
pub(crate) fn unknown(text: &str, range: Range<usize>) -> UnitError {
    if text.eq_ignore_ascii_case("celsius") {
        return temperature_scale(text, range);
    }
    let wrong = error("unknown-unit", range, words!("there is no unit `{text}`"));
    match table::near(text) {
        Some(near) => {
            let hint = words!("did you mean {near}?");
            UnitError { meant: Some(near), ..hinting(wrong, hint) }
        }
        None => wrong,
    }
}
