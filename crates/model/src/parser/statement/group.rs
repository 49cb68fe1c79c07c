//! `group "Circuit"`: heading of the controls of the parameters after it.

use super::{Salvaged, nothing};
use crate::lexer::TokenKind;
use crate::parser::cursor::Cursor;
use crate::{Diagnostic, Statement, StatementKind};
use units::{Words, words};

const GROUP_FORM: Words = words("the form is: group \"NAME\"");

impl Cursor<'_> {
    /// True at `group`, followed by its name or by something that may be meant as one.
    pub(in crate::parser) fn is_group(&self) -> bool {
        let named = || {
            matches!(
                self.peek_ahead(1),
                TokenKind::Text(_) | TokenKind::Name { .. } | TokenKind::Newline | TokenKind::End
            )
        };
        self.at_word("group") && named()
    }

    /// `group "Circuit"`
    pub(in crate::parser) fn group(&mut self) -> Salvaged {
        let start = self.advance();
        let Some(name) = self.label() else {
            let wrong =
                words!("the name of the group is expected here in quotation marks, not {found}", found = self.found());
            let place = if self.at_line_end() { start } else { self.span() };
            let told = self.fail(Diagnostic::error("group-name", wrong, place).with_hint(GROUP_FORM));
            return (nothing(start), told);
        };
        if name.text.trim().is_empty() {
            let wrong = words("the group has no name");
            self.say(Diagnostic::error("group-name", wrong, name.span).with_hint(GROUP_FORM));
        }
        (StatementKind::Group(name), Ok(()))
    }

    /// Reports parts that other statements may have and a group may not.
    pub(in crate::parser) fn check_group(&mut self, statement: &Statement) {
        let StatementKind::Group(_) = &statement.kind else { return };
        let more = statement.over.first().map(|over| over.index.span);
        if let Some(more) = more.or(statement.label.as_ref().map(|label| label.span)) {
            let wrong = words("a group has a name and nothing else");
            self.say(Diagnostic::error("group-name", wrong, more).with_hint(GROUP_FORM));
        }
    }
}
