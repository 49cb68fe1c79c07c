//! `[N/m]` and `[i+1]`: units and indices; the parser distinguishes them.

use super::Lexer;
use super::token::TokenKind;
use crate::{Diagnostic, Span};
use units::words;

impl Lexer<'_> {
    /// Lexes brackets and their content.
    pub(super) fn brackets(&mut self) {
        let start = self.at;
        self.at += 1;
        let inside_start = self.at;
        let inside = self.skip(|c| !matches!(c, ']' | '[' | '\n' | '#' | '"'));
        if self.rest().starts_with(']') {
            let inside = inside_start..self.at;
            self.at += 1;
            return self.push(TokenKind::Brackets(inside), start);
        }
        self.at = inside_start + inside.trim_end().len();
        let wrong = words("this `[` is not closed");
        let diagnostic = Diagnostic::error("unclosed-bracket", wrong, Span::new(start, start + 1))
            .with_hint(words("end the unit with ]"));
        self.diagnostics.push(match unit_at_start(inside) {
            Some(length) => {
                let end = inside_start + length;
                diagnostic.with_fix(Span::new(end, end), "]")
            }
            None => diagnostic,
        });
        self.push(TokenKind::Unknown, start);
    }

    /// Consumes a degree sign after a number, as in `30°`. Returns true if there was one.
    pub(super) fn degree_sign(&mut self, sign: char, start: usize) -> bool {
        let number = self.tokens.last().filter(|token| matches!(token.kind, TokenKind::Number(_)));
        let Some(number) = number.map(|token| token.span).filter(|_| matches!(sign, '°' | 'º')) else { return false };
        let written = &self.source[number.range()];
        let wrong = words!("`{sign}` cannot stand directly after a number");
        let diagnostic = Diagnostic::error("unit-without-brackets", wrong, Span::new(start, self.at))
            .with_hint(words!("a unit stands in square brackets: {written} [deg]"));
        self.diagnostics.push(diagnostic.with_fix(Span::new(number.end, self.at), " [deg]"));
        true
    }
}

/// Length in bytes of the longest unit at the start of a text; the word `in` is not read as inches.
fn unit_at_start(text: &str) -> Option<usize> {
    let text = text.split(" in ").next().unwrap_or_default();
    let ends = text.char_indices().filter(|(_, c)| !c.is_alphanumeric()).map(|(end, _)| end).chain([text.len()]);
    let end = ends.rev().find(|&end| end > 0 && units::Unit::parse(&text[..end]).is_ok())?;
    Some(text[..end].trim_end().len())
}
