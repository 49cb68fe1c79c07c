//! Components of vectors: `.x` after a name, an index, a parenthesis or primes.

use super::Lexer;
use super::token::{Symbol, TokenKind};
use crate::components::AXES;
use units::alphabet::primes;

impl Lexer<'_> {
    /// Axis at the current position, if nothing else follows: its index and the text with the point.
    fn axis(&self) -> Option<(usize, &'static str)> {
        const SUFFIXES: [&str; 3] = [".x", ".y", ".z"];
        if self.byte(0) != Some(b'.') {
            return None;
        }
        let rest = self.rest();
        let (axis, suffix) = SUFFIXES.into_iter().enumerate().find(|(_, suffix)| rest.starts_with(suffix))?;
        let goes_on = rest[suffix.len()..].starts_with(|c: char| c == '_' || c.is_alphanumeric());
        (!goes_on && axis < AXES.len()).then_some((axis, suffix))
    }

    /// Consumes an axis at the current position.
    pub(super) fn axis_here(&mut self) -> Option<(usize, &'static str)> {
        let found = self.axis()?;
        self.at += found.1.len();
        Some(found)
    }

    /// Consumes primes and returns their number.
    pub(super) fn primes(&mut self) -> u32 {
        let mut count = 0;
        while let Some(next) = self.peek()
            && let Some(more) = primes(next)
        {
            self.at += next.len_utf8();
            count += more;
        }
        count
    }

    /// True if a component comes next, directly after a token that can end a vector.
    pub(super) fn at_component(&self) -> bool {
        let vector = self.tokens.last().is_some_and(|last| {
            let closed = matches!(
                last.kind,
                TokenKind::Brackets(_) | TokenKind::Primes | TokenKind::Symbol(Symbol::RightParenthesis)
            );
            closed && last.span.end == self.at
        });
        vector && self.axis().is_some()
    }

    pub(super) fn component(&mut self) {
        let start = self.at;
        if let Some((axis, _)) = self.axis_here() {
            let order = self.primes();
            self.push(TokenKind::Component { axis, order }, start);
        }
    }
}
