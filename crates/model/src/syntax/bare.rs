//! Bare numbers: expressions of numbers without units.

use super::expression::{BinaryOperator, Expression, ExpressionKind, UnaryOperator};

impl Expression {
    /// Value of an expression that consists of numbers without units and of `+`, `-`, `*` and `/`, such as `-90` or `1/3`;
    /// otherwise `None`.
    pub fn bare_number(&self) -> Option<f64> {
        use BinaryOperator::{Add, Divide, Multiply, Subtract};
        match &self.kind {
            ExpressionKind::Number { value, unit: None } => Some(*value),
            ExpressionKind::Unary(UnaryOperator::Negate, operand) => Some(-operand.bare_number()?),
            ExpressionKind::Binary(operator @ (Add | Subtract | Multiply | Divide), left, right) => {
                let (left, right) = (left.bare_number()?, right.bare_number()?);
                let value = match operator {
                    Add => left + right,
                    Subtract => left - right,
                    Multiply => left * right,
                    _ => left / right,
                };
                Some(value).filter(|value| value.is_finite())
            }
            _ => None,
        }
    }
}
