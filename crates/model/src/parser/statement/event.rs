//! Events: `when y < 0 [m] { y' = -e*y' }`, their optional parts (`as landing`, `stop`, `let u = e*y'`), and periodic
//! events, `every 0.1 [s] from 0 [s]`. The words are reserved only in these places.

use super::button::BUTTON_FORM;
use super::{Salvaged, nothing};
use crate::lexer::{Keyword, Symbol, TokenKind};
use crate::parser::cursor::{Cursor, Read, Told};
use crate::parser::unread;
use crate::{Action, Diagnostic, Edit, EventExtras, Span, StatementKind};
use units::{Words, words};

const EVENT_FORM: Words = words("the form is: when CONDITION { y' = EXPRESSION }");

impl Cursor<'_> {
    /// `when y < 0 [m] { y' = -e*y' }`
    pub(in crate::parser) fn event(&mut self) -> Salvaged {
        let start = self.advance();
        let condition = match self.expression() {
            Ok(tree) => tree.expression,
            Err(reported) => return (nothing(start), Err(reported)),
        };
        self.refuse_equals(words("condition"));
        let (mut actions, mut extras) = (Vec::new(), EventExtras::default());
        let mut read = self.event_name(&mut extras);
        if read.is_ok() {
            read = self.actions(start, &mut actions, &mut extras);
        }
        (StatementKind::Event { condition, actions, extras }, read)
    }

    /// `{ y' = -e*y', stop }`
    pub(in crate::parser) fn actions(
        &mut self,
        start: Span,
        actions: &mut Vec<Action>,
        extras: &mut EventExtras,
    ) -> Read<()> {
        let form = if extras.button.is_some() { BUTTON_FORM } else { EVENT_FORM };
        let Some(open) = self.open_brace() else {
            let expected = self.brace_expected("missing-braces", self.last_span());
            let mut expected = expected.with_label(start, words("of this event"));
            if *self.peek() == TokenKind::Keyword(Keyword::Then) {
                let then = self.span();
                let line = self.source[then.end..].lines().next().unwrap_or_default();
                let end = then.end + line.split('#').next().unwrap_or_default().trim_end().len();
                let closing = Edit { span: Span::new(end, end), text: " }".to_owned() };
                expected = expected.with_fixes(vec![Edit { span: then, text: "{".to_owned() }, closing]);
            }
            return self.fail(expected.with_hint(form));
        };
        let mut wrong_actions = false;
        loop {
            while self.take(Symbol::Semicolon).is_some()
                || self.take(Symbol::Comma).is_some()
                || *self.peek() == TokenKind::Newline
            {
                self.skip_lines();
            }
            let unclosed = matches!(
                self.peek(),
                TokenKind::End | TokenKind::Keyword(Keyword::Parameter | Keyword::Independent | Keyword::When)
            );
            if unclosed {
                self.say(Diagnostic::error("unclosed-brace", words("this `{` is not closed"), open).with_hint(form));
                self.back_to_line_end();
                return Ok(());
            }
            if let Some(end) = self.take(Symbol::RightBrace) {
                let nothing = actions.is_empty() && extras.stop.is_none() && extras.name.is_none();
                if nothing && !wrong_actions {
                    let wrong = match extras.button {
                        Some(_) => words("this button does nothing"),
                        None => words("this event changes nothing"),
                    };
                    self.say(Diagnostic::error("empty-event", wrong, open.to(end)).with_hint(form));
                }
                return Ok(());
            }
            if self.at_stop() {
                extras.stop = Some(self.advance());
                continue;
            }
            let read = if self.at_let() {
                self.advance();
                self.action().map(|action| extras.names.push(action))
            } else {
                self.action().map(|action| actions.push(action))
            };
            match read {
                Ok(()) => {}
                Err(Told) => {
                    wrong_actions = true;
                    self.skip_rest(true);
                }
            }
        }
    }

    fn action(&mut self) -> Read<Action> {
        let mut action = self.new_value()?;
        action.over = self.over()?;
        let separated = matches!(
            self.peek(),
            TokenKind::Newline
                | TokenKind::End
                | TokenKind::Symbol(Symbol::Semicolon | Symbol::Comma | Symbol::RightBrace)
        );
        if separated { Ok(action) } else { self.unexpected_after_expression() }
    }

    /// `y' = -e*y'`
    pub(in crate::parser) fn new_value(&mut self) -> Read<Action> {
        let span = self.span();
        let TokenKind::Name { text, order, end } = self.peek().clone() else {
            let wrong = words!("an action such as y' = 0 [m/s] is expected here, not {found}", found = self.found());
            return self.fail(Diagnostic::error("event-action", wrong, span));
        };
        self.advance();
        let mut order = order;
        let mut indices = Vec::new();
        let mut component = None;
        if order == 0 && self.at_indices() {
            indices = self.indices()?.0;
            order = self.primes_here()?;
            (component, order) = self.axis_after(order)?;
        }
        if self.take(Symbol::Equals).is_none() {
            let diagnostic = if *self.peek() == TokenKind::Symbol(Symbol::LeftParenthesis) {
                let wrong = words("an action sets the value at the event, not the one at the start");
                Diagnostic::error("event-action", wrong, span)
            } else {
                let wrong = words!("`=` is expected here, not {found}", found = self.found());
                let place = if self.at_line_end() { span } else { self.span() };
                Diagnostic::error("event-action", wrong, place)
            };
            return self.fail(diagnostic.with_hint(EVENT_FORM));
        }
        let value = self.expression()?.expression;
        let name = crate::Name { text, span: Span::new(span.start, end) };
        Ok(Action { name, indices, component, order, value, over: Vec::new() })
    }

    /// True at `every` followed by an interval.
    pub(in crate::parser) fn is_every(&self) -> bool {
        self.at_word("every") && matches!(self.peek_ahead(1), TokenKind::Number(_) | TokenKind::Name { .. })
    }

    /// `every 0.1 [s] from 0 [s] as tick { N = N - 1 }`
    pub(in crate::parser) fn every(&mut self) -> Salvaged {
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

    /// True at `as NAME`, or at `from` before a number or a name: these words end an expression and are not further
    /// operands.
    pub(in crate::parser) fn at_event_word(&self) -> bool {
        let name = |ahead: usize| matches!(self.peek_ahead(ahead), TokenKind::Name { .. });
        let brace =
            |ahead: usize| matches!(self.peek_ahead(ahead), TokenKind::Symbol(Symbol::LeftBrace) | TokenKind::Newline);
        let from = self.at_word("from") && (name(1) || matches!(self.peek_ahead(1), TokenKind::Number(_)));
        from || self.at_word("as") && name(1) && brace(2)
    }

    /// Parses `as landing`, if it comes next.
    pub(in crate::parser) fn event_name(&mut self, extras: &mut EventExtras) -> Read<()> {
        if !self.at_word("as") {
            return Ok(());
        }
        self.advance();
        extras.name = Some(self.plain_name(&words("an event"))?);
        Ok(())
    }

    /// True at the action `stop`.
    pub(in crate::parser) fn at_stop(&self) -> bool {
        use Symbol::{Comma, RightBrace, Semicolon};
        let ends = matches!(
            self.peek_ahead(1),
            TokenKind::Newline | TokenKind::End | TokenKind::Symbol(Comma | RightBrace | Semicolon)
        );
        self.at_word("stop") && ends
    }

    /// True at `let NAME ...`.
    pub(in crate::parser) fn at_let(&self) -> bool {
        self.at_word("let") && matches!(self.peek_ahead(1), TokenKind::Name { .. })
    }
}
