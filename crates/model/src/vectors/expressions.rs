//! Expands vector expressions to their components.

use super::faults;
use super::known::Vectors;
use crate::components::{component_name, split_component};
use crate::functions::is_too_deep;
use crate::{BinaryOperator, Diagnostic, Expansion, Expression, ExpressionKind, Span, UnaryOperator, limits};
use units::{Unit, words};

/// An expanded expression.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Number(Expression),
    /// Components of a vector.
    Vector(Vec<Expression>),
    /// An error was already reported.
    Unknown,
}

impl Value {
    /// True for a literal 0, which also stands for the zero vector.
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Number(Expression { kind: ExpressionKind::Number { value: 0.0, unit: None }, .. }))
    }
}

/// Expands vectors.
pub(super) struct Writer<'a> {
    pub vectors: &'a Vectors,
    /// Nodes that may still be copied: nested products double with each level.
    budget: usize,
    pub diagnostics: Vec<Diagnostic>,
}

impl<'a> Writer<'a> {
    pub fn new(vectors: &'a Vectors) -> Self {
        Self { vectors, budget: limits::MEMBER_OPERATIONS, diagnostics: Vec::new() }
    }

    /// Returns all diagnostics. A fault that occurs in every member of a family is reported once.
    pub fn finish(mut self) -> Vec<Diagnostic> {
        let mut places = std::collections::HashSet::new();
        self.diagnostics.retain(|diagnostic| places.insert((diagnostic.code, diagnostic.span())));
        self.diagnostics
    }

    /// Reports an error and returns [`Value::Unknown`].
    pub fn refuse(&mut self, diagnostic: Diagnostic) -> Value {
        if self.diagnostics.len() < limits::TOLD {
            self.diagnostics.push(diagnostic);
        }
        Value::Unknown
    }

    /// Components of a value; none if it is unknown.
    pub fn components(&mut self, value: Value) -> Vec<Expression> {
        let components = match value {
            Value::Number(number) => vec![number],
            Value::Vector(components) => components,
            Value::Unknown => return Vec::new(),
        };
        if let Some(deep) = components.iter().find(|component| is_too_deep(component)) {
            let span = deep.span;
            self.too_large(span);
        }
        components
    }

    /// Expands an expression that must be a number; [`ExpressionKind::Error`] if it is not.
    pub fn number(&mut self, expression: &Expression) -> Expression {
        match self.value(expression) {
            Value::Number(number) => {
                let value = Value::Number(number);
                self.components(value).pop()
            }
            Value::Vector(_) => {
                self.refuse(faults::vector_for_number(expression));
                None
            }
            Value::Unknown => None,
        }
        .unwrap_or(Expression { kind: ExpressionKind::Error, span: expression.span })
    }

    /// Copies a subexpression and charges the budget.
    pub fn copy(&mut self, expression: &Expression) -> Expression {
        if self.budget > 0 {
            let mut parts = 0;
            crate::names::for_each(expression, |_| parts += 1);
            self.budget = self.budget.saturating_sub(parts);
            if self.budget == 0 {
                self.too_large(expression.span);
            }
        }
        if self.budget == 0 {
            return Expression { kind: ExpressionKind::Error, span: expression.span };
        }
        expression.clone()
    }

    fn too_large(&mut self, span: Span) {
        let message = words("with its vectors written out in components, this expression is too large");
        self.refuse(
            Diagnostic::error("model-too-large", message, span)
                .with_hint(words("define parts of it as quantities of their own")),
        );
    }

    /// Expands an expression.
    pub fn value(&mut self, expression: &Expression) -> Value {
        let span = expression.span;
        let number = |kind| Value::Number(Expression { kind, span });
        match &expression.kind {
            ExpressionKind::Number { .. }
            | ExpressionKind::Text(_)
            | ExpressionKind::Member { .. }
            | ExpressionKind::Reduction { .. } => Value::Number(expression.clone()),
            ExpressionKind::Error => Value::Unknown,
            ExpressionKind::Name { name, order } => {
                self.name(name, expression, |name| ExpressionKind::Name { name, order: *order })
            }
            ExpressionKind::InitialValue { name, order } => {
                self.name(name, expression, |name| ExpressionKind::InitialValue { name, order: *order })
            }
            ExpressionKind::Tuple { parts, unit } => self.tuple(parts, unit.as_ref(), span),
            ExpressionKind::Component { of, axis } => self.component(of, *axis, expression),
            ExpressionKind::Unary(operator @ UnaryOperator::Negate, operand) => {
                let value = self.value(operand);
                each(value, |part| ExpressionKind::Unary(*operator, Box::new(part)), span)
            }
            ExpressionKind::Unary(operator @ UnaryOperator::Not, operand) => {
                let operand = Box::new(self.number(operand));
                number(ExpressionKind::Unary(*operator, operand))
            }
            ExpressionKind::Binary(..) => self.chain(expression),
            ExpressionKind::Call { function, arguments } => self.call(function, arguments, span),
            ExpressionKind::Expansion(expansion) => {
                let value = self.value(&expansion.body);
                let of = |body| ExpressionKind::Expansion(Box::new(Expansion { body, ..(**expansion).clone() }));
                each(value, of, span)
            }
            ExpressionKind::If(condition, chosen, other) => self.branches(condition, chosen, other, span),
        }
    }

    /// Components of a name that is a vector.
    fn name(&mut self, name: &str, expression: &Expression, of: impl Fn(String) -> ExpressionKind) -> Value {
        let span = expression.span;
        if let Some(dimension) = self.vectors.dimension(name) {
            let component = |axis| Expression { kind: of(component_name(name, axis)), span };
            return Value::Vector((0..dimension).map(component).collect());
        }
        if let Some((vector, member)) = name.rsplit_once('.')
            && let Some(dimension) = self.vectors.dimension(vector)
        {
            let axis = split_component(name).map(|(_, axis)| axis);
            if axis.is_none_or(|axis| axis >= dimension) {
                return self.refuse(faults::no_component(vector, member, dimension, span));
            }
        }
        Value::Number(expression.clone())
    }

    /// `(1, 0) [au]`. Each component keeps a copy of the others, because all have one dimension.
    fn tuple(&mut self, parts: &[Expression], unit: Option<&Unit>, span: Span) -> Value {
        let before = self.diagnostics.len();
        let mut own: Vec<Expression> = Vec::with_capacity(parts.len());
        for part in parts {
            let part = self.number(part);
            own.push(match unit {
                Some(unit) => with_unit(part, unit),
                None => part,
            });
        }
        if self.diagnostics.len() > before {
            return Value::Unknown;
        }
        let component = |writer: &mut Self, axis: usize| {
            let parts = own.iter().map(|part| writer.copy(part)).collect();
            let of = Box::new(Expression { kind: ExpressionKind::Tuple { parts, unit: None }, span });
            let place = own.get(axis).map_or(span, |part| part.span);
            Expression { kind: ExpressionKind::Component { of, axis }, span: place }
        };
        Value::Vector((0..own.len()).map(|axis| component(self, axis)).collect())
    }

    /// `r[1].x` and `(a - b).y`.
    fn component(&mut self, of: &Expression, axis: usize, whole: &Expression) -> Value {
        match self.value(of) {
            Value::Vector(mut components) if axis < components.len() => Value::Number(components.swap_remove(axis)),
            Value::Vector(components) => {
                let (vector, member) = (crate::notation::quote(of), component_name("", axis));
                let member = member.trim_start_matches('.');
                self.refuse(faults::no_component(&vector, member, components.len(), whole.span))
            }
            Value::Number(_) => self.refuse(faults::component_of_number(of, whole)),
            Value::Unknown => Value::Unknown,
        }
    }

    /// `a + b + c`: operator chains are nested to the left, one level per operator. A loop avoids deep recursion.
    fn chain(&mut self, expression: &Expression) -> Value {
        let mut chain = Vec::new();
        let mut first = expression;
        while let ExpressionKind::Binary(operator, left, right) = &first.kind {
            chain.push((*operator, &**left, &**right, first.span));
            first = left;
        }
        let mut value = self.value(first);
        for (operator, left, right, span) in chain.into_iter().rev() {
            let other = self.value(right);
            value = self.binary(operator, (left, value), (right, other), span);
        }
        value
    }

    fn branches(&mut self, condition: &Expression, chosen: &Expression, other: &Expression, span: Span) -> Value {
        let condition = self.number(condition);
        let (one, two) = (self.value(chosen), self.value(other));
        let if_else = |condition, one, two| {
            let [condition, one, two] = [condition, one, two].map(Box::new);
            Expression { kind: ExpressionKind::If(condition, one, two), span }
        };
        match self.alike((chosen, one), (other, two)) {
            Some((Value::Number(one), Value::Number(two))) => Value::Number(if_else(condition, one, two)),
            Some((Value::Vector(one), Value::Vector(two))) => {
                let parts = one.into_iter().zip(two);
                Value::Vector(parts.map(|(one, two)| if_else(self.copy(&condition), one, two)).collect())
            }
            _ => Value::Unknown,
        }
    }

    /// Requires two numbers, or two vectors of equal dimension; a literal 0 is also the zero vector.
    pub fn alike(
        &mut self,
        (left, mut one): (&Expression, Value),
        (right, mut two): (&Expression, Value),
    ) -> Option<(Value, Value)> {
        if let (Value::Vector(components), true) = (&two, one.is_zero()) {
            one = zero(components.len(), left.span);
        } else if let (Value::Vector(components), true) = (&one, two.is_zero()) {
            two = zero(components.len(), right.span);
        }
        match (&one, &two) {
            (Value::Unknown, _) | (_, Value::Unknown) => None,
            (Value::Number(_), Value::Number(_)) => Some((one, two)),
            (Value::Vector(components), Value::Vector(others)) => {
                if components.len() == others.len() {
                    return Some((one, two));
                }
                self.refuse(faults::different_dimensions((left, components.len()), (right, others.len())));
                None
            }
            (Value::Vector(_), Value::Number(_)) => {
                self.refuse(faults::vector_and_number(left, right));
                None
            }
            (Value::Number(_), Value::Vector(_)) => {
                self.refuse(faults::vector_and_number(right, left));
                None
            }
        }
    }

    fn binary(
        &mut self,
        operator: BinaryOperator,
        (left, one): (&Expression, Value),
        (right, two): (&Expression, Value),
        span: Span,
    ) -> Value {
        let of = |one, two| Expression::binary(operator, one, two, span);
        match (operator, one, two) {
            (_, Value::Unknown, _) | (_, _, Value::Unknown) => Value::Unknown,
            (_, Value::Number(one), Value::Number(two)) => Value::Number(of(one, two)),
            (BinaryOperator::Add | BinaryOperator::Subtract, one, two) => match self.alike((left, one), (right, two)) {
                Some((Value::Vector(one), Value::Vector(two))) => {
                    Value::Vector(one.into_iter().zip(two).map(|(one, two)| of(one, two)).collect())
                }
                _ => Value::Unknown,
            },
            (BinaryOperator::Multiply, Value::Number(factor), Value::Vector(parts)) => {
                Value::Vector(parts.into_iter().map(|part| of(self.copy(&factor), part)).collect())
            }
            (BinaryOperator::Multiply | BinaryOperator::Divide, Value::Vector(parts), Value::Number(factor)) => {
                Value::Vector(parts.into_iter().map(|part| of(part, self.copy(&factor))).collect())
            }
            (BinaryOperator::Multiply, ..) => self.refuse(faults::product(left, right, span)),
            (BinaryOperator::Divide, ..) => self.refuse(faults::division(right)),
            (BinaryOperator::Power, Value::Vector(_), _) => self.refuse(faults::power(left, span)),
            (BinaryOperator::Power, ..) => self.refuse(faults::vector_for_number(right)),
            (BinaryOperator::And | BinaryOperator::Or, one, _) => {
                let side = if matches!(one, Value::Vector(_)) { left } else { right };
                self.refuse(faults::vector_for_number(side))
            }
            (_, one, _) => {
                let side = if matches!(one, Value::Vector(_)) { left } else { right };
                self.refuse(faults::comparison(side, span))
            }
        }
    }
}

/// Applies `of` to each component of a value.
fn each(value: Value, of: impl Fn(Expression) -> ExpressionKind, span: Span) -> Value {
    let one = |part| Expression { kind: of(part), span };
    match value {
        Value::Number(number) => Value::Number(one(number)),
        Value::Vector(parts) => Value::Vector(parts.into_iter().map(one).collect()),
        Value::Unknown => Value::Unknown,
    }
}

/// The zero vector.
pub(super) fn zero(dimension: usize, span: Span) -> Value {
    let zero = Expression::number(0.0, span);
    Value::Vector(vec![zero; dimension])
}

/// A component with the unit that follows the vector.
fn with_unit(part: Expression, unit: &Unit) -> Expression {
    let span = part.span;
    let kind = match part.kind {
        ExpressionKind::Number { value, unit: None } => ExpressionKind::Number { value, unit: Some(unit.clone()) },
        ExpressionKind::Unary(UnaryOperator::Negate, operand) => {
            ExpressionKind::Unary(UnaryOperator::Negate, Box::new(with_unit(*operand, unit)))
        }
        kind => {
            let one = ExpressionKind::Number { value: 1.0, unit: Some(unit.clone()) };
            let [part, one] = [kind, one].map(|kind| Box::new(Expression { kind, span }));
            ExpressionKind::Binary(BinaryOperator::Multiply, part, one)
        }
    };
    Expression { kind, span }
}
