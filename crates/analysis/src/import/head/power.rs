//! Powers of ten in headings: `10^3 v (m/s)`, `v (10^-3 m/s)`, `v / 10^-3 m/s`, `I x 10^-3 (A)`.

use super::unit_words;

/// Greatest absolute exponent in a heading.
const LARGEST: i32 = 18;

/// Certainty of the meaning of a power of ten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sense {
    /// There is only one meaning.
    Clear,
    /// The usual meaning: for `I x 10^-3 (A)`, the numbers are multiples of 10^-3 A.
    Usual,
    /// Ambiguous, as `v*1000 (m/s)`: no conversion is applied.
    Open,
}

/// Power of ten, and the heading without it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Power {
    pub heading: String,
    /// Exponent of ten by which the number of a cell is multiplied to give the value in the unit.
    pub tens: i32,
    pub sense: Sense,
}

/// Notation of a power of ten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// Power: `10^3`, `10³`, `1e3`.
    Power,
    /// Number: `1000`, `0.001`.
    Number,
    /// `10E3`, which programs read as 10^4 and people as 10^3.
    Doubtful,
}

/// Sign before a power of ten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sign {
    None,
    Times,
    Asterisk,
    Slash,
}

/// Separates the power of ten from a heading; `None` without one.
pub(super) fn taken(cell: &str) -> Option<Power> {
    let (start, end, tens, form) = token(cell)?;
    let (before, sign) = signed(cell.get(..start)?);
    let (after, joined) = unsigned(cell.get(end..)?);
    let mut found = match unclosed(before) {
        Some(open) => inside(before, open, after, (tens, form, sign)),
        None if before.is_empty() => prefix(after, joined, (tens, form, sign)),
        None => outside(before, after, (tens, form, sign)),
    }?;
    if form == Form::Doubtful || token(&found.heading).is_some_and(|(_, _, _, form)| form == Form::Power) {
        found.sense = Sense::Open;
    }
    Some(found)
}

fn power(heading: String, tens: i32, sense: Sense) -> Option<Power> {
    let heading = heading.trim().trim_end_matches(['/', ',']).trim_end().to_owned();
    (!heading.is_empty()).then_some(Power { heading, tens, sense })
}

fn is_unit(text: &str) -> bool {
    !text.is_empty() && (unit_words::read(text).is_some() || unit_words::level(text).is_some())
}

/// Reads `v (10^-3 m/s)`, `v [x10^-3]`, `v / (10^-3 m/s)`: the numbers are multiples of the text in brackets.
fn inside(before: &str, open: usize, after: &str, (tens, form, sign): (i32, Form, Sign)) -> Option<Power> {
    let (name, rest) = before.split_at(open);
    let bracket = rest.get(..1)?;
    let close = after.find(closing(bracket))?;
    let (behind, rest_behind) = (after.get(..close)?, after.get(close..)?);
    let unit = [rest.get(1..)?.trim(), behind.trim()].join(" ").trim().to_owned();
    if (!unit.is_empty() && !is_unit(&unit)) || name.trim().is_empty() {
        return None;
    }
    let sense = match (sign, form) {
        (Sign::Slash, _) => Sense::Open,
        (Sign::None, Form::Number) => return None,
        _ => Sense::Clear,
    };
    let heading = if unit.is_empty() {
        format!("{}{}", name.trim_end(), rest_behind.get(1..)?)
    } else {
        format!("{name}{bracket}{unit}{rest_behind}")
    };
    power(heading, tens, sense)
}

/// Reads `10^3 v (m/s)`, `1000*v`, `10^3/T (1/K)`: the cell holds the product.
fn prefix(after: &str, joined: bool, (tens, form, sign): (i32, Form, Sign)) -> Option<Power> {
    let reciprocal = after.starts_with('/');
    let name = after.split(['(', '[', '<', '{', '/']).next().unwrap_or(after).trim();
    if after.is_empty() || (form == Form::Number && !joined && !reciprocal && (is_unit(name) || name == after)) {
        return None;
    }
    let heading = if reciprocal { format!("1{after}") } else { after.to_owned() };
    let plain = form == Form::Number && !joined && !reciprocal;
    // `10^3 N` may be a unit alone.
    let sense = if sign != Sign::None || plain || is_unit(after) { Sense::Open } else { Sense::Clear };
    power(heading, -tens, sense)
}

/// Reads `v / 10^-3 m/s`, `v ×10⁻³ m/s`, `I x 10^-3 (A)`, `v (m/s) x10^-3`.
fn outside(before: &str, after: &str, (tens, form, sign): (i32, Form, Sign)) -> Option<Power> {
    let bracketed = after.starts_with(['(', '[', '<', '{']);
    let unit = is_unit(after) && !bracketed;
    let heading = if unit {
        let stem = before.trim_end_matches([',', ':']).trim_end();
        let stem = [" in", " en", " em"].iter().find_map(|word| stem.strip_suffix(word)).unwrap_or(stem);
        format!("{stem} [{after}]")
    } else {
        format!("{before} {after}")
    };
    let rest = after.is_empty() || bracketed;
    let exact = form != Form::Number;
    let sense = match sign {
        // `Score/100` is a score, without a power.
        Sign::Slash if after.is_empty() && !exact => return None,
        Sign::Slash if rest || unit => Sense::Clear,
        Sign::Times | Sign::None if unit && exact => Sense::Clear,
        Sign::Times if exact && rest => Sense::Usual,
        Sign::None if !exact => return None,
        Sign::Times | Sign::Asterisk | Sign::None if exact || rest || unit => Sense::Open,
        _ => return None,
    };
    power(heading, tens, sense)
}

/// Position of the last bracket that is not closed.
fn unclosed(text: &str) -> Option<usize> {
    let mut open: Vec<usize> = Vec::new();
    for (at, character) in text.char_indices() {
        match character {
            '(' | '[' | '<' | '{' => open.push(at),
            ')' | ']' | '>' | '}' => {
                open.pop();
            }
            _ => {}
        }
    }
    open.pop()
}

fn closing(bracket: &str) -> char {
    match bracket {
        "(" => ')',
        "[" => ']',
        "<" => '>',
        _ => '}',
    }
}

/// Text without the sign at its end.
fn signed(text: &str) -> (&str, Sign) {
    let text = text.trim_end();
    let sign = match text.chars().next_back() {
        Some('×' | '·' | '⋅' | '✕') => Sign::Times,
        Some('*') => Sign::Asterisk,
        Some('/') => Sign::Slash,
        // An x after a blank or a bracket is a sign, because `x 10` is not a name.
        Some('x' | 'X') if text.get(..text.len() - 1).is_some_and(|text| text.ends_with([' ', '(', '[', ')', ']'])) => {
            Sign::Times
        }
        _ => Sign::None,
    };
    if sign == Sign::None {
        return (text, sign);
    }
    let length = text.chars().next_back().map_or(0, char::len_utf8);
    (text.get(..text.len() - length).unwrap_or(text).trim_end(), sign)
}

/// Text without a multiplication sign at its beginning; true if there was one.
fn unsigned(text: &str) -> (&str, bool) {
    let text = text.trim();
    let rest = text.strip_prefix(['*', '×', '·', '⋅']).or_else(|| text.strip_prefix("x "));
    (rest.unwrap_or(text).trim_start(), rest.is_some())
}

/// First power of ten: begin, end, exponent and notation.
fn token(cell: &str) -> Option<(usize, usize, i32, Form)> {
    let mut before = ' ';
    for (start, character) in cell.char_indices() {
        let begins =
            matches!(character, '0' | '1') && !(before.is_numeric() || matches!(before, '.' | ',' | '^' | '_'));
        // After a letter it is part of a name, `CH1000`, except after the x of a product.
        let apart = !before.is_alphabetic() || (matches!(before, 'x' | 'X') && is_product(cell, start));
        if begins
            && apart
            && let Some((length, tens, form)) = cell.get(start..).and_then(number)
            && tens != 0
            && tens.abs() <= LARGEST
        {
            return Some((start, start + length, tens, form));
        }
        before = character;
    }
    None
}

/// True if the x before this position follows a blank or a bracket.
fn is_product(cell: &str, place: usize) -> bool {
    cell.get(..place).is_some_and(|text| signed(text).1 == Sign::Times)
}

/// Power of ten at the beginning of a text: length in bytes, exponent and notation.
fn number(text: &str) -> Option<(usize, i32, Form)> {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let (whole, rest) = text.split_at(digits);
    if whole == "10" {
        if let Some((length, tens)) = raised(rest) {
            return Some((digits + length, tens, Form::Power));
        }
        if let Some((length, tens)) = exponent(rest) {
            return Some((digits + length, tens + 1, Form::Doubtful));
        }
    }
    if whole == "1" {
        let point = [".0", ",0", ".", ""].into_iter().find(|point| rest.starts_with(*point)).unwrap_or_default();
        let (length, tens) = exponent(&rest[point.len()..])?;
        return Some((digits + point.len() + length, tens, Form::Power));
    }
    if whole == "0" {
        let fraction = rest.strip_prefix(['.', ','])?;
        let zeros = fraction.bytes().take_while(|byte| *byte == b'0').count();
        let ends = fraction.get(zeros..)?.strip_prefix('1')?;
        return ends_number(ends).then_some((digits + 2 + zeros, -(zeros as i32) - 1, Form::Number));
    }
    let zeros = whole.strip_prefix('1')?;
    let is_power = zeros.len() >= 2 && zeros.len() <= 15 && zeros.bytes().all(|byte| byte == b'0');
    (is_power && ends_number(rest)).then_some((digits, zeros.len() as i32, Form::Number))
}

/// True at the end of a number: neither a digit nor a letter follows.
fn ends_number(rest: &str) -> bool {
    !rest.starts_with(|next: char| next.is_alphanumeric() || matches!(next, '.' | ','))
}

/// Digit or sign of a superscript: `2` for `²`; `None` for other characters.
pub(in crate::import) fn superscript(character: char) -> Option<char> {
    if character == '⁺' { Some('+') } else { units::raised(character) }
}

/// Reads `^3`, `^{-3}`, `**3`, `⁻³`: length in bytes and exponent.
fn raised(text: &str) -> Option<(usize, i32)> {
    let sign = text.trim_start();
    let blanks = text.len() - sign.len();
    if let Some(rest) = sign.strip_prefix('^').or_else(|| sign.strip_prefix("**")) {
        let mark = sign.len() - rest.len();
        let inner = rest.trim_start_matches(['{', '(']);
        let brackets = rest.len() - inner.len();
        let (length, tens) = signed_digits(inner)?;
        let closed = inner.get(length..)?.bytes().take(brackets).take_while(|byte| matches!(byte, b'}' | b')')).count();
        return (closed == brackets).then_some((blanks + mark + brackets + length + closed, tens));
    }
    let plain: String = text.chars().map_while(superscript).collect();
    let length = text.chars().map_while(|character| superscript(character).map(|_| character.len_utf8())).sum();
    plain.parse().ok().map(|tens| (length, tens))
}

/// Reads `e-3`: length in bytes and exponent.
fn exponent(text: &str) -> Option<(usize, i32)> {
    let rest = text.strip_prefix(['e', 'E'])?;
    let (length, tens) = signed_digits(rest)?;
    ends_number(rest.get(length..)?).then_some((1 + length, tens))
}

fn signed_digits(text: &str) -> Option<(usize, i32)> {
    let rest = text.trim_start_matches(['-', '+', '−', '–']);
    let sign = text.get(..text.len() - rest.len())?;
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    let tens: i32 = rest.get(..digits).filter(|_| digits <= 2)?.parse().ok()?;
    Some((sign.len() + digits, if sign.is_empty() || sign == "+" { tens } else { -tens }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use Sense::{Clear, Open, Usual};

    #[test]
    fn powers_have_the_sense_of_their_place() {
        for (cell, heading, tens, sense) in [
            ("10^3 v (m/s)", "v (m/s)", -3, Clear),
            ("10³ v (m/s)", "v (m/s)", -3, Clear),
            ("10^-3 v", "v", 3, Clear),
            ("10^{-3}·v [m/s]", "v [m/s]", 3, Clear),
            ("1000*v (m/s)", "v (m/s)", -3, Clear),
            ("1e3 v (m/s)", "v (m/s)", -3, Clear),
            ("10^3/T (1/K)", "1/T (1/K)", -3, Clear),
            ("1000/T (1/K)", "1/T (1/K)", -3, Clear),
            ("v (10^-3 m/s)", "v (m/s)", -3, Clear),
            ("v (x10^-3 m/s)", "v (m/s)", -3, Clear),
            ("v [×10⁻³ m/s]", "v [m/s]", -3, Clear),
            ("v (1E-3 m/s)", "v (m/s)", -3, Clear),
            ("v (m/s x 10^-3)", "v (m/s)", -3, Clear),
            ("v (x10^-3)", "v", -3, Clear),
            ("v (x1000 m/s)", "v (m/s)", 3, Clear),
            ("v / 10^-3 m/s", "v [m/s]", -3, Clear),
            ("v /10^-3 m/s", "v [m/s]", -3, Clear),
            ("v / (10^-3 m/s)", "v / (m/s)", -3, Clear),
            ("v/1000 (m/s)", "v (m/s)", 3, Clear),
            ("v ×10⁻³ m/s", "v [m/s]", -3, Clear),
            ("v in 10^-3 m/s", "v [m/s]", -3, Clear),
            ("I x 10^-3 (A)", "I (A)", -3, Usual),
            ("v x10^-3 (m/s)", "v (m/s)", -3, Usual),
            ("v (m/s) x10^3", "v (m/s)", 3, Usual),
            ("v*1000 (m/s)", "v (m/s)", 3, Open),
            ("v*10^3 (m/s)", "v (m/s)", 3, Open),
            ("v x1000 (m/s)", "v (m/s)", 3, Open),
            ("1000 v (m/s)", "v (m/s)", -3, Open),
            ("v (10E-3 m/s)", "v (m/s)", -2, Open),
            ("v 10^3 (m/s)", "v (m/s)", 3, Open),
        ] {
            assert_eq!(taken(cell), Some(Power { heading: heading.to_owned(), tens, sense }), "{cell}");
        }
        for cell in [
            "x10 (cm)",
            "x100",
            "CH1000 (V)",
            "100 g (cm)",
            "100 trials",
            "Score/100",
            "U (100 Hz)",
            "N (10^5 cells)",
            "y10 (m)",
            "t (s)",
            "10",
            "v (m s^-1)",
            "sensor 1",
            "1000 m (s)",
        ] {
            assert_eq!(taken(cell), None, "{cell}");
        }
    }
}
