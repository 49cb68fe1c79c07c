//! Two operands without an operator between them: a product as in textbooks, the argument of a function, a unit without
//! brackets.

use crate::lexer::{Symbol, TokenKind};
use crate::parser::cursor::Cursor;
use crate::parser::expression::bare_unit::BareUnit;
use crate::{BinaryOperator, Diagnostic, Expression, ExpressionKind, Span, UnaryOperator};
use program::functions::Function;
use units::words;

/// Maximum number of characters of the line that are searched for the index of a family.
const LOOKED_AT: usize = 200;

/// Maximum number of tokens of a unit.
const MOST_OF_UNIT: usize = 40;

/// Words that can follow a value and are no operands.
const WORDS: [&str; 12] =
    ["as", "for", "from", "within", "at", "against", "until", "step", "of", "always", "assigned", "over"];

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

    /// True if the next token, `i` directly after a number, is no index of a family or sum in the same line.
    fn is_imaginary(&self) -> bool {
        let at = self.span();
        let line: String = self.source[at.end..].chars().take_while(|c| *c != '\n').take(LOOKED_AT).collect();
        let index = format!("for {}", &self.source[at.range()]);
        let ends =
            line.trim_start().chars().next().is_none_or(|c| matches!(c, '+' | '-' | '*' | '/' | ')' | '"' | '#'));
        ends && !line.contains(&index)
    }

    /// True if another operand follows the names of a unit: `1/2 m y'^2` is a product.
    fn has_operand_after(&self, unit: &BareUnit<'_>) -> bool {
        let after = |&ahead: &usize| self.span_ahead(ahead).start >= unit.span.end;
        let Some(ahead) = (0..MOST_OF_UNIT).find(after) else { return false };
        match self.peek_ahead(ahead) {
            TokenKind::Name { text, .. } => !WORDS.contains(&text.as_str()),
            TokenKind::Number(_) => true,
            _ => false,
        }
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
        if is_number && gap.start == gap.end && matches!(now, "i" | "j") && self.is_imaginary() {
            let wrong = words("complex numbers are not part of the language");
            let hint = words("write the real and the imaginary part as two quantities");
            return self.say(Diagnostic::error("foreign-name", wrong, last.span.to(next)).with_hint(hint));
        }
        let unit = self.bare_unit().filter(|unit| is_number && !self.has_operand_after(unit));
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
