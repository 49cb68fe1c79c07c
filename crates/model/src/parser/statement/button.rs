//! `button "Kick" { x' = x' + 1 [m/s] }`: an event that fires when the reader presses a button.

use super::{Salvaged, nothing};
use crate::lexer::TokenKind;
use crate::parser::cursor::Cursor;
use crate::{BinaryOperator, Diagnostic, EventExtras, Expression, Span, Statement, StatementKind};
use units::{Words, words};

/// Form of a button statement, for hints.
pub(in crate::parser) const BUTTON_FORM: Words = words("the form is: button \"TITLE\" { y' = EXPRESSION }");

impl Cursor<'_> {
    /// True at `button` followed by a text or a name.
    pub(in crate::parser) fn is_button(&self) -> bool {
        self.at_word("button") && matches!(self.peek_ahead(1), TokenKind::Text(_) | TokenKind::Name { .. })
    }

    /// `button "Kick" as kick { x' = x' + 1 [m/s] }`
    pub(in crate::parser) fn button(&mut self) -> Salvaged {
        let start = self.advance();
        let Some(title) = self.label() else {
            let wrong = words!(
                "the title of the button is expected here in quotation marks, not {found}",
                found = self.found()
            );
            let told = self.fail(Diagnostic::error("button-title", wrong, self.span()).with_hint(BUTTON_FORM));
            return (nothing(start), told);
        };
        if title.text.trim().is_empty() {
            let wrong = words("the button has no title");
            self.say(Diagnostic::error("button-title", wrong, title.span).with_hint(BUTTON_FORM));
        }
        let condition = never(title.span);
        let mut extras = EventExtras { button: Some(title), ..EventExtras::default() };
        let mut actions = Vec::new();
        let named = self.event_name(&mut extras);
        let read = named.and_then(|()| self.actions(start, &mut actions, &mut extras));
        (StatementKind::Event { condition, actions, extras }, read)
    }

    /// Reports parts that an event may have and a button may not.
    pub(in crate::parser) fn check_button(&mut self, statement: &Statement) {
        let StatementKind::Event { extras: EventExtras { button: Some(title), .. }, .. } = &statement.kind else {
            return;
        };
        if let Some(over) = statement.over.first() {
            let wrong = words("a button stands for itself, not for each index");
            self.say(
                Diagnostic::error("button-for", wrong, over.index.span)
                    .with_hint(words("its actions may have `for`: `x[i]' = 0 [m/s] for i in 1..N`")),
            );
        }
        if let Some(label) = &statement.label {
            let wrong = words("a button has one title, before the braces");
            self.say(Diagnostic::error("button-title", wrong, label.span).with_label(title.span, words("the title")));
        }
    }
}

/// A condition that is never true.
fn never(span: Span) -> Expression {
    Expression::binary(BinaryOperator::Greater, Expression::number(0.0, span), Expression::number(1.0, span), span)
}
