//! Two operands without an operator between them: a product as in textbooks, the argument of a function, a unit without
//! brackets.

use crate::lexer::{Symbol, TokenKind};
use crate::parser::cursor::Cursor;
use crate::{BinaryOperator, Diagnostic, Expression, ExpressionKind, Span, UnaryOperator};
use program::functions::Function;
use units::words;

impl Cursor<'_> {
    /// Span of the names and numbers that are multiplied, divided or raised from the next token on: the argument in `sin
    /// omega*t`.
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

    /// Span of the parenthesis that begins at the next token, including its content.
    fn parenthesis_ahead(&self) -> Option<Span> {
        let mut depth = 0_usize;
        for ahead in 0.. {
            match self.peek_ahead(ahead) {
                TokenKind::Symbol(Symbol::LeftParenthesis) => depth += 1,
                TokenKind::Symbol(Symbol::RightParenthesis) => depth = depth.saturating_sub(1),
                TokenKind::Newline | TokenKind::End => return None,
                _ => {}
            }
            if depth == 0 {
                return (ahead > 0).then(|| self.span().to(self.span_ahead(ahead)));
            }
        }
        None
    }

    /// Reports `sin^2(x)`, `sin^2 x` and `sin^-1(x)`.
    fn power_before_argument(&mut self, power: &PowerOfFunction) {
        let PowerOfFunction { function, span, exponent } = power;
        let source = self.source;
        let argument = self.parenthesis_ahead();
        let end = argument.unwrap_or_else(|| self.product_ahead());
        let argument = match argument {
            Some(argument) => source[argument.range()].to_owned(),
            None => format!("({})", &source[end.range()]),
        };
        let is_inverse = is_minus_one(exponent);
        let ours = if is_inverse && ["sin", "cos", "tan"].contains(function) {
            format!("a{function}{argument}")
        } else {
            format!("{function}{argument}{}", &source[span.end..exponent.span.end])
        };
        let place = span.to(end);
        let written = &source[place.range()];
        let wrong = words!("`{written}` is written `{ours}` here");
        self.say(Diagnostic::error("foreign-power", wrong, place).with_fix(place, ours));
    }

    /// Reports the missing operator between an expression and the operand after it.
    pub(in crate::parser) fn missing_operator(&mut self, left: &Expression) {
        if let Some(power) = power_of_function(left) {
            return self.power_before_argument(&power);
        }
        let source = self.source;
        let next = self.span();
        // The operands next to the gap, without the rest of the expression.
        let last = last_operand(left);
        let before = &source[last.span.range()];
        let now = &source[next.range()];
        let gap = Span::new(left.span.end, next.start);
        let place = if gap.start < gap.end { gap } else { next };
        if let ExpressionKind::Name { name, order: 0 } = &last.kind
            && Function::named(name).is_some()
        {
            let wrong = words!("the argument of `{before}` stands in parentheses");
            let argument = self.product_ahead();
            let now = &source[argument.range()];
            let span = last.span.to(argument);
            let diagnostic = Diagnostic::error("missing-parentheses", wrong, span);
            let diagnostic = diagnostic.with_hint(words!("write {before}({now})"));
            return self.say(diagnostic.with_fix(span, format!("{before}({now})")));
        }
        let is_call = *self.peek_ahead(1) == TokenKind::Symbol(Symbol::LeftParenthesis);
        let rest = match now {
            "(" => "...)",
            "√" => "...",
            _ if is_call => "(...)",
            _ => "",
        };
        let product = words!("a product is written with *: {before}*{now}{rest}");
        let is_number = matches!(last.kind, ExpressionKind::Number { unit: None, .. });
        let unit = self.bare_unit().filter(|_| is_number);
        if let Some(unit) = unit.as_ref().filter(|unit| unit.is_certain) {
            return self.say(unit.after(before).with_hint(product).with_fix(gap, "*"));
        }
        let wrong = words!("an operator is missing between `{before}` and `{now}`");
        let mut diagnostic = Diagnostic::error("missing-operator", wrong, place).with_hint(product).with_fix(gap, "*");
        if let Some(unit) = unit {
            diagnostic = unit.with_brackets(diagnostic, before);
        }
        self.say(diagnostic);
    }
}

/// True for `-1` and `⁻¹`.
fn is_minus_one(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Unary(UnaryOperator::Negate, one) => {
            matches!(one.kind, ExpressionKind::Number { value: 1.0, unit: None })
        }
        _ => matches!(expression.kind, ExpressionKind::Number { value: -1.0, unit: None }),
    }
}

/// A power of a function name: `sin^2`.
struct PowerOfFunction<'e> {
    function: &'e str,
    /// Place of the function name.
    span: Span,
    exponent: &'e Expression,
}

/// A power of a function name at the end of an expression.
fn power_of_function(expression: &Expression) -> Option<PowerOfFunction<'_>> {
    match &expression.kind {
        ExpressionKind::Binary(BinaryOperator::Power, base, exponent) => match &base.kind {
            ExpressionKind::Name { name, order: 0 } if Function::named(name).is_some() => {
                Some(PowerOfFunction { function: name, span: base.span, exponent })
            }
            _ => None,
        },
        ExpressionKind::Binary(_, _, last) | ExpressionKind::Unary(_, last) if last.span.end == expression.span.end => {
            power_of_function(last)
        }
        _ => None,
    }
}

/// Last operand of an expression.
fn last_operand(expression: &Expression) -> &Expression {
    match &expression.kind {
        ExpressionKind::Binary(_, _, last) | ExpressionKind::Unary(_, last) if last.span.end == expression.span.end => {
            last_operand(last)
        }
        _ => expression,
    }
}
