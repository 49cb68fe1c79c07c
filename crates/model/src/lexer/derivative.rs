//! Derivatives in textbook notation: `d²y/dt²`, `ÿ`. They are reported and lexed as the derivatives that they mean, to
//! avoid errors that follow from the first.

use super::Lexer;
use super::token::TokenKind;
use crate::notation::primed;
use crate::{Diagnostic, Span, limits};
use units::alphabet::greek_name;
use units::{raised, words};

/// Letters with dots, the letters without the dots, and the number of dots.
const DOTTED: [(&str, &str, u32); 2] =
    [("ȧḃċḋėḟġḣṁṅȯṗṙṡṫẇẋẏż", "abcdefghmnoprstwxyz", 1), ("äëḧïöẗüẅẍÿ", "aehiotuwxy", 2)];

/// Combining dots, which follow their letter, and their number.
const DOTS: [(char, u32); 3] = [('\u{307}', 1), ('\u{308}', 2), ('\u{20DB}', 3)];

impl Lexer<'_> {
    /// Consumes a derivative in textbook notation. Returns true if there was one.
    pub(super) fn textbook_derivative(&mut self) -> bool {
        self.quotient() || self.dotted()
    }

    /// `d²y/dt²` and `d^2y/dt^2`. No valid text begins with a power of `d` beside a name.
    fn quotient(&mut self) -> bool {
        let rest = self.rest();
        let Some((order, after)) = rest.strip_prefix('d').and_then(power) else { return false };
        let after = after.trim_start_matches(' ');
        let function_start = rest.len() - after.len();
        let (function, after) = after.split_at(name_length(after));
        let below = after.trim_start_matches(' ').strip_prefix('/').map(|after| after.trim_start_matches(' '));
        let Some(below) = below.and_then(|below| below.strip_prefix('d')) else { return false };
        let (independent, after) = below.split_at(name_length(below));
        let Some((_, after)) = power(after).filter(|(below, _)| *below == order) else { return false };
        if function.is_empty() || independent.is_empty() || !(1..=limits::ORDER).contains(&order) {
            return false;
        }
        let start = self.at;
        self.at += function_start;
        let (text, _) = self.letters();
        self.at = start + rest.len() - after.len();
        self.primed_instead(start, text, &primed(function, order), order);
        true
    }

    /// `ÿ` and `ẋ_1`. In a longer word such a letter is an ordinary letter.
    fn dotted(&mut self) -> bool {
        let mut characters = self.rest().chars();
        let Some(first) = characters.next() else { return false };
        let above = characters.next().and_then(|next| DOTS.iter().find(|(dots, _)| *dots == next));
        let (letter, order, length) = match (above, undotted(first)) {
            (Some((dots, order)), _) => (first, *order, first.len_utf8() + dots.len_utf8()),
            (None, Some((letter, order))) => (letter, order, first.len_utf8()),
            (None, None) => return false,
        };
        if self.rest()[length..].starts_with(char::is_alphabetic) {
            return false;
        }
        let start = self.at;
        self.at += length;
        let index_start = self.at;
        let (index, _) = self.letters();
        let text = greek_name(letter).map_or_else(|| letter.to_string(), str::to_owned) + &index;
        let written = format!("{letter}{}", &self.source[index_start..self.at]);
        self.primed_instead(start, text, &primed(&written, order), order);
        true
    }

    /// Reports that the text from `start` to here is written with primes, and lexes it as `text` with `order` primes.
    fn primed_instead(&mut self, start: usize, text: String, ours: &str, order: u32) {
        let span = Span::new(start, self.at);
        let written = &self.source[span.range()];
        let wrong = words!("`{written}` is written `{ours}` here");
        self.diagnostics.push(Diagnostic::error("foreign-derivative", wrong, span).with_fix(span, ours));
        self.push(TokenKind::Name { text, order, end: span.end }, start);
    }
}

/// Exponent at the start of a text, `²` or `^2`, and the rest.
fn power(text: &str) -> Option<(u32, &str)> {
    let plain = text.strip_prefix('^');
    let rest = plain.unwrap_or(text);
    let digit = |c: char| if plain.is_some() { c.to_digit(10) } else { raised(c)?.to_digit(10) };
    let first = rest.chars().next()?;
    Some((digit(first)?, &rest[first.len_utf8()..]))
}

/// Length in bytes of the name at the start of a text.
fn name_length(text: &str) -> usize {
    let is_part = |c: char| c == '_' || c.is_alphanumeric() && raised(c).is_none();
    if text.starts_with(char::is_alphabetic) { text.find(|c| !is_part(c)).unwrap_or(text.len()) } else { 0 }
}

/// The letter without its dots, and the number of dots.
fn undotted(dotted: char) -> Option<(char, u32)> {
    DOTTED.iter().find_map(|(with, without, order)| {
        let index = with.chars().position(|c| c == dotted)?;
        Some((without.chars().nth(index)?, *order))
    })
}
