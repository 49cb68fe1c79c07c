//! Statements of a person about a file: units of columns, and the order of day and month in dates.

use super::head::{self, Meant};
use super::refusal::{ImportError, Refusal};
use super::times::date::{self, DateOrder};
use crate::conversion::Conversion;
use units::Unit;

/// True for a unit by its symbol or a word, or a scale of temperatures: `ms`, `Sekunden`, `°C`.
pub(crate) fn is_unit(text: &str) -> bool {
    head::is_unit(text)
}

/// Unit by its symbol or a word, as written over columns: `ms`, `msec`, `Sekunden`.
pub fn unit(text: &str) -> Option<Unit> {
    head::unit_of(text)
}

/// Unit that a person states for a column of this name, with the conversion of its numbers to values in the unit: all that
/// headings state, such as `°C`.
pub fn stated_unit(text: &str, name: &str) -> Option<(Unit, Option<Conversion>)> {
    let meant = head::meant_unit(text, name).or_else(|| Some(Meant { unit: unit(text)?, reading: None }))?;
    Some((meant.unit, meant.reading.map(|reading| Conversion { tens: 0, reading: Some(reading) })))
}

/// Text with its dates of three numbers, `02/03/2024`, written as `2024-03-02`.
///
/// # Errors
/// A date has the other order.
pub fn state_dates(text: &str, order: DateOrder) -> Result<String, ImportError> {
    let is_part = |letter: char| letter.is_ascii_digit() || matches!(letter, '/' | '-' | '.');
    let mut written = String::with_capacity(text.len());
    let mut rest = text;
    let mut before = ' ';
    while let Some(start) = rest.find(|letter: char| letter.is_ascii_digit()) {
        let (other, from) = rest.split_at(start);
        let (part, after) = from.split_at(from.find(|letter: char| !is_part(letter)).unwrap_or(from.len()));
        let alone = !is_part(other.chars().next_back().unwrap_or(before)) && !other.ends_with(char::is_alphanumeric);
        written.push_str(other);
        match date::in_order(part, order).filter(|_| alone) {
            Some(Ok(date)) => written.push_str(&date),
            Some(Err(())) => {
                let line = 1 + written.matches('\n').count();
                return Err(ImportError::new(Some(line), Refusal::OtherOrder { date: part.to_owned(), order }));
            }
            None => written.push_str(part),
        }
        before = part.chars().next_back().unwrap_or(' ');
        rest = after;
    }
    written.push_str(rest);
    Ok(written)
}
