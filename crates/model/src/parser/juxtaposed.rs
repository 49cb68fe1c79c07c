//! Two operands with nothing between them: a product as textbooks print it, the argument of a function, a unit without brackets.

use super::cursor::Cursor;
use crate::lexer::{Symbol, TokenKind};
use crate::{Diagnostic, Expression, ExpressionKind, Span};
use program::functions::Function;
use units::words;

impl Cursor<'_> {
    /// The names and numbers that are multiplied, divided or raised from the next token on: the textbook's `sin omega*t`.
    fn product_ahead(&self) -> Span {
        let is_operand = |ahead| matches!(self.peek_ahead(ahead), TokenKind::Number(_) | TokenKind::Name { .. });
        let goes_on = |ahead| {
            let joins =
                matches!(self.peek_ahead(ahead), TokenKind::Symbol(Symbol::Star | Symbol::Slash | Symbol::Caret));
            joins && is_operand(ahead + 1) && *self.peek_ahead(ahead + 2) != TokenKind::Symbol(Symbol::LeftParenthesis)
        };
        let mut last = 0;
        while goes_on(last + 1) {
            last += 2;
        }
        self.span().to(self.span_ahead(last))
    }

    /// Says what is missing between an expression and the operand that follows it.
    pub(super) fn missing_operator(&mut self, left: &Expression) {
        let source = self.source;
        let next = self.span();
        // Only the operands next to the gap, not all of the expression before it.
        let last = last_operand(left);
        let before = &source[last.span.range()];
        let now = &source[next.range()];
        let gap = Span::new(left.span.end, next.start);
        let place = if gap.start < gap.end { gap } else { next };
        if let ExpressionKind::Name { name, order: 0 } = &last.kind
            && Function::named(name).is_some()
        {
            let wrong = words!(
                "the argument of `{before}` stands in parentheses",
                "el argumento de `{before}` va entre paréntesis"
            );
            let argument = self.product_ahead();
            let now = &source[argument.range()];
            let span = last.span.to(argument);
            let diagnostic = Diagnostic::error("missing-parentheses", wrong, span);
            let diagnostic = diagnostic.with_hint(words!("write {before}({now})", "escribe {before}({now})"));
            return self.say(diagnostic.with_fix(span, format!("{before}({now})")));
        }
        let wrong = words!(
            "an operator is missing between `{before}` and `{now}`",
            "falta un operador entre `{before}` y `{now}`"
        );
        let is_call = *self.peek_ahead(1) == TokenKind::Symbol(Symbol::LeftParenthesis);
        let rest = match now {
            "(" => "...)",
            "√" => "...",
            _ if is_call => "(...)",
            _ => "",
        };
        let hint = words!(
            "a product is written with *: {before}*{now}{rest}",
            "un producto se escribe con *: {before}*{now}{rest}"
        );
        let mut diagnostic = Diagnostic::error("missing-operator", wrong, place).with_hint(hint).with_fix(gap, "*");
        let is_number = matches!(last.kind, ExpressionKind::Number { unit: None, .. });
        let is_name = matches!(self.peek(), TokenKind::Name { order: 0, .. });
        if is_number && is_name && units::Unit::parse(now).is_ok() {
            diagnostic = diagnostic
                .with_hint(words!(
                    "a unit stands in brackets: {before} [{now}]",
                    "una unidad va entre corchetes: {before} [{now}]"
                ))
                .with_fix(gap.to(next), format!(" [{now}]"));
        }
        self.say(diagnostic);
    }
}

/// The operand that stands last in an expression.
fn last_operand(expression: &Expression) -> &Expression {
    match &expression.kind {
        ExpressionKind::Binary(_, _, last) | ExpressionKind::Unary(_, last) if last.span.end == expression.span.end => {
            last_operand(last)
        }
        _ => expression,
    }
}
