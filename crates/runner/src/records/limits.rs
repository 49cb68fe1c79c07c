//! `--from` and `--until`: the used part of a record or film.

use crate::refusal::Refusal;
use std::ops::RangeInclusive;
use units::{Dimension, Unit, words};

/// Interval from `from` to `until`, SI; infinite where a limit is not stated. A number without a unit is in `unit`, the
/// unit of the file, or in seconds if the file has none.
///
/// # Errors
/// A limit is not a finite number or has a unit of another dimension, or the end is not after the beginning.
pub fn limits(from: Option<&str>, until: Option<&str>, unit: Option<&Unit>) -> Result<RangeInclusive<f64>, Refusal> {
    let limit = |name: &'static str, text: Option<&str>| text.map(|text| reading(name, text, unit)).transpose();
    let (begin, end) = (limit("--from", from)?, limit("--until", until)?);
    if let (Some(begin), Some(end)) = (begin, end)
        && end <= begin
    {
        return Err(nothing_between(from.unwrap_or_default(), until.unwrap_or_default()));
    }
    Ok(begin.unwrap_or(f64::NEG_INFINITY)..=end.unwrap_or(f64::INFINITY))
}

/// Error for `--until` not after `--from`. Both are given as typed.
pub fn nothing_between(from: &str, until: &str) -> Refusal {
    Refusal::in_words(
        words!("--until {until} is not after --from {from}: nothing lies between them"),
        words("give --until a later time than --from, or leave one of them out"),
    )
}

/// Parses a value of the independent variable: `1.5` in the unit of the file, `1500 ms` or `1500 [ms]` in its own.
/// Returns SI.
fn reading(name: &'static str, text: &str, unit: Option<&Unit>) -> Result<f64, Refusal> {
    let text = text.trim();
    let hint = || words!("write a number, such as {name} 1.5, or one with its unit, such as {name} '1500 [ms]'");
    let end = text.find(|c: char| !(c.is_ascii_digit() || "+-.eE".contains(c))).unwrap_or(text.len());
    let (number, rest) = text.split_at(end);
    let Some(value) = number.trim().parse::<f64>().ok() else {
        let infinite = text.parse::<f64>().is_ok();
        return Err(if infinite { unbounded(name, text) } else { wrong(name, text, hint()) });
    };
    if !value.is_finite() {
        return Err(unbounded(name, text));
    }
    let rest = rest.trim().trim_start_matches('[').trim_end_matches(']').trim();
    if rest.is_empty() {
        return Ok(unit.map_or(value, |unit| unit.to_si(value)));
    }
    let Ok(own) = Unit::parse(rest) else {
        return Err(Refusal::in_words(words!("{name} {text}: `{rest}` is not a known unit"), hint()));
    };
    if own.dimension == unit.map_or(Dimension::TIME, |unit| unit.dimension) {
        return Ok(unit.map_or_else(|| own.to_si(value), |unit| own.to_si_of(value, unit)));
    }
    Err(match unit.filter(|unit| unit.dimension != Dimension::TIME) {
        None => Refusal::in_words(words!("{name} {text}: {rest} is not a unit of time"), hint()),
        Some(Unit { text: of_file, .. }) => Refusal::in_words(
            words!(
                "{name} {text}: the file measures against a column in {of_file}, and {rest} is another kind of unit"
            ),
            words!("write {name} '{number} [{of_file}]'"),
        ),
    })
}

fn wrong(name: &str, text: &str, hint: units::Words) -> Refusal {
    Refusal::in_words(words!("{name} {text} is not a number"), hint)
}

fn unbounded(name: &'static str, text: &str) -> Refusal {
    Refusal::in_words(words!("{name} {text} is not a finite number"), words!("leave {name} out to set no limit there"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_have_the_unit_of_the_file_or_their_own() {
        let milliseconds = Unit::parse("ms").ok();
        let from = |text: &str, unit: Option<&Unit>| limits(Some(text), None, unit).ok().map(|limits| *limits.start());
        assert_eq!(from("1.5", None), Some(1.5));
        assert_eq!(from("1.5", milliseconds.as_ref()), Some(0.0015));
        assert_eq!(from("-2e3 [ms]", None), Some(-2.0));
        assert_eq!(from(" 2 s", milliseconds.as_ref()), Some(2.0));
        assert_eq!(from("90 [deg]", Unit::parse("rad").ok().as_ref()), Some(std::f64::consts::FRAC_PI_2));
        assert_eq!(limits(None, None, None).ok(), Some(f64::NEG_INFINITY..=f64::INFINITY));
    }
}
