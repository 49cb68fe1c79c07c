//! What cells hold that are neither plain numbers nor gaps: words, times of day, numbers with a unit behind them.

use super::clock::{self, Reading};
use super::head;
use super::number::{self, Signs};

/// What the cells of a column hold besides plain numbers and gaps.
#[derive(Debug, Default)]
pub(super) struct Others {
    /// Words: neither a number, nor a time, nor a number with a unit.
    pub words: usize,
    /// The first word, and its line.
    pub first: Option<(usize, String)>,
    /// Times of day and dates, with their rows.
    pub clocks: Vec<(usize, Reading)>,
    /// Numbers with a unit behind them, with their rows.
    pub with_units: Vec<(usize, f64)>,
    /// The unit of the first of those, and whether all others have the same.
    pub unit: Option<(String, bool)>,
    /// How many cells of each kind have been listed.
    pub listed: [usize; 3],
}

/// What a cell holds that is neither a plain number nor a gap.
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
