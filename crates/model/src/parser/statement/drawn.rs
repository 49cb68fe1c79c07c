//! `drawn in -5..5 from 0 [s] until 10 [s]`: range of the curve that the reader may draw instead of a table.

use crate::lexer::{Keyword, Symbol, TokenKind};
use crate::parser::cursor::{Cursor, Read};
use crate::{Diagnostic, DrawnRange, StatedUnit};
use units::{Words, words};

const FORM: Words = words("the form is: table NAME(ARGUMENT) in [UNIT] drawn in LOW..HIGH until END [UNIT]");

const RANGE: Words = words("`in` with the least and the greatest value is expected here");
const END: Words = words("`until` with the greatest argument is expected here");

impl Cursor<'_> {
    /// `drawn in -5..5 from 0 [s] until 10 [s]`. The unit of the arguments stands after the first of them.
    pub(in crate::parser) fn drawn(&mut self, unit: &mut Option<StatedUnit>) -> Read<DrawnRange> {
        self.advance();
        let keyword = self.span();
        if *self.peek() != TokenKind::Keyword(Keyword::In) {
            return self.not_drawn(RANGE);
        }
        self.advance();
        use Symbol::{Minus, Plus};
        if !matches!(self.peek(), TokenKind::Number(_) | TokenKind::Symbol(Minus | Plus)) {
            return self.not_drawn(RANGE);
        }
        let bounds = self.bounds(keyword)?;
        let mut from = 0.0;
        let stated = self.at_word("from");
        if stated {
            self.advance();
            from = self.table_number(unit, true)?;
        }
        if !self.at_word("until") {
            return self.not_drawn(END);
        }
        self.advance();
        let until_span = self.span();
        let until = self.table_number(unit, !stated)?;
        Ok(DrawnRange { bounds, from, until, until_span })
    }

    /// True if the next line begins with a number.
    pub(in crate::parser) fn points_follow(&self) -> bool {
        self.at_line_end() && matches!(self.peek_ahead(1), TokenKind::Number(_) | TokenKind::Symbol(Symbol::Minus))
    }

    fn not_drawn<T>(&mut self, expected: Words) -> Read<T> {
        let wrong = words!("{expected}, not {found}", found = self.found());
        let place = if self.at_line_end() { self.last_span() } else { self.span() };
        self.fail(Diagnostic::error("table-form", wrong, place).with_hint(FORM))
    }
}
