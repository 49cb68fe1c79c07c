//! Expressions with equal keys, such as those of all members of a family, are checked once.

use super::alike::Part;
use super::infer::Inference;
use super::types::Type;
use crate::names::Meaning;
use crate::{BinaryOperator, Expression, ExpressionKind};
use std::mem::discriminant;

/// Minimum number of arguments of a call that is examined as a sum over a family.
const LEAST_ARGUMENTS: usize = 3;

impl Inference<'_> {
    /// Runs `check` unless an expression with these parts was checked before without errors.
    pub(super) fn check_once(&mut self, parts: Vec<Part>, check: impl FnOnce(&mut Self)) {
        if self.alike.checked.contains(&parts) {
            return;
        }
        let reported = self.diagnostics.len();
        check(self);
        if self.diagnostics.len() == reported {
            self.alike.checked.insert(parts);
        }
    }

    /// True if all arguments have equal parts, as in a sum over the members of a family.
    pub(super) fn are_alike(&self, arguments: &[Expression]) -> bool {
        let [first, others @ ..] = arguments else { return false };
        if arguments.len() < LEAST_ARGUMENTS {
            return false;
        }
        let first = self.parts(&[first]);
        others.iter().all(|other| self.parts(&[other]) == first)
    }

    /// Parts of several expressions that are checked together.
    pub(super) fn parts(&self, expressions: &[&Expression]) -> Vec<Part> {
        let mut parts = Vec::new();
        for expression in expressions {
            self.add_parts(expression, false, &mut parts);
        }
        parts
    }

    /// Type of a definition without a stated unit; that of an earlier definition with equal parts, if there is one.
    pub(super) fn defined(&mut self, index: usize, value: &Expression) -> Type {
        let parts = self.parts(&[value]);
        if let Some(&first) = self.alike.defined.get(&parts) {
            self.alike.definitions.insert(index, first);
            return self.types.definitions[first].clone();
        }
        let reported = self.diagnostics.len();
        let found = self.expression(value);
        // Each bare zero has a dimension of its own.
        let is_free = parts.contains(&Part::Number(None, Some(0)));
        if self.diagnostics.len() == reported && matches!(found, Type::Number(_)) && !is_free {
            self.alike.defined.insert(parts, index);
        }
        found
    }

    /// Appends the parts of an expression. `is_exact` is true in exponents, where values affect the dimension.
    fn add_parts(&self, expression: &Expression, is_exact: bool, parts: &mut Vec<Part>) {
        parts.push(match &expression.kind {
            ExpressionKind::Number { value, unit } => {
                let decides = is_exact || (*value == 0.0 && unit.is_none());
                Part::Number(unit.as_ref().map(|unit| unit.dimension), decides.then_some(value.to_bits()))
            }
            ExpressionKind::Name { name, order } | ExpressionKind::InitialValue { name, order } => {
                match self.meaning(name, is_exact) {
                    Some((meaning, value)) => Part::Name(meaning, *order, value),
                    None => Part::Call(name.clone(), 0),
                }
            }
            ExpressionKind::Unary(operator, _) => Part::Unary(*operator),
            ExpressionKind::Binary(operator, ..) => Part::Binary(*operator),
            ExpressionKind::Component { axis, .. } => Part::Component(*axis),
            ExpressionKind::Call { function, arguments } => Part::Call(function.text.clone(), arguments.len()),
            ExpressionKind::Expansion(expansion) => {
                let unit = expansion.unit.as_ref().map(|stated| stated.unit.dimension);
                Part::Expansion(expansion.function.clone(), unit)
            }
            ExpressionKind::Tuple { parts, .. } => Part::Kind(discriminant(&expression.kind), parts.len()),
            kind => Part::Kind(discriminant(kind), 0),
        });
        let is_power = matches!(expression.kind, ExpressionKind::Binary(BinaryOperator::Power, ..));
        let mut place = 0;
        expression.for_each_operand(|operand| {
            self.add_parts(operand, is_exact || (is_power && place == 1), parts);
            place += 1;
        });
    }

    /// Meaning of a name, and the bits of its value if `is_exact` and the value is a known constant.
    fn meaning(&self, name: &str, is_exact: bool) -> Option<(Meaning, Option<u64>)> {
        Some(match self.scope.meaning(name)? {
            Meaning::Variable(index) => (Meaning::Variable(self.alike.first(index)), None),
            Meaning::Definition(index) => {
                let value = self.types.numbers.get(index).copied().flatten().filter(|_| is_exact);
                let first = self.alike.definitions.get(&index).copied().unwrap_or(index);
                (Meaning::Definition(first), value.map(f64::to_bits))
            }
            other => (other, None),
        })
    }
}
