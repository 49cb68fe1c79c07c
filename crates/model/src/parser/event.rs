//! What an event may have besides its condition and actions: `as landing`, `stop`, and `let u = e*y'`; and events at equal
//! intervals, `every 0.1 [s] from 0 [s]`. The words are free as names everywhere else.

use super::cursor::{Cursor, Read};
use super::statement::{Salvaged, nothing};
use super::unread;
use crate::lexer::{Symbol, TokenKind};
use crate::{EventExtras, StatementKind};
use units::words;

impl Cursor<'_> {
    /// Whether a statement begins with `every` and an interval.
    pub(super) fn is_every(&self) -> bool {
        self.at_word("every") && matches!(self.peek_ahead(1), TokenKind::Number(_) | TokenKind::Name { .. })
    }

    /// `every 0.1 [s] from 0 [s] as tick { N = N - 1 }`
    pub(super) fn every(&mut self) -> Salvaged {
        let start = self.advance();
        let interval = match self.expression() {
            Ok(tree) => tree.expression,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        let mut from = None;
        if self.at_word("from") {
            self.advance();
            match self.expression() {
                Ok(tree) => from = Some(tree.expression),
                Err(reported) => return (nothing(start), Err(reported)),
            }
        }
        let condition = unread(interval.span);
        let mut extras = EventExtras { every: Some(Box::new((interval, from))), ..EventExtras::default() };
        let mut actions = Vec::new();
        let named = self.event_name(&mut extras);
        let read = named.and_then(|()| self.actions(start, &mut actions, &mut extras));
        (StatementKind::Event { condition, actions, extras }, read)
    }

    /// Whether what follows an expression is `as NAME` or `from` and a number or name: a word and no further operand.
    pub(super) fn at_event_word(&self) -> bool {
        let name = |ahead: usize| matches!(self.peek_ahead(ahead), TokenKind::Name { .. });
        let brace =
            |ahead: usize| matches!(self.peek_ahead(ahead), TokenKind::Symbol(Symbol::LeftBrace) | TokenKind::Newline);
        let from = self.at_word("from") && (name(1) || matches!(self.peek_ahead(1), TokenKind::Number(_)));
        from || self.at_word("as") && name(1) && brace(2)
    }

    /// `as landing`, if it is there.
    pub(super) fn event_name(&mut self, extras: &mut EventExtras) -> Read<()> {
        if !self.at_word("as") {
            return Ok(());
        }
        self.advance();
        extras.name = Some(self.plain_name(&words("an event", "un evento"))?);
        Ok(())
    }

    /// Whether an action is `stop`.
    pub(super) fn at_stop(&self) -> bool {
        use Symbol::{Comma, RightBrace, Semicolon};
        let ends = matches!(
            self.peek_ahead(1),
            TokenKind::Newline | TokenKind::End | TokenKind::Symbol(Comma | RightBrace | Semicolon)
        );
        self.at_word("stop") && ends
    }

    /// Whether an action is `let NAME ...`.
    pub(super) fn at_let(&self) -> bool {
        self.at_word("let") && matches!(self.peek_ahead(1), TokenKind::Name { .. })
    }
}
