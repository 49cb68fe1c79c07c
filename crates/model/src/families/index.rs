//! Integers in indices and their ranges.

use crate::{BinaryOperator, Diagnostic, Expression, ExpressionKind, UnaryOperator};
use program::Size;
use units::{Unit, words};

/// Current values of the indices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Bindings {
    names: Vec<(String, i64)>,
}

impl Bindings {
    /// Binds an index to a value until [`Self::pop`].
    pub fn push(&mut self, name: &str, value: i64) {
        self.names.push((name.to_owned(), value));
    }

    /// Removes the last binding.
    pub fn pop(&mut self) {
        self.names.pop();
    }

    /// True if no index is bound.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    /// Value of an index.
    pub fn value(&self, name: &str) -> Option<i64> {
        self.names.iter().rfind(|(known, _)| known == name).map(|(_, value)| *value)
    }
}

/// Reason why an expression is not an integer.
#[derive(Clone, Copy, Debug)]
enum Fault<'a> {
    /// Neither an integer nor composed of integers, sizes and indices.
    NotWhole(&'a Expression),
    /// Absolute value above the limit.
    TooLarge(&'a Expression),
}

/// Integer value of an index or of an end of its range.
///
/// # Errors
/// If the expression is not composed of integers, sizes and indices, or is too large.
pub(crate) fn whole_number(
    expression: &Expression,
    sizes: &[Size],
    bindings: &Bindings,
) -> Result<i64, Box<Diagnostic>> {
    evaluate(expression, sizes, bindings).map_err(|fault| {
        let (Fault::NotWhole(part) | Fault::TooLarge(part)) = fault;
        if part.kind == ExpressionKind::Error {
            // The parser has already reported the syntax error.
            let message = words("this index could not be read");
            return Box::new(Diagnostic::error("index-not-whole", message, part.span));
        }
        if let Fault::TooLarge(_) = fault {
            let message = words("this index is too large");
            return Box::new(Diagnostic::error("index-not-whole", message, part.span));
        }
        let message = words("an index is a whole number");
        let diagnostic = Diagnostic::error("index-not-whole", message, part.span);
        let written = crate::notation::quote(expression);
        let hint = if Unit::parse(&written).is_ok() {
            words!("a unit stands after a number, as in `1 [{written}]`, or after `in`")
        } else {
            words("it is made of whole numbers, sizes (`size N = 20`) and the names after `for`")
        };
        Box::new(diagnostic.with_hint(hint))
    })
}

fn evaluate<'a>(expression: &'a Expression, sizes: &[Size], bindings: &Bindings) -> Result<i64, Fault<'a>> {
    /// Limit of an index. All integers up to it are exact as numbers of an expression.
    const GREATEST: i64 = 1 << 40;
    let of = |operand: &'a Expression| evaluate(operand, sizes, bindings);
    let value = match &expression.kind {
        ExpressionKind::Number { value, unit: None } if value.fract() == 0.0 => {
            if value.abs() > GREATEST as f64 {
                return Err(Fault::TooLarge(expression));
            }
            *value as i64
        }
        ExpressionKind::Name { name, order: 0 } => {
            let size = || sizes.iter().find(|size| size.name == *name).map(|size| i64::from(size.value));
            bindings.value(name).or_else(size).ok_or(Fault::NotWhole(expression))?
        }
        ExpressionKind::Unary(UnaryOperator::Negate, operand) => -of(operand)?,
        ExpressionKind::Binary(operator, left, right) => {
            let (left, right) = (of(left)?, of(right)?);
            match operator {
                BinaryOperator::Add => left + right,
                BinaryOperator::Subtract => left - right,
                BinaryOperator::Multiply => left.checked_mul(right).ok_or(Fault::TooLarge(expression))?,
                BinaryOperator::Divide if right != 0 && left % right == 0 => left / right,
                _ => return Err(Fault::NotWhole(expression)),
            }
        }
        ExpressionKind::Call { function, arguments } => {
            let arguments = arguments.iter().map(of).collect::<Result<Vec<i64>, _>>()?;
            match (function.text.as_str(), arguments.as_slice()) {
                ("mod", &[value, divisor]) if divisor > 0 => value.rem_euclid(divisor),
                ("min", [_, ..]) => arguments.into_iter().min().unwrap_or_default(),
                ("max", [_, ..]) => arguments.into_iter().max().unwrap_or_default(),
                _ => return Err(Fault::NotWhole(expression)),
            }
        }
        _ => return Err(Fault::NotWhole(expression)),
    };
    if value.abs() > GREATEST { Err(Fault::TooLarge(expression)) } else { Ok(value) }
}
