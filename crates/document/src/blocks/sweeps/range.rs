//! Range of a sweep and its numbers: `1..12 [rad/s] step 0.1`.

use crate::expressions::{Expressions, wrong_dimension};
use crate::text::source::trim;
use model::{Diagnostic, Phrase, Span};
use std::ops::Range;
use units::{Unit, words};

/// Ends of a range, and the distance between its values (SI).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Least value.
    pub low: f64,
    /// Greatest value.
    pub high: f64,
    /// Distance of the values; `None` if it is not stated.
    pub step: Option<f64>,
}

/// Reads `1..12 [rad/s] step 0.1`. Bare numbers are in the stated unit, or else in `unit`; the result is in SI units.
pub(super) fn limits(expressions: &mut Expressions, phrase: Phrase, unit: &Unit) -> Option<Limits> {
    let source = expressions.source;
    let step = phrase.split_last(&["step"]);
    let before = step.map_or(phrase, |step| step.before);
    let (ends, dots) = (before.span(), before.operand.dots?);
    let text = &source[ends.range()];
    let units = match text.find('[') {
        Some(bracket) => (&stated(expressions, ends.start + bracket..ends.end, unit)?, unit),
        None => (unit, unit),
    };
    let upper = dots.end..text.find('[').map_or(ends.end, |bracket| ends.start + bracket);
    let low = number(expressions, trim(source, ends.start..dots.start), units)?;
    let high = number(expressions, trim(source, upper), units)?;
    let step = match step {
        Some(step) => Some(number(expressions, step.after.span().range(), units)?),
        None => None,
    };
    if low >= high || step.is_some_and(|step| step <= 0.0) {
        malformed(expressions, &phrase.span().range());
        return None;
    }
    Some(Limits { low, high, step })
}

/// Reads `60 [s]`, the time from which a run is evaluated: a non-negative number with the dimension of the independent
/// variable. Returns the SI value.
pub(super) fn moment(expressions: &mut Expressions, place: Span) -> Option<f64> {
    let unit = expressions.model().independent.unit.clone();
    let text = &expressions.source[place.range()];
    let bracket = text.find('[');
    let value = positive(&text[..bracket.unwrap_or(text.len())], &unit);
    let Some(value) = value else {
        let message = words("the time from which a run counts must be a number, 0 or greater");
        let stated = if unit.text.is_empty() { String::new() } else { format!(" [{unit}]") };
        expressions.diagnostics.push(
            Diagnostic::error("sweep", message, place).with_hint(words!("write it out, as in `from 60{stated}`")),
        );
        return None;
    };
    match bracket {
        Some(_) => number(expressions, place.range(), (&unit, &unit)),
        None => Some(value),
    }
}

/// Parses a non-negative number in `unit`. Returns the SI value.
fn positive(text: &str, unit: &Unit) -> Option<f64> {
    let value = text.trim().parse::<f64>().ok().map(|value| unit.to_si(value))?;
    (value.is_finite() && value >= 0.0).then_some(value)
}

/// Parses a number for a quantity stated in `own`: bare (then in `unit`) or with a unit of the same dimension. Returns the SI
/// value.
fn number(expressions: &mut Expressions, range: Range<usize>, (unit, own): (&Unit, &Unit)) -> Option<f64> {
    let text = &expressions.source[range.clone()];
    let (digits, unit) = match text.find('[') {
        Some(bracket) => (&text[..bracket], &stated(expressions, range.start + bracket..range.end, unit)?),
        None => (text, unit),
    };
    let value = digits.trim().parse::<f64>().ok().map(|value| unit.to_si_of(value, own));
    let value = value.filter(|value| value.is_finite());
    if value.is_none() {
        malformed(expressions, &range);
    }
    value
}

/// Parses `[rad/s]`, which must have the dimension of `unit`.
fn stated(expressions: &mut Expressions, range: Range<usize>, unit: &Unit) -> Option<Unit> {
    let text = &expressions.source[range.clone()];
    let Some(inner) = text.strip_prefix('[').and_then(|text| text.trim_end().strip_suffix(']')) else {
        malformed(expressions, &range);
        return None;
    };
    match Unit::parse(inner) {
        Ok(found) if found.dimension == unit.dimension => Some(found),
        Ok(found) => {
            let message = words("this unit has the wrong dimension");
            let place = Span::new(range.start, range.end);
            expressions.diagnostics.push(wrong_dimension(message, place, found.dimension, unit.dimension));
            None
        }
        Err(error) => {
            expressions.diagnostics.push(Diagnostic::of_unit(
                error,
                range.start + 1,
                Span::new(range.start, range.end),
            ));
            None
        }
    }
}

fn malformed(expressions: &mut Expressions, range: &Range<usize>) {
    expressions.diagnostics.push(
        Diagnostic::error("sweep", words("this is no range of values"), Span::new(range.start, range.end))
            .with_hint(words("write numbers, the smaller one first: `omega in 1..12 [rad/s] step 0.1`")),
    );
}
