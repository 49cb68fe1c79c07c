//! Parsing of typed numbers.

use super::Style;

/// Parses a number; returns it with the text after it, both trimmed: `40 cm` gives 40 and `cm`, `1,5×10³` gives 1500 and an
/// empty text. Accepts decimal comma or point, the minus sign U+2212, `e3` and `×10^3`, and blanks between groups of three
/// digits. In a style with decimal points the comma of `13,534` separates thousands. `None` if the text does not begin with
/// a finite number.
pub fn parse(text: &str, style: Style) -> Option<(f64, &str)> {
    let text = text.trim();
    let mut digits = String::new();
    let mut characters = text.char_indices().peekable();
    if let Some(&(_, sign)) = characters.peek()
        && matches!(sign, '-' | '−' | '+')
    {
        if sign != '+' {
            digits.push('-');
        }
        characters.next();
        while characters.next_if(|&(_, character)| character.is_whitespace()).is_some() {}
    }
    let start = characters.peek().map_or(text.len(), |&(at, _)| at);
    let mut end = start;
    while let Some(&(at, character)) = characters.peek() {
        let grouped =
            is_group_blank(character) && three_digits_follow(&text[at + character.len_utf8()..]) && end > start;
        if !(character.is_ascii_digit() || matches!(character, '.' | ',') || grouped) {
            break;
        }
        end = at + character.len_utf8();
        characters.next();
    }
    digits.push_str(&without_groups(&text[start..end], style)?);
    let (exponent, rest) = power_of_ten(&text[end..]);
    let value = super::decimal(&format!("{digits}e{exponent}"))?;
    value.is_finite().then_some((value, rest.trim()))
}

fn is_group_blank(character: char) -> bool {
    matches!(character, ' ' | '\u{a0}' | '\u{202f}' | '\u{2009}')
}

fn three_digits_follow(text: &str) -> bool {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    digits == 3
}

/// The typed digits with at most one decimal point; `None` if they are no number.
fn without_groups(typed: &str, style: Style) -> Option<String> {
    let mut text: String = typed.chars().filter(|character| !character.is_whitespace()).collect();
    if !text.bytes().any(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let thousands = if style.decimal_comma { '.' } else { ',' };
    let mark = if style.decimal_comma { ',' } else { '.' };
    let whole = text.split(mark).next().unwrap_or_default();
    let mut groups = whole.split(thousands);
    let first = groups.next().unwrap_or_default();
    let rest: Vec<&str> = groups.collect();
    let grouped =
        (1..=3).contains(&first.len()) && !first.starts_with('0') && rest.iter().all(|group| group.len() == 3);
    // A single point is always decimal: many Spanish-speaking countries use it.
    let enough = if style.decimal_comma { rest.len() > 1 || text.contains(',') } else { !rest.is_empty() };
    if grouped && enough {
        text = text.replace(thousands, "");
    }
    let text = text.replace(',', ".");
    (text.matches('.').count() <= 1).then_some(text)
}

/// The exponent of `e3`, `E-3`, `×10³` or `*10^3`, and the text after it; 0 if there is none.
fn power_of_ten(text: &str) -> (i32, &str) {
    let none = (0, text);
    let plain = text.strip_prefix(['e', 'E']);
    let tail = text.trim_start();
    let powered = ["×", "*", "·", "x"]
        .iter()
        .find_map(|times| tail.strip_prefix(times))
        .and_then(|tail| tail.trim_start().strip_prefix("10"));
    let Some(tail) = plain.or(powered) else {
        return none;
    };
    let tail = if plain.is_none() { tail.strip_prefix('^').unwrap_or(tail) } else { tail };
    let mut exponent = String::new();
    let mut end = 0;
    for (at, character) in tail.char_indices() {
        let Some(character) = lowered(character) else {
            break;
        };
        if character == '-' && !exponent.is_empty() {
            break;
        }
        exponent.push(character);
        end = at + tail[at..].chars().next().map_or(0, char::len_utf8);
    }
    match exponent.parse() {
        Ok(number) => (number, &tail[end..]),
        Err(_) => none,
    }
}

/// A digit or sign, superscript or not, as ASCII.
fn lowered(character: char) -> Option<char> {
    match character {
        '0'..='9' | '-' => Some(character),
        '−' => Some('-'),
        _ => crate::raised(character),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::plain;

    const POINT: Style = Style::POINT;
    const COMMA: Style = Style::COMMA;

    #[test]
    fn typed_numbers() {
        for (text, style, expected) in [
            ("40 cm", POINT, Some((40.0, "cm"))),
            ("0,5", POINT, Some((0.5, ""))),
            ("0,125", POINT, Some((0.125, ""))),
            ("13,534", POINT, Some((13534.0, ""))),
            ("1,234,567.5 m", POINT, Some((1_234_567.5, "m"))),
            ("13,534", COMMA, Some((13.534, ""))),
            ("13.534", COMMA, Some((13.534, ""))),
            ("1.234.567,5", COMMA, Some((1_234_567.5, ""))),
            ("13 534 kg", POINT, Some((13534.0, "kg"))),
            ("−3", POINT, Some((-3.0, ""))),
            ("- 3e-2m", POINT, Some((-0.03, "m"))),
            ("1,5×10³ Pa s", COMMA, Some((1500.0, "Pa s"))),
            ("2*10^-3", POINT, Some((0.002, ""))),
            (".5", POINT, Some((0.5, ""))),
            ("5 eV", POINT, Some((5.0, "eV"))),
            ("5eV", POINT, Some((5.0, "eV"))),
            ("", POINT, None),
            ("abc", POINT, None),
            ("1.2.3", POINT, None),
            ("1e999", POINT, None),
            ("-", POINT, None),
        ] {
            assert_eq!(parse(text, style), expected, "{text:?}");
        }
    }

    #[test]
    fn what_is_written_reads_back() {
        for value in [1.5e-7, -3.25, 1_234_500.0, 0.001, 9.8, 1e21] {
            for style in [POINT, COMMA] {
                assert_eq!(parse(&plain(value, 12, style), style), Some((value, "")), "{value}");
            }
        }
    }
}
