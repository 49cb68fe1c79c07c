//! Parser of units:
//!
//! ```text
//! unit     = product [ "/" factor ] | ""
//! product  = factor { [ "*" | "·" ] factor }
//! factor   = ( symbol | "1" | "(" unit ")" ) [ "^" exponent | superscripts ]
//! exponent = [ "-" ] digits | "(" [ "-" ] digits [ "/" digits ] ")"
//! ```
//!
//! Only one factor may follow `/`: `J/kg K` is ambiguous and needs parentheses.

use crate::scale::Scale;
use crate::turns::Turns;
use crate::unit_error::{error, hinting, temperature_scale, too_high, unknown};
use crate::{Dimension, Exponent, UnitError, table, words};
use std::ops::Range;

/// Maximum depth of parentheses.
const DEPTH: usize = 16;

/// Parses a unit: its dimension, its SI value as a quotient of exact numbers, the turns that it counts, and its text in
/// normal form.
pub(crate) fn parse(text: &str) -> Result<(Dimension, (f64, f64), Turns, String), UnitError> {
    let mut reader = Reader { text, at: 0 };
    reader.blanks();
    if reader.at == text.len() {
        return Ok((Dimension::NONE, (1.0, 1.0), Turns::NONE, String::new()));
    }
    let part = reader.unit(0)?;
    if reader.at < text.len() {
        return Err(reader.unexpected());
    }
    if part.has_own_zero {
        return Err(temperature_scale(&part.text, part.range));
    }
    let (multiplier, divisor) = part.scale.quotient();
    let factor = multiplier / divisor;
    if !factor.is_normal() || !multiplier.is_finite() {
        return Err(error("malformed-unit", 0..text.len(), words("this unit is too large or too small for a number")));
    }
    let text = if part.text == "1" { String::new() } else { part.text };
    Ok((part.dimension, (multiplier, divisor), part.turns, text))
}

/// A part of a unit with its text in normal form.
struct Part {
    dimension: Dimension,
    scale: Scale,
    turns: Turns,
    text: String,
    range: Range<usize>,
    /// True for a temperature scale alone, whose zero is not that of the kelvin.
    has_own_zero: bool,
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

/// The text, in parentheses if it contains one of the signs outside of parentheses.
fn grouped(text: String, signs: &[char]) -> String {
    let mut depth = 0_usize;
    let apart = text.chars().any(|c| {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0 && signs.contains(&c)
    });
    if apart { format!("({text})") } else { text }
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn take(&mut self, wanted: char) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.at += wanted.len_utf8();
        }
        found
    }

    fn blanks(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    /// Error for a character that cannot be part of a unit at this place.
    fn unexpected(&self) -> UnitError {
        let Some(found) = self.peek() else {
            let end = self.text.trim_end().len();
            return error("malformed-unit", end..end, words("the unit ends where a unit symbol should follow"));
        };
        let range = self.at..self.at + found.len_utf8();
        match found {
            '/' => hinting(
                error("ambiguous-unit", range, words("a unit has only one `/`")),
                words("put what is divided by into parentheses, such as J/(kg K), or use powers: m/s^2"),
            ),
            '0'..='9' => hinting(
                error("malformed-unit", range, words("a number cannot be part of a unit")),
                words("write the number before the bracket, and powers with ^, such as m^2"),
            ),
            ')' => error("malformed-unit", range, words("this `)` closes nothing")),
            _ => error("malformed-unit", range, words!("`{found}` cannot be part of a unit")),
        }
    }

    fn unit(&mut self, depth: usize) -> Result<Part, UnitError> {
        let above = self.product(depth)?;
        let slash = self.at;
        if !self.take('/') {
            return Ok(above);
        }
        self.blanks();
        let below = self.factor(depth)?;
        self.blanks();
        if self.multiplication() && !self.starts_factor() {
            return Err(self.unexpected());
        }
        if self.starts_factor() {
            let start = self.at;
            let next = self.factor(depth)?;
            let range = slash..next.range.end;
            let (above, below, next_text) = (above.text, below.text, next.text);
            let top = if above == "1" { String::new() } else { format!("{above} ") };
            let alone = grouped(below.clone(), &[' ', '/']);
            return Err(hinting(
                error(
                    "ambiguous-unit",
                    range,
                    words!(
                        "it is not clear whether `{}` is divided by or multiplied with",
                        &self.text[start..next.range.end]
                    ),
                ),
                words!("write {above}/({below} {next_text}) or {top}{next_text}/{alone}"),
            ));
        }
        let range = above.range.start..below.range.end;
        let inverse = below.dimension.inverse();
        let dimension = above.dimension.times(inverse).ok_or_else(|| too_high(range.clone()))?;
        let below_text = grouped(below.text, &[' ', '/']);
        let scale = above.scale.times(below.scale.power(Exponent::from(-1)));
        let turns = above.turns.times(below.turns, -1.0);
        let text = format!("{}/{below_text}", above.text);
        Ok(Part { dimension, scale, turns, text, range, has_own_zero: false })
    }

    fn product(&mut self, depth: usize) -> Result<Part, UnitError> {
        let mut product = self.factor(depth)?;
        loop {
            self.blanks();
            if !self.multiplication() && !self.starts_factor() {
                return Ok(product);
            }
            let factor = self.factor(depth)?;
            let range = product.range.start..factor.range.end;
            let dimension = product.dimension.times(factor.dimension).ok_or_else(|| too_high(range.clone()))?;
            let text = match (product.text.as_str(), factor.text.as_str()) {
                ("1", _) => factor.text,
                (_, "1") => product.text,
                _ => format!("{} {}", grouped(product.text, &['/']), grouped(factor.text, &['/'])),
            };
            let turns = product.turns.times(factor.turns, 1.0);
            let scale = product.scale.times(factor.scale);
            product = Part { dimension, scale, turns, text, range, has_own_zero: false };
        }
    }

    /// Reads a multiplication sign and the blanks after it. True if there is one.
    fn multiplication(&mut self) -> bool {
        let found = ['*', '·', '⋅', '×'].into_iter().any(|sign| self.take(sign));
        if found {
            self.blanks();
        }
        found
    }

    fn starts_factor(&self) -> bool {
        self.peek().is_some_and(|c| c == '(' || c == '1' || is_symbol(c))
    }

    fn factor(&mut self, depth: usize) -> Result<Part, UnitError> {
        let start = self.at;
        let mut part = if self.take('(') {
            if depth == DEPTH {
                return Err(error("malformed-unit", start..start + 1, words("too many parentheses in one another")));
            }
            self.blanks();
            let inner = self.unit(depth + 1)?;
            self.blanks();
            if !self.take(')') {
                let unexpected = self.unexpected();
                let unclosed = error("malformed-unit", start..start + 1, words("this `(` is not closed"));
                return Err(if self.at == self.text.len() { unclosed } else { unexpected });
            }
            inner
        } else if self.rest().starts_with('1')
            && !self.rest()[1..].starts_with(|c: char| c.is_ascii_digit() || c == '.')
        {
            self.at += 1;
            let (dimension, scale, turns) = (Dimension::NONE, Scale::ONE, Turns::NONE);
            Part { dimension, scale, turns, text: "1".to_owned(), range: start..self.at, has_own_zero: false }
        } else {
            self.symbol()?
        };
        let exponent_start = self.at;
        if let Some(exponent) = self.exponent()? {
            let range = exponent_start..self.at;
            let dimension = part.dimension.power(exponent).ok_or_else(|| too_high(range))?;
            let base = grouped(part.text, &[' ', '/', '^']);
            let text = if base == "1" { base } else { exponent.power_of(&base) };
            let (scale, turns) = (part.scale.power(exponent), Turns::NONE.times(part.turns, exponent.to_number()));
            part = Part { dimension, scale, turns, text, range: start..self.at, has_own_zero: false };
        }
        part.range = start..self.at;
        Ok(part)
    }

    fn symbol(&mut self) -> Result<Part, UnitError> {
        let start = self.at;
        let length = self.rest().find(|c| !is_symbol(c)).unwrap_or(self.rest().len());
        if length == 0 {
            return Err(self.unexpected());
        }
        self.at += length;
        let range = start..self.at;
        let written = &self.text[range.clone()];
        // Look-alikes: the Greek mu, the ohm and angstrom signs, and the raised o of Spanish keyboards.
        let alike = |letter: char| match letter {
            'μ' => 'µ',
            '\u{2126}' => 'Ω',
            '\u{212B}' => 'Å',
            'º' => '°',
            other => other,
        };
        let text: String = written.chars().map(alike).collect();
        if let Some((symbol, tens)) = table::find(&text) {
            let scale = symbol.scale.times(Scale::decimal(1, tens));
            let (dimension, turns) = (symbol.dimension(), symbol.turns());
            return Ok(Part { dimension, scale, turns, text, range, has_own_zero: false });
        }
        if let Some(scale) = table::degree(&text) {
            let dimension = Dimension::from_whole([0, 0, 0, 0, 1, 0, 0]);
            return Ok(Part { dimension, scale, turns: Turns::NONE, text, range, has_own_zero: true });
        }
        Err(unknown(&text, range))
    }

    fn exponent(&mut self) -> Result<Option<Exponent>, UnitError> {
        let start = self.at;
        let power: String = self.rest().chars().map_while(raised).collect();
        if !power.is_empty() {
            let length: usize = self.rest().chars().take(power.chars().count()).map(char::len_utf8).sum();
            self.at += length;
            let value = power.parse().ok().and_then(|value| Exponent::new(value, 1));
            return value.map(Some).ok_or_else(|| too_high(start..self.at));
        }
        if self.rest().trim_start().starts_with('^') {
            self.blanks();
        }
        if !self.take('^') {
            return Ok(None);
        }
        let parenthesis = self.take('(');
        let mut numbers = [1, 1];
        for (index, number) in numbers.iter_mut().enumerate() {
            if index == 1 && !(parenthesis && self.take('/')) {
                break;
            }
            let signed = index == 0 && (self.take('-') || self.take('−'));
            let digits: &str =
                &self.rest()[..self.rest().find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest().len())];
            self.at += digits.len();
            if digits.is_empty() || self.peek() == Some('.') {
                let end = self.at + self.peek().map_or(0, char::len_utf8);
                let wrong = error(
                    "malformed-unit",
                    start..end,
                    words("an exponent is a whole number or a fraction in parentheses"),
                );
                return Err(hinting(wrong, words("such as m^2, s^-1 or m^(1/2)")));
            }
            *number = digits.parse().map_err(|_| too_high(start..self.at))?;
            if signed {
                *number = -*number;
            }
        }
        if parenthesis && !self.take(')') {
            let wrong =
                error("malformed-unit", start..self.at, words("the parenthesis of this exponent is not closed"));
            return Err(hinting(wrong, words("such as m^(1/2)")));
        }
        Exponent::new(numbers[0], numbers[1]).map(Some).ok_or_else(|| too_high(start..self.at))
    }
}

fn is_symbol(c: char) -> bool {
    c.is_alphabetic() || matches!(c, '%' | '°' | '℃' | '℉' | '_')
}

/// The digit or sign of a superscript character: `2` for ²; `None` if it is none.
pub fn raised(character: char) -> Option<char> {
    Some(match character {
        '⁰' => '0',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁴' => '4',
        '⁵' => '5',
        '⁶' => '6',
        '⁷' => '7',
        '⁸' => '8',
        '⁹' => '9',
        '⁻' => '-',
        _ => return None,
    })
}
