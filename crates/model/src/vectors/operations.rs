//! Vector functions: `norm`, `dot`, `cross`, and functions that apply to each component.

use super::expressions::{Value, Writer};
use super::faults;
use super::known::{DOT, NORM};
use crate::{BinaryOperator, Expression, ExpressionKind, Name, Span};

/// Linear functions, which apply to each component.
const LINEAR: [&str; 3] = ["sum", "mean", "integral"];

impl Writer<'_> {
    /// Expands a function call.
    pub(super) fn call(&mut self, function: &Name, arguments: &[Expression], span: Span) -> Value {
        let values: Vec<Value> = arguments.iter().map(|argument| self.value(argument)).collect();
        if values.iter().any(|value| matches!(value, Value::Unknown)) {
            return Value::Unknown;
        }
        if self.vectors.is_operation(&function.text) {
            return self.operation(function, arguments, values, span);
        }
        if values.iter().all(|value| matches!(value, Value::Number(_))) {
            let arguments = values.into_iter().flat_map(|value| self.components(value)).collect();
            return Value::Number(Expression {
                kind: ExpressionKind::Call { function: function.clone(), arguments },
                span,
            });
        }
        if LINEAR.contains(&function.text.as_str()) {
            return self.linear(function, arguments, values, span);
        }
        let vector = arguments.iter().zip(&values).find(|(_, value)| matches!(value, Value::Vector(_)));
        match vector {
            Some((argument, _)) => self.refuse(faults::in_function(&function.text, argument)),
            None => Value::Unknown,
        }
    }

    /// Expands `norm(r)`, `dot(a, b)` and `cross(a, b)`.
    fn operation(&mut self, function: &Name, arguments: &[Expression], values: Vec<Value>, span: Span) -> Value {
        let takes = if function.text == NORM { 1 } else { 2 };
        if values.len() != takes {
            return self.refuse(faults::wrong_count(&function.text, takes, values.len(), function.span));
        }
        let mut vectors = Vec::with_capacity(takes);
        for (argument, value) in arguments.iter().zip(values) {
            match value {
                Value::Vector(parts) => vectors.push(parts),
                _ => return self.refuse(faults::number_in_operation(&function.text, argument)),
            }
        }
        if let ([one, two], [left, right]) = (vectors.as_slice(), arguments)
            && one.len() != two.len()
        {
            return self.refuse(faults::different_dimensions((left, one.len()), (right, two.len())));
        }
        let mut vectors = vectors.into_iter();
        match (vectors.next(), vectors.next()) {
            (Some(parts), None) => Value::Number(self.norm(parts, span)),
            (Some(one), Some(two)) if function.text == DOT => {
                let products = one.into_iter().zip(two).map(|(one, two)| product(one, two, span));
                total(products, span).map_or(Value::Unknown, Value::Number)
            }
            (Some(one), Some(two)) => self.cross(&one, &two, span),
            _ => Value::Unknown,
        }
    }

    /// Square root of the sum of the squares.
    fn norm(&mut self, parts: Vec<Expression>, span: Span) -> Expression {
        let squares = parts
            .into_iter()
            .map(|part| Expression::binary(BinaryOperator::Power, part, Expression::number(2.0, span), span));
        Expression::call("sqrt", total(squares, span).into_iter().collect(), span)
    }

    /// Vector product. In the plane it is a number: the component along z.
    fn cross(&mut self, one: &[Expression], two: &[Expression], span: Span) -> Value {
        let mut component = |i: usize, j: usize| {
            let mut factor = |parts: &[Expression], axis: usize| {
                parts.get(axis).map_or_else(|| Expression::nothing(span), |part| self.copy(part))
            };
            let first = product(factor(one, i), factor(two, j), span);
            let second = product(factor(one, j), factor(two, i), span);
            Expression::binary(BinaryOperator::Subtract, first, second, span)
        };
        if one.len() == 2 {
            return Value::Number(component(0, 1));
        }
        Value::Vector([(1, 2), (2, 0), (0, 1)].into_iter().map(|(i, j)| component(i, j)).collect())
    }

    /// `sum(r[1], r[2])` and `mean(r)`, by components.
    fn linear(&mut self, function: &Name, arguments: &[Expression], values: Vec<Value>, span: Span) -> Value {
        let dimension = values.iter().find_map(|value| match value {
            Value::Vector(parts) => Some(parts.len()),
            _ => None,
        });
        let dimension = dimension.unwrap_or_default();
        let mut components: Vec<Vec<Expression>> = vec![Vec::with_capacity(values.len()); dimension];
        let (mut first, mut of_first) = (None, None);
        for (argument, value) in arguments.iter().zip(values) {
            let value = if value.is_zero() { super::expressions::zero(dimension, argument.span) } else { value };
            let parts = match value {
                Value::Vector(parts) => parts,
                _ => {
                    let vector = of_first.or(arguments.last()).unwrap_or(argument);
                    return self.refuse(faults::vector_and_number(vector, argument));
                }
            };
            let number = *first.get_or_insert(parts.len());
            let vector = *of_first.get_or_insert(argument);
            if number != parts.len() {
                return self.refuse(faults::different_dimensions((vector, number), (argument, parts.len())));
            }
            components.iter_mut().zip(parts).for_each(|(all, part)| all.push(part));
        }
        let of = |arguments| Expression { kind: ExpressionKind::Call { function: function.clone(), arguments }, span };
        Value::Vector(components.into_iter().map(of).collect())
    }
}

fn product(left: Expression, right: Expression, span: Span) -> Expression {
    Expression::binary(BinaryOperator::Multiply, left, right, span)
}

fn total(terms: impl Iterator<Item = Expression>, span: Span) -> Option<Expression> {
    terms.reduce(|sum, term| Expression::binary(BinaryOperator::Add, sum, term, span))
}
