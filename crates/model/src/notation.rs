//! Expressions in the syntax of the language, for messages that quote them.

use crate::components::component_name;
use crate::{BinaryOperator, Expression, ExpressionKind, UnaryOperator};
use std::fmt::{self, Write};

/// Maximum length of a quoted expression, in characters.
const LONGEST_QUOTE: usize = 48;

/// `name` followed by `order` primes.
pub(crate) fn primed(name: &str, order: u32) -> String {
    let mut text = name.to_owned();
    text.extend(std::iter::repeat_n('\'', order as usize));
    text
}

/// The expression as text, cut to [`LONGEST_QUOTE`] characters and `...`.
pub(crate) fn quote(expression: &Expression) -> String {
    let mut text = String::new();
    let mut writer = Shortened { text: &mut text, left: LONGEST_QUOTE };
    if write(&mut writer, expression, 0).is_err() {
        text.push_str("...");
    }
    text
}

/// Writer that fails when the quote would become too long.
struct Shortened<'a> {
    text: &'a mut String,
    left: usize,
}

impl Write for Shortened<'_> {
    fn write_str(&mut self, piece: &str) -> fmt::Result {
        let length = piece.chars().count();
        if length > self.left {
            self.text.extend(piece.chars().take(self.left));
            self.left = 0;
            return Err(fmt::Error);
        }
        self.left -= length;
        self.text.push_str(piece);
        Ok(())
    }
}

/// Binding strength of the outermost operator. An operand that binds less tightly than its surroundings needs parentheses.
fn tightness(expression: &Expression) -> u8 {
    match &expression.kind {
        ExpressionKind::If(..) => 0,
        ExpressionKind::Binary(operator, ..) => operator_text(*operator).1,
        ExpressionKind::Unary(UnaryOperator::Not, _) => 3,
        ExpressionKind::Unary(UnaryOperator::Negate, _) => 6,
        _ => 9,
    }
}

fn operator_text(operator: BinaryOperator) -> (&'static str, u8) {
    match operator {
        BinaryOperator::Or => (" or ", 1),
        BinaryOperator::And => (" and ", 2),
        BinaryOperator::Less => (" < ", 4),
        BinaryOperator::LessOrEqual => (" <= ", 4),
        BinaryOperator::Greater => (" > ", 4),
        BinaryOperator::GreaterOrEqual => (" >= ", 4),
        BinaryOperator::Equal => (" == ", 4),
        BinaryOperator::NotEqual => (" != ", 4),
        BinaryOperator::Add => (" + ", 5),
        BinaryOperator::Subtract => (" - ", 5),
        BinaryOperator::Multiply => ("*", 6),
        BinaryOperator::Divide => ("/", 6),
        BinaryOperator::Power => ("^", 8),
    }
}

fn list(out: &mut impl Write, expressions: &[Expression]) -> fmt::Result {
    for (number, expression) in expressions.iter().enumerate() {
        if number > 0 {
            out.write_str(", ")?;
        }
        write(out, expression, 0)?;
    }
    Ok(())
}

fn write(out: &mut impl Write, expression: &Expression, least: u8) -> fmt::Result {
    let own = tightness(expression);
    if own < least {
        out.write_char('(')?;
        write(out, expression, 0)?;
        return out.write_char(')');
    }
    match &expression.kind {
        ExpressionKind::Number { value, unit: None } => write!(out, "{value}"),
        ExpressionKind::Number { value, unit: Some(unit) } => write!(out, "{value} [{unit}]"),
        ExpressionKind::Text(text) => write!(out, "\"{text}\""),
        ExpressionKind::Name { name, order } => out.write_str(&primed(name, *order)),
        ExpressionKind::InitialValue { name, order } => write!(out, "{}(0)", primed(name, *order)),
        ExpressionKind::Member { name, indices, order, at_start } => {
            write!(out, "{name}[")?;
            list(out, indices)?;
            write!(out, "]{}{}", primed("", *order), if *at_start { "(0)" } else { "" })
        }
        ExpressionKind::Reduction { function, body, over } => {
            write!(out, "{}(", function.text)?;
            write(out, body, 0)?;
            for (number, over) in over.iter().enumerate() {
                write!(out, "{}{} in ", if number == 0 { " for " } else { ", " }, over.index.text)?;
                write(out, &over.low, 0)?;
                out.write_str("..")?;
                write(out, &over.high, 0)?;
            }
            out.write_char(')')
        }
        ExpressionKind::Tuple { parts, unit } => {
            out.write_char('(')?;
            list(out, parts)?;
            out.write_char(')')?;
            unit.as_ref().map_or(Ok(()), |unit| write!(out, " [{unit}]"))
        }
        ExpressionKind::Component { of, axis } => {
            write(out, of, 9)?;
            out.write_str(&component_name("", *axis))
        }
        ExpressionKind::Unary(UnaryOperator::Negate, operand) => {
            out.write_char('-')?;
            write(out, operand, 7)
        }
        ExpressionKind::Unary(UnaryOperator::Not, operand) => {
            out.write_str("not ")?;
            write(out, operand, 4)
        }
        ExpressionKind::Binary(operator, left, right) => {
            let (text, _) = operator_text(*operator);
            let (left_least, right_least) =
                if *operator == BinaryOperator::Power { (own + 1, own - 1) } else { (own, own + 1) };
            write(out, left, left_least)?;
            out.write_str(text)?;
            write(out, right, right_least)
        }
        ExpressionKind::Call { function, arguments } => {
            write!(out, "{}(", function.text)?;
            // The stream of a draw is not part of the source text.
            let hidden = usize::from(crate::chance::has_stream(arguments));
            list(out, arguments.get(hidden..).unwrap_or_default())?;
            out.write_char(')')
        }
        ExpressionKind::Expansion(expansion) => out.write_str(&expansion.written),
        ExpressionKind::If(condition, chosen, other) => {
            out.write_str("if ")?;
            write(out, condition, 0)?;
            out.write_str(" then ")?;
            write(out, chosen, 0)?;
            out.write_str(" else ")?;
            write(out, other, 0)
        }
        ExpressionKind::Error => out.write_char('?'),
    }
}
