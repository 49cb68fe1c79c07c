//! Units without their brackets: `20 N/m`, `9.81 (m/s^2)`, `F = -k*y in N`.

use crate::lexer::{Symbol, TokenKind};
use crate::parser::cursor::Cursor;
use crate::{Diagnostic, Span};
use units::{Unit, words};

/// Tokens after the position that together form a unit.
pub(in crate::parser) struct BareUnit<'a> {
    /// The unit, without the parentheses around it.
    pub(in crate::parser) text: &'a str,
    pub(in crate::parser) span: Span,
    is_round: bool,
    /// True for a quotient such as `N/m`, which is hardly a product of quantities.
    pub(in crate::parser) is_certain: bool,
}

impl<'a> Cursor<'a> {
    /// The longest unit that the next tokens form.
    pub(in crate::parser) fn bare_unit(&self) -> Option<BareUnit<'a>> {
        let first = self.peek();
        if !matches!(first, TokenKind::Name { order: 0, .. } | TokenKind::Symbol(Symbol::LeftParenthesis)) {
            return None;
        }
        let source = self.source;
        let start = self.span().start;
        let ends = (0..).take_while(|&ahead| self.can_be_in_unit(ahead)).map(|ahead| self.span_ahead(ahead).end);
        let end = ends.filter(|&end| Unit::parse(&source[start..end]).is_ok()).last()?;
        let whole = &source[start..end];
        let inside = whole.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
        let inside = inside.filter(|inside| Unit::parse(inside).is_ok());
        let text = inside.unwrap_or(whole);
        let is_certain = text.contains('/');
        Some(BareUnit { text, span: Span::new(start, end), is_round: inside.is_some(), is_certain })
    }

    /// The next token, read as a unit.
    pub(in crate::parser) fn bare_name(&self) -> BareUnit<'a> {
        let span = self.span();
        BareUnit { text: &self.source[span.range()], span, is_round: false, is_certain: false }
    }

    fn can_be_in_unit(&self, ahead: usize) -> bool {
        use Symbol::{Caret, LeftParenthesis, Minus, RightParenthesis, Slash, Star};
        matches!(
            self.peek_ahead(ahead),
            TokenKind::Name { order: 0, .. }
                | TokenKind::Number(_)
                | TokenKind::Raised(_)
                | TokenKind::Symbol(Star | Slash | Caret | Minus | LeftParenthesis | RightParenthesis)
        )
    }
}

impl BareUnit<'_> {
    /// Error for a unit that follows the number `number`.
    pub(in crate::parser) fn after(&self, number: &str) -> Diagnostic {
        let Self { text, span, .. } = self;
        let wrong = if self.is_round {
            words!("the unit `{text}` stands in round brackets")
        } else {
            words!("`{text}` cannot stand directly after a number")
        };
        self.with_brackets(Diagnostic::error("unit-without-brackets", wrong, *span), number)
    }

    /// Adds the remedy: the same unit in brackets after `number`.
    pub(in crate::parser) fn with_brackets(&self, diagnostic: Diagnostic, number: &str) -> Diagnostic {
        let Self { text, span, .. } = self;
        diagnostic
            .with_hint(words!("a unit stands in square brackets: {number} [{text}]"))
            .with_fix(*span, format!("[{text}]"))
    }
}
