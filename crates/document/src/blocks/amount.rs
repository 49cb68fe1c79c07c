//! A positive number with its unit in the front matter, and what to write instead of one that cannot be read.

use super::front_matter::Value;
use crate::expressions::wrong_dimension;
use model::{Diagnostic, Span};
use units::number::{Style, parse, shortest};
use units::{Unit, words};

/// A setting: its key, and the unit of a number without one.
#[derive(Clone, Copy)]
pub(super) struct Setting<'a> {
    pub key: &'a str,
    pub unit: &'a Unit,
}

/// Probable meaning of a text that is not in the form `NUMBER [UNIT]`.
struct Meant {
    number: f64,
    /// Unit; empty for that of the setting.
    unit: String,
    reason: Reason,
}

#[derive(Clone, Copy, PartialEq)]
enum Reason {
    Comma,
    Arithmetic,
    Negative,
    Comment,
    /// A unit without its brackets, or with one of them.
    Brackets,
    Form,
}

impl Setting<'_> {
    /// Parses a positive number, bare (then in the unit of the setting) or with a unit of the same dimension in brackets.
    /// Returns its SI value and the unit.
    ///
    /// # Errors
    /// A diagnostic with place, reason and remedy.
    pub fn read(self, value: &Value) -> Result<(f64, Unit), Box<Diagnostic>> {
        let Self { key, unit } = self;
        let Some((number, stated)) = in_form(&value.text) else { return Err(Box::new(self.no_number(value))) };
        if stated.is_empty() {
            return Ok((unit.to_si(number), unit.clone()));
        }
        let whole = number_text(number);
        match Unit::parse(stated) {
            Ok(stated) if stated.dimension == unit.dimension => {
                let shown = if stated.turning(unit) == 1.0 { stated.clone() } else { unit.clone() };
                Ok((stated.to_si_of(number, unit), shown))
            }
            Ok(stated) => {
                let message = words!("`{key}` has the wrong dimension");
                let wrong = wrong_dimension(message, value.span, stated.dimension, unit.dimension);
                Err(Box::new(wrong.with_fix(value.span, with_brackets(&whole, &unit.text))))
            }
            Err(error) => {
                let at = value.text.find(stated).unwrap_or_default();
                Err(Box::new(Diagnostic::of_unit(error, inside(value).start + at, value.span)))
            }
        }
    }

    fn no_number(self, value: &Value) -> Diagnostic {
        let Self { key, unit } = self;
        let positive = words!("`{key}` must be a positive number");
        let Some(Meant { number, unit: stated, reason }) = self.meant(&value.text) else {
            let example = match key {
                "step" => "0.01",
                "speed" => "1",
                "tolerance" => "1e-8",
                _ => "10",
            };
            let example = format!("{key}: {}", with_brackets(example, &unit.text));
            return Diagnostic::error("setting", positive, value.span).with_hint(words!("write `{example}`"));
        };
        let mended = with_brackets(&number_text(number), &stated);
        let part = |text: &str| {
            let start = inside(value).start + value.text.find(text).unwrap_or_default();
            Span::new(start, start + text.len())
        };
        let found = match reason {
            Reason::Comma => {
                let wrong = words("a number has a decimal point here, not a comma");
                Diagnostic::error("decimal-comma", wrong, part(","))
            }
            Reason::Arithmetic => {
                let wrong = words!("`{key}` is a number: nothing is computed here");
                Diagnostic::error("setting", wrong, value.span)
            }
            Reason::Comment => {
                let wrong = words("a comment has a line of its own here");
                Diagnostic::error("setting", wrong, Span::new(part("#").start, inside(value).end))
            }
            Reason::Brackets => {
                let wrong = words("a unit stands in square brackets here");
                Diagnostic::error("unit-without-brackets", wrong, value.span)
            }
            Reason::Negative | Reason::Form => Diagnostic::error("setting", positive, value.span),
        };
        let found = found.with_hint(words!("write `{line}`", line = format!("{key}: {mended}")));
        let found = found.with_fix(value.span, mended);
        // `1,500` is one and a half, or one thousand and five hundred.
        match thousands(&value.text) {
            Some(other) if reason == Reason::Comma => {
                found.with_fix(value.span, with_brackets(&number_text(other), &stated))
            }
            _ => found,
        }
    }

    /// The number and the unit that the text means, if they can be recognised.
    fn meant(self, text: &str) -> Option<Meant> {
        let (text, comment) = match text.split_once('#') {
            Some((before, _)) => (before.trim(), true),
            None => (text.trim(), false),
        };
        let powered =
            if text.starts_with("10^") || text.starts_with("10⁻") { format!("1×{text}") } else { text.to_owned() };
        let (mut number, mut rest) = parse(&powered, Style::COMMA)?;
        let mut reason = if comment { Reason::Comment } else { Reason::Form };
        if let Some((by, after)) = rest.strip_prefix('/').and_then(|rest| parse(rest, Style::COMMA)) {
            (number, rest, reason) = (number / by, after, Reason::Arithmetic);
        }
        let opened = rest.starts_with('[') && rest.ends_with(']');
        if !rest.is_empty() && !opened && reason == Reason::Form {
            reason = Reason::Brackets;
        }
        let comma =
            text.char_indices().any(|(at, c)| c == ',' && text[at + 1..].starts_with(|c: char| c.is_ascii_digit()));
        if comma && reason != Reason::Arithmetic {
            reason = Reason::Comma;
        }
        if number < 0.0 {
            (number, reason) = (-number, Reason::Negative);
        }
        let stated = rest.trim_matches(|c: char| matches!(c, '[' | ']' | '(' | ')') || c.is_whitespace());
        let unit = match stated {
            "" => String::new(),
            "x" | "×" if self.key == "speed" => String::new(),
            "%" if self.key == "speed" => {
                number /= 100.0;
                String::new()
            }
            stated => self.unit_meant(stated)?,
        };
        (number.is_finite() && number > 0.0).then_some(Meant { number, unit, reason })
    }

    /// The unit of the right dimension that a text means: a name such as `seconds` for `s`.
    fn unit_meant(self, stated: &str) -> Option<String> {
        let meant = match Unit::parse(stated) {
            Ok(_) => stated.to_owned(),
            Err(error) => {
                let mut mended = stated.to_owned();
                if error.range.is_empty() {
                    return None;
                }
                mended.replace_range(error.range, &error.meant?);
                mended
            }
        };
        Unit::parse(&meant).is_ok_and(|unit| unit.dimension == self.unit.dimension).then_some(meant)
    }
}

/// The number and the text of its unit in a value of the form `NUMBER [UNIT]`; `None` for another form, and for a number that
/// is not finite and positive.
fn in_form(text: &str) -> Option<(f64, &str)> {
    let (number, stated) = match text.split_once('[') {
        Some((number, rest)) => (number.trim(), rest.trim_end().strip_suffix(']')?),
        None => (text, ""),
    };
    let number: f64 = number.parse().ok()?;
    (number.is_finite() && number > 0.0).then_some((number, stated))
}

/// Place of the text of a value, without quotation marks.
fn inside(value: &Value) -> Span {
    let quoted = usize::from(value.span.end - value.span.start > value.text.len());
    Span::new(value.span.start + quoted, value.span.end - quoted)
}

/// The number in which a comma separates thousands, if it can.
fn thousands(text: &str) -> Option<f64> {
    let (as_point, _) = parse(text, Style::POINT)?;
    let (as_comma, _) = parse(text, Style::COMMA)?;
    (as_point > 0.0 && as_point != as_comma).then_some(as_point)
}

fn number_text(number: f64) -> String {
    shortest(number)
}

fn with_brackets(number: &str, unit: &str) -> String {
    if unit.is_empty() { number.to_owned() } else { format!("{number} [{unit}]") }
}
