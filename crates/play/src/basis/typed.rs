//! Converts typed arithmetic to the syntax of the model's language: `15/4 s`, `2π/(1,672 1/s)`, `3 m + 20 cm`.

use units::Unit;
use units::number::Style;

/// Maximum length of a typed value, in bytes.
pub(crate) const LONGEST: usize = 300;

/// Maximum length of a typed unit, in characters.
const LONGEST_UNIT: usize = 40;

/// One interpretation of the typed text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Candidate {
    /// Expression in the model's language, with units in brackets.
    pub expression: String,
    /// Unit of the whole expression, whose numbers then have none.
    pub unit: Option<Unit>,
}

/// Possible interpretations of the typed text, the more likely first. A unit at the end belongs to the whole expression
/// (`15/4 s` is 3.75 s) or to the last number (`5 m + 20 cm`); the dimensions decide.
pub(crate) fn candidates(typed: &str, style: Style) -> Vec<Candidate> {
    if typed.len() > LONGEST {
        return Vec::new();
    }
    let typed = plain_signs(typed, style);
    let whole = unit_at_end(&typed).map(|(head, unit)| Candidate { expression: with_brackets(head), unit: Some(unit) });
    whole.into_iter().chain([Candidate { expression: with_brackets(&typed), unit: None }]).collect()
}

/// Replaces typographic operators by those of the language, and decimal commas by points. With decimal commas,
/// semicolons separate lists.
fn plain_signs(typed: &str, style: Style) -> String {
    let sign = |character: char| match character {
        '×' | '·' | '⋅' => '*',
        '÷' | ':' => '/',
        '−' | '–' => '-',
        '\u{a0}' | '\u{202f}' | '\u{2009}' => ' ',
        ',' if style.decimal_comma => '.',
        ';' if style.decimal_comma => ',',
        other => other,
    };
    let mut out = String::new();
    for character in typed.trim().chars().map(sign) {
        // `2π` is a product.
        if character == 'π' && out.ends_with(|c: char| c.is_ascii_digit() || c == ')') {
            out.push('*');
        }
        out.push(character);
    }
    out
}

/// Splits off a unit at the end: (text before it, unit).
fn unit_at_end(text: &str) -> Option<(&str, Unit)> {
    let begins = |(at, character): (usize, char)| {
        let (head, tail) = text.split_at(at);
        let before = head.trim_end().chars().next_back()?;
        // The `1` of `1/s` is not a digit of the preceding number.
        let apart = head.ends_with(' ') || !character.is_ascii_digit();
        let follows = (before.is_ascii_digit() || matches!(before, '.' | ')')) && apart && character != ' ';
        let unit = follows.then(|| unit(tail)).flatten()?;
        Some((head.trim_end(), unit))
    };
    text.char_indices().filter(|(at, _)| *at > 0).find_map(begins)
}

fn unit(text: &str) -> Option<Unit> {
    let text = text.trim();
    if text.is_empty() || text.chars().count() > LONGEST_UNIT {
        return None;
    }
    Unit::parse(text).ok().filter(|unit| !unit.text.is_empty())
}

/// Puts brackets around the units after numbers.
fn with_brackets(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    let mut inside_name = false;
    while let Some(first) = rest.chars().next() {
        let length = if inside_name { 0 } else { number_length(rest) };
        if length == 0 {
            // Text in brackets is already a unit.
            let end = if first == '[' { rest.find(']').map_or(rest.len(), |end| end + 1) } else { first.len_utf8() };
            out.push_str(&rest[..end]);
            rest = &rest[end..];
            inside_name = first.is_alphanumeric() || first == '_';
            continue;
        }
        out.push_str(&rest[..length]);
        rest = &rest[length..];
        inside_name = false;
        let after = rest.trim_start_matches(' ');
        // Before a unit in brackets, `in` is the keyword and not an inch.
        let is_word = after.strip_prefix("in").is_some_and(|rest| rest.trim_start().starts_with('['));
        let unit = if is_word { 0 } else { unit_at_start(after, after.len() < rest.len()) };
        if unit > 0 {
            let unit = after[..unit].trim_end();
            out.extend([" [", unit, "]"]);
            rest = &after[unit.len()..];
        }
    }
    out
}

/// Length in bytes of the number at the start: digits, a point, an exponent; 0 if there is none.
pub(crate) fn number_length(text: &str) -> usize {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let whole = digits(text);
    let fraction = text[whole..].strip_prefix('.').map_or(0, |rest| 1 + digits(rest));
    if whole == 0 && fraction < 2 {
        return 0;
    }
    let length = whole + fraction;
    let exponent = text[length..].strip_prefix(['e', 'E']).map_or(0, |rest| {
        let sign = usize::from(rest.starts_with(['+', '-']));
        let digits = digits(&rest[sign..]);
        if digits > 0 { 1 + sign + digits } else { 0 }
    });
    length + exponent
}

/// Length in bytes of the longest unit at the start; 0 if there is none.
fn unit_at_start(text: &str, after_blank: bool) -> usize {
    let symbol = text.starts_with(|c: char| c.is_alphabetic() || matches!(c, '%' | '°'));
    let reciprocal = after_blank && text.starts_with("1/");
    if !(symbol || reciprocal) {
        return 0;
    }
    let end = text.find([')', '+', ',', ';', '[']).unwrap_or(text.len());
    let ends = text[..end].char_indices().map(|(at, character)| at + character.len_utf8()).take(LONGEST_UNIT);
    let complete = |end: &usize| {
        let name_goes_on = |c: char| c.is_alphanumeric() || matches!(c, '_' | '(' | '\'');
        !text[*end..].starts_with(name_goes_on) && unit(&text[..*end]).is_some()
    };
    ends.filter(complete).last().unwrap_or(0)
}

/// All units in brackets.
pub(crate) fn stated_units(expression: &str) -> impl Iterator<Item = Unit> {
    expression.split('[').skip(1).filter_map(|rest| Unit::parse(rest.split(']').next()?).ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(typed: &str, style: Style) -> Vec<String> {
        let text = |candidate: Candidate| match candidate.unit {
            Some(unit) => format!("({}) {unit}", candidate.expression),
            None => candidate.expression,
        };
        candidates(typed, style).into_iter().map(text).collect()
    }

    #[test]
    fn units_need_no_brackets() {
        for (typed, expected) in [
            ("15/4", &["15/4"][..]),
            ("15/4 s", &["(15/4) s", "15/4 [s]"]),
            ("2*pi/(1.672 1/s)", &["2*pi/(1.672 [1/s])"]),
            ("2*pi/1.672 1/s", &["(2*pi/1.672) 1/s", "2*pi/1.672 [1/s]"]),
            ("2·π/(1.672 rad/s)", &["2*π/(1.672 [rad/s])"]),
            ("2π/(1.672 rad/s)", &["2*π/(1.672 [rad/s])"]),
            ("sqrt(2)", &["sqrt(2)"]),
            ("sqrt(2) s", &["(sqrt(2)) s", "sqrt(2) s"]),
            ("5 m + 20 cm", &["(5 [m] + 20) cm", "5 [m] + 20 [cm]"]),
            ("2*11 s", &["(2*11) s", "2*11 [s]"]),
            ("9.8 m/s^2*2 s", &["(9.8 [m/s^2]*2) s", "9.8 [m/s^2]*2 [s]"]),
            ("3 [m]/2", &["3 [m]/2"]),
            ("2 sin(1)", &["2 sin(1)"]),
            ("log10(2)", &["log10(2)"]),
            ("h_2 - 2e-3 m", &["(h_2 - 2e-3) m", "h_2 - 2e-3 [m]"]),
            ("30°/2", &["30 [°]/2"]),
            ("", &[""]),
        ] {
            assert_eq!(read(typed, Style::POINT), expected, "{typed}");
        }
        assert_eq!(read("hypot(1,5; 2)", Style::COMMA), ["hypot(1.5, 2)"]);
        assert!(read(&"1+".repeat(LONGEST), Style::POINT).is_empty());
    }
}
