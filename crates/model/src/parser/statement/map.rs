//! Iterated maps: `independent k by 1` makes the independent variable discrete, and `next p = r*p*(1 - p)` gives the value
//! at the next count. Both words are reserved only in these places.

use super::{Salvaged, nothing};
use crate::lexer::{Symbol, TokenKind};
use crate::parser::cursor::{Cursor, Read};
use crate::parser::unread;
use crate::{Diagnostic, EventExtras, StatedUnit, StatementKind};
use units::words;

impl Cursor<'_> {
    /// Parses `by 1`, if it comes next. Returns true if the independent variable is discrete.
    pub(in crate::parser) fn counting(&mut self, unit: Option<&StatedUnit>) -> Read<bool> {
        if !self.at_word("by") {
            return Ok(false);
        }
        let start = self.advance();
        if let Some(unit) = unit {
            let wrong = words("what counts has no unit");
            let diagnostic = Diagnostic::error("counts-by", wrong, unit.span);
            return self.fail(diagnostic.with_hint(words("leave it out: `by 1`")));
        }
        let ends = matches!(self.peek_ahead(1), TokenKind::Newline | TokenKind::End | TokenKind::Text(_));
        if *self.peek() == TokenKind::Number(1.0) && ends {
            self.advance();
            return Ok(true);
        }
        let wrong = words!("an independent variable counts by 1, not by {found}", found = self.found());
        let place = if self.at_line_end() { start } else { self.span() };
        self.fail(Diagnostic::error("counts-by", wrong, place).with_hint(words("write `by 1`")))
    }

    /// True if a name and `(` follow.
    fn is_at_the_start(&self) -> bool {
        matches!(self.peek_ahead(1), TokenKind::Symbol(Symbol::LeftParenthesis))
    }

    /// `next p = r*p*(1 - p)`
    pub(in crate::parser) fn next_value(&mut self) -> Salvaged {
        let start = self.advance();
        if self.is_at_the_start() {
            let place = start.to(self.span());
            let wrong = words("the value at the start is given without `next`");
            let hint = words("such as: p(0) = 0.1");
            return (nothing(start), self.fail(Diagnostic::error("next-value", wrong, place).with_hint(hint)));
        }
        if !matches!(self.peek_ahead(1), TokenKind::Symbol(Symbol::Equals) | TokenKind::Brackets(_)) {
            self.advance();
            let wrong = words!("`=` is expected here, not {found}", found = self.found());
            let place = if self.at_line_end() { start.to(self.last_span()) } else { self.span() };
            let hint = words("such as: next p = 3.2*p*(1 - p)");
            return (nothing(start), self.fail(Diagnostic::error("next-value", wrong, place).with_hint(hint)));
        }
        let action = match self.new_value() {
            Ok(action) => action,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        let extras = EventExtras { next: true, ..EventExtras::default() };
        (StatementKind::Event { condition: unread(start), actions: vec![action], extras }, Ok(()))
    }
}
