//! Reading of what a person types into a field of a number: the number, with its unit or without, or the reason why it is
//! none. Every field of the page is read here, so that nothing is replaced in silence.

use super::{Style, parse, plain, unit_text, with_unit};
use crate::{Unit, Words, words};
use std::ops::RangeInclusive;

/// Maximum length of a typed text in a message, in characters.
const SHOWN: usize = 40;

/// Number in the examples of messages.
const EXAMPLE: f64 = 2.5;

/// Reason for which a typed text is not the number of a field.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotRead {
    /// Nothing was typed.
    Empty,
    /// The text is not a number.
    NotANumber {
        /// Typed text.
        typed: String,
        /// A number as it could be typed, with its unit.
        example: String,
    },
    /// Unknown unit.
    UnknownUnit {
        /// Unit in the text.
        typed: String,
        /// A number as it could be typed, with its unit.
        example: String,
    },
    /// The unit has another dimension.
    WrongUnit {
        /// Unit in the text.
        typed: String,
        /// A suitable unit; empty for a pure number.
        expected: String,
    },
    /// The text is not a unit.
    NotAUnit {
        /// Typed text.
        typed: String,
        /// A suitable unit.
        example: String,
    },
    /// The text is not a whole number within the bounds of the field.
    NotWhole {
        /// Typed text.
        typed: String,
        /// Least and greatest number.
        range: [String; 2],
    },
}

impl NotRead {
    /// Message that names the text that was refused and a text that would be read.
    pub fn words(&self) -> Words {
        match self {
            Self::Empty => words("Type a number."),
            Self::NotANumber { typed, example } => {
                words!("“{typed}” is not a number. Write one such as {example}.")
            }
            Self::UnknownUnit { typed, example } => {
                words!("“{typed}” is not a known unit. Write a number such as {example}.")
            }
            Self::WrongUnit { typed, expected } if expected.is_empty() => {
                words!("{typed} measures something else; this is a pure number.")
            }
            Self::WrongUnit { typed, expected } => {
                words!("{typed} measures something else; a unit such as {expected} is needed.")
            }
            Self::NotAUnit { typed, example } => {
                words!("“{typed}” is not a known unit. Write one such as {example}.")
            }
            Self::NotWhole { typed, range: [least, greatest] } if typed.is_empty() => {
                words!("Type a whole number from {least} to {greatest}.")
            }
            Self::NotWhole { typed, range: [least, greatest] } => {
                words!("“{typed}” is not possible here. Write a whole number from {least} to {greatest}.")
            }
        }
    }
}

/// Text shortened for a message.
pub fn shortened(typed: &str) -> String {
    typed.trim().chars().take(SHOWN).collect()
}

/// SI value of a typed quantity: a number in `unit`, or with its own unit of the same dimension, with or without brackets.
/// 1 Hz is read as 2 pi rad/s where `unit` counts angles, and the reverse. A per cent sign is a unit of pure numbers.
///
/// # Errors
/// The text is empty, is not a finite number, or its unit is unknown or has another dimension.
pub fn quantity(typed: &str, unit: &Unit, style: Style) -> Result<f64, NotRead> {
    let example = || with_unit(&plain(EXAMPLE, 2, style), unit);
    let (value, rest) = number(typed, style, example)?;
    let si = if rest.is_empty() { unit.to_si(value) } else { of_unit(value, rest, unit, typed, example)? };
    if si.is_finite() { Ok(si) } else { Err(NotRead::NotANumber { typed: shortened(typed), example: example() }) }
}

fn of_unit(value: f64, rest: &str, unit: &Unit, typed: &str, example: impl Fn() -> String) -> Result<f64, NotRead> {
    let stated = rest.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).unwrap_or(rest);
    let own = Unit::parse(stated).map_err(|_| {
        let is_operator = |c: char| c.is_ascii_punctuation() && c != '%' || "×·÷−±".contains(c);
        match stated.starts_with(is_operator) {
            true => NotRead::NotANumber { typed: shortened(typed), example: example() },
            false => NotRead::UnknownUnit { typed: shortened(stated), example: example() },
        }
    })?;
    if own.dimension != unit.dimension {
        return Err(NotRead::WrongUnit { typed: shortened(stated), expected: unit_text(&unit.text) });
    }
    Ok(own.to_si_of(value, unit))
}

/// A typed unit. `expected`: unit of the quantity, if it is known; the typed one must have its dimension.
///
/// # Errors
/// The text is not a unit, or one of another dimension.
pub fn unit(typed: &str, expected: Option<&Unit>) -> Result<Unit, NotRead> {
    let example = || expected.map_or_else(|| "cm/s".to_owned(), |unit| unit_text(&unit.text));
    let unit = Unit::parse(typed).map_err(|_| NotRead::NotAUnit { typed: shortened(typed), example: example() })?;
    if expected.is_some_and(|expected| expected.dimension != unit.dimension) {
        return Err(NotRead::WrongUnit { typed: shortened(typed), expected: example() });
    }
    Ok(unit)
}

/// A typed number in a unit that is none of physics, such as `px`: the number alone, or with this `symbol` after it.
///
/// # Errors
/// The text is empty, is not a finite number, or something else stands after it.
pub fn counted(typed: &str, symbol: &str, style: Style) -> Result<f64, NotRead> {
    let example = || format!("{} {symbol}", plain(EXAMPLE, 2, style)).trim_end().to_owned();
    let (value, rest) = number(typed, style, example)?;
    if rest.is_empty() || rest == symbol {
        return Ok(value);
    }
    match Unit::parse(rest) {
        Ok(_) => Err(NotRead::WrongUnit { typed: shortened(rest), expected: symbol.to_owned() }),
        Err(_) => Err(NotRead::NotANumber { typed: shortened(typed), example: example() }),
    }
}

/// A typed whole number within `range`; `10.0` is one.
///
/// # Errors
/// The text is empty, is not a whole number, lies outside the range, or has a unit.
pub fn whole(typed: &str, range: RangeInclusive<i64>, style: Style) -> Result<i64, NotRead> {
    let whole = parse(typed, style).filter(|(value, rest)| rest.is_empty() && value.fract() == 0.0);
    let inside = whole.map(|(value, _)| value as i64).filter(|value| range.contains(value));
    let bounds = || [range.start(), range.end()].map(i64::to_string);
    inside.ok_or_else(|| NotRead::NotWhole { typed: shortened(typed), range: bounds() })
}

/// The number at the start of the text, and the text after it.
fn number(typed: &str, style: Style, example: impl Fn() -> String) -> Result<(f64, &str), NotRead> {
    if typed.trim().is_empty() {
        return Err(NotRead::Empty);
    }
    parse(typed, style).ok_or_else(|| NotRead::NotANumber { typed: shortened(typed), example: example() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Language;

    fn said(read: Result<f64, NotRead>) -> Result<f64, String> {
        read.map_err(|why| why.words().text(Language::English).into_owned())
    }

    #[test]
    fn fields_are_read_with_units_or_refused_with_a_remedy() {
        let text = include_str!("typed.txt");
        let mut lines = 0;
        for line in text.lines().filter(|line| line.contains(" | ")) {
            let fields: Vec<&str> = line.split(" | ").map(str::trim).collect();
            let [kind, style, typed, expected] = fields.as_slice() else { panic!("{line}") };
            let style = Style::comma(*style == "comma");
            let found = said(match *kind {
                "px" => counted(typed, "px", style),
                "whole" => whole(typed, 1..=100, style).map(|value| value as f64),
                unit => quantity(typed, &Unit::parse(unit).unwrap(), style),
            });
            let found = found.map_or_else(|why| why, |value| format!("{value}"));
            assert_eq!(found, *expected, "{line}");
            lines += 1;
        }
        assert!(lines >= 40);
    }

    /// The example of each refusal is a number that the same field reads.
    #[test]
    fn what_a_refusal_proposes_is_read() {
        for unit in ["s", "m", "1", "%", "deg", "1/s", "kg m/s^2"] {
            let unit = Unit::parse(unit).unwrap_or_else(|_| Unit::dimensionless());
            for style in [Style::POINT, Style::COMMA] {
                for typed in ["abc", "3 furlongs"] {
                    let (NotRead::NotANumber { example, .. } | NotRead::UnknownUnit { example, .. }) =
                        quantity(typed, &unit, style).unwrap_err()
                    else {
                        panic!("{typed}")
                    };
                    assert_eq!(quantity(&example, &unit, style), Ok(unit.to_si(EXAMPLE)), "{example}");
                }
            }
        }
        let NotRead::NotANumber { example, .. } = counted("abc", "px", Style::POINT).unwrap_err() else { panic!() };
        assert_eq!(counted(&example, "px", Style::POINT), Ok(EXAMPLE));
    }
}
