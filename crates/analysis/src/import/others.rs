//! Cells that are neither plain numbers nor gaps: words, times of day, numbers with a unit.

use super::clock::{self, Reading};
use super::head;
use super::labels::Labels;
use super::number::{self, Signs};

/// Cells of a column besides plain numbers and gaps.
#[derive(Debug, Default)]
pub(super) struct Others {
    /// Number of words: neither a number, nor a time, nor a number with a unit.
    pub words: usize,
    /// Number of words that hold a digit and are no codes, and line and text of the first.
    pub digits: usize,
    pub first_digits: Option<(usize, String)>,
    /// Line, text and value of the first number in an unusual notation.
    pub notation: Option<(usize, String, f64)>,
    /// Number of words of letters and digits, such as `7BC4`.
    pub codes: usize,
    /// The words, if few are different.
    pub labels: Labels,
    /// Line and text of the first word.
    pub first: Option<(usize, String)>,
    /// Times of day and dates, with their rows.
    pub clocks: Vec<(usize, Reading)>,
    /// Numbers followed by a unit, with their rows.
    pub with_units: Vec<(usize, f64)>,
    /// Unit of the first of these numbers, and true if all others have the same.
    pub unit: Option<(String, bool)>,
    /// Number of listed cells of each kind.
    pub listed: [usize; 3],
}

/// Content of a cell that is neither a plain number nor a gap.
#[derive(Debug)]
pub(super) enum Other {
    Word,
    Clock(Reading),
    WithUnit(f64, String),
}

impl Other {
    pub fn of(text: &str, signs: Signs) -> Self {
        if let Some(reading) = clock::read(text) {
            return Self::Clock(reading);
        }
        match number::with_unit(text, signs) {
            Some((value, unit)) if head::is_unit(unit) => Self::WithUnit(value, unit.to_owned()),
            _ => Self::Word,
        }
    }
}
