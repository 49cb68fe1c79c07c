//! Infers types and dimensions of expressions.

use super::alike::Alike;
use super::form::{Conflict, Form, Solver};
use super::terms::{Place, Term};
use super::types::{Type, Types};
use crate::names::{Meaning, Scope};
use crate::notation::quote;
use crate::{BinaryOperator, Diagnostic, Expression, ExpressionKind, Span, UnaryOperator};
use program::Kind;
use units::{Exponent, Words, words};

const ARITHMETIC: Words = words("an arithmetic operation");
const POWER: Words = words("a power");

#[cfg(test)]
thread_local! {
    /// Number of expressions whose type was inferred.
    pub(super) static INFERRED: std::cell::Cell<usize> = const { std::cell::Cell::new(0) };
}

/// Infers the types of expressions and collects mismatches.
#[derive(Debug)]
pub(crate) struct Inference<'a> {
    pub scope: &'a Scope,
    pub types: &'a mut Types,
    pub solver: Solver,
    pub alike: Alike,
    pub diagnostics: Vec<Diagnostic>,
}

impl Inference<'_> {
    /// The type of an expression.
    pub fn expression(&mut self, expression: &Expression) -> Type {
        #[cfg(test)]
        INFERRED.set(INFERRED.get() + 1);
        match &expression.kind {
            ExpressionKind::Number { unit: Some(unit), .. } => Type::Number(unit.dimension.into()),
            ExpressionKind::Number { value: 0.0, unit: None } => Type::Number(self.solver.fresh()),
            ExpressionKind::Number { .. } => Type::Number(Form::pure()),
            ExpressionKind::Text(_) => Type::Text,
            ExpressionKind::InitialValue { name, .. } if self.scope.table(name).is_some() => {
                let table = self.scope.table(name);
                table.map_or(Type::Unknown, |table| Type::Number(table.value.into()))
            }
            ExpressionKind::Name { name, order } | ExpressionKind::InitialValue { name, order } => {
                self.name(name, *order, expression.span)
            }
            ExpressionKind::Unary(UnaryOperator::Not, operand) => {
                self.truth(operand, &words("the operand of `not`"));
                Type::Truth
            }
            ExpressionKind::Unary(UnaryOperator::Negate, _)
            | ExpressionKind::Binary(BinaryOperator::Add | BinaryOperator::Subtract, ..) => {
                let mut terms = Vec::new();
                self.terms(expression, &mut terms);
                self.equal(&terms, Place::Sum)
            }
            ExpressionKind::Binary(operator, left, right) => self.binary(*operator, left, right, expression.span),
            ExpressionKind::Call { function, arguments } => self.call(function, arguments),
            ExpressionKind::If(condition, chosen, other) => {
                self.truth(condition, &words("the condition of `if`"));
                let (chosen_type, other_type) = (self.expression(chosen), self.expression(other));
                self.same_kind((chosen, chosen_type), (other, other_type), Place::Branches)
            }
            ExpressionKind::Expansion(expansion) => self.expansion(expansion, expression.span),
            ExpressionKind::Component { of, axis } => self.component(of, *axis),
            // Families have been expanded before.
            ExpressionKind::Tuple { .. }
            | ExpressionKind::Member { .. }
            | ExpressionKind::Reduction { .. }
            | ExpressionKind::Error => Type::Unknown,
        }
    }

    fn name(&mut self, name: &str, order: u32, span: Span) -> Type {
        let form = match self.scope.meaning(name) {
            Some(Meaning::Parameter(index)) => match self.types.parameter_kinds.get(index) {
                Some(Kind::Truth) => return Type::Truth,
                Some(Kind::Text) => return Type::Text,
                _ => self.types.parameters[index].clone(),
            },
            Some(Meaning::Independent) => self.types.independent.clone(),
            Some(Meaning::Pi) => Form::pure(),
            Some(Meaning::Variable(index)) => self.types.unknowns[index].clone(),
            Some(Meaning::Definition(index)) => match &self.types.definitions[index] {
                Type::Number(form) => form.clone(),
                other if order == 0 || *other == Type::Unknown => return other.clone(),
                _ => {
                    let message = words!("`{name}` has no derivative: it is not a number");
                    return self.refuse(Diagnostic::error("type-mismatch", message, span));
                }
            },
            None => return Type::Unknown,
        };
        self.derivative(&form, order).map_or_else(|| self.too_large(span), Type::Number)
    }

    /// Dimension of the derivative with `order` primes.
    pub fn derivative(&self, form: &Form, order: u32) -> Option<Form> {
        if order == 0 {
            return Some(form.clone());
        }
        let divisor = self.types.independent.power(Exponent::new(i64::from(order), 1)?).ok()?;
        form.per(&divisor).ok()
    }

    /// Collects the terms of a sum, through nested sums and signs. A literal 0 is left out because it fits every dimension.
    pub fn terms<'e>(&mut self, expression: &'e Expression, terms: &mut Vec<Term<'e>>) {
        let mut waiting = vec![expression];
        while let Some(next) = waiting.pop() {
            match &next.kind {
                ExpressionKind::Unary(UnaryOperator::Negate, operand) => waiting.push(operand),
                ExpressionKind::Binary(BinaryOperator::Add | BinaryOperator::Subtract, left, right) => {
                    waiting.push(right);
                    waiting.push(left);
                }
                ExpressionKind::Number { value: 0.0, unit: None } => {}
                _ => {
                    let form = self.number(next, &|| ARITHMETIC);
                    terms.push(Term { expression: next, form });
                }
            }
        }
    }

    /// Dimension of an operand that must be a number; `None` after reporting any other type.
    pub(super) fn number(&mut self, expression: &Expression, user: &dyn Fn() -> Words) -> Option<Form> {
        let found = match self.expression(expression) {
            Type::Number(form) => return Some(form),
            Type::Unknown => return None,
            found => found,
        };
        let (user, quoted) = (user(), quote(expression));
        let message = words!("{user} needs numbers, but `{quoted}` is {found}", found = found.described());
        let mut diagnostic = Diagnostic::error("type-mismatch", message, expression.span);
        if found == Type::Truth {
            diagnostic = diagnostic.with_hint(words!("`if {quoted} then 1 else 0` is a number"));
        }
        self.diagnostics.push(diagnostic);
        None
    }

    /// Requires a truth value.
    pub fn truth(&mut self, expression: &Expression, user: &Words) {
        let found = self.expression(expression);
        if matches!(found, Type::Truth | Type::Unknown) {
            return;
        }
        let quoted = quote(expression);
        let message = words!("{user} must be true or false, but `{quoted}` is {found}", found = found.described());
        self.diagnostics.push(
            Diagnostic::error("type-mismatch", message, expression.span)
                .with_hint(words("compare it with something: `<`, `==`")),
        );
    }

    fn binary(&mut self, operator: BinaryOperator, left: &Expression, right: &Expression, span: Span) -> Type {
        match operator {
            BinaryOperator::Power => self.power(left, right, span),
            BinaryOperator::Equal | BinaryOperator::NotEqual => {
                let (left_type, right_type) = (self.expression(left), self.expression(right));
                self.same_kind((left, left_type), (right, right_type), Place::Sides);
                Type::Truth
            }
            BinaryOperator::Less
            | BinaryOperator::LessOrEqual
            | BinaryOperator::Greater
            | BinaryOperator::GreaterOrEqual => {
                let sides = [left, right]
                    .map(|side| Term { expression: side, form: self.number(side, &|| words("a comparison")) });
                self.equal(&sides, Place::Sides);
                Type::Truth
            }
            BinaryOperator::Multiply | BinaryOperator::Divide => self.product(left, operator, right),
            BinaryOperator::And | BinaryOperator::Or => self.connection(left, operator, right),
            BinaryOperator::Add | BinaryOperator::Subtract => Type::Unknown,
        }
    }

    /// `left*right` or `left/right`. Long products are nested to the left; a loop avoids deep recursion.
    fn product(&mut self, left: &Expression, operator: BinaryOperator, right: &Expression) -> Type {
        let mut factors = vec![(operator, right)];
        let mut first = left;
        while let ExpressionKind::Binary(operator @ (BinaryOperator::Multiply | BinaryOperator::Divide), left, right) =
            &first.kind
        {
            factors.push((*operator, right));
            first = left;
        }
        let mut product = self.number(first, &|| ARITHMETIC);
        for (operator, factor) in factors.into_iter().rev() {
            let form = self.number(factor, &|| ARITHMETIC);
            let (Some(before), Some(form)) = (&product, form) else {
                product = None;
                continue;
            };
            let result = if operator == BinaryOperator::Multiply { before.times(&form) } else { before.per(&form) };
            let Ok(result) = result else {
                return self.too_large(first.span.to(factor.span));
            };
            product = Some(result);
        }
        product.map_or(Type::Unknown, Type::Number)
    }

    /// `left and right` or `left or right`, nested to the left like products.
    fn connection(&mut self, left: &Expression, operator: BinaryOperator, right: &Expression) -> Type {
        let mut sides = vec![(operator, right)];
        let mut first = left;
        while let ExpressionKind::Binary(operator @ (BinaryOperator::And | BinaryOperator::Or), left, right) =
            &first.kind
        {
            sides.push((*operator, right));
            first = left;
        }
        let innermost = sides.last().map_or(operator, |(operator, _)| *operator);
        sides.push((innermost, first));
        for (operator, side) in sides.into_iter().rev() {
            self.truth(
                side,
                &match operator {
                    BinaryOperator::And => words("a side of `and`"),
                    _ => words("a side of `or`"),
                },
            );
        }
        Type::Truth
    }

    /// Requires one type of two branches or two sides of a comparison, and returns it.
    fn same_kind(&mut self, left: (&Expression, Type), right: (&Expression, Type), place: Place) -> Type {
        match (&left.1, &right.1) {
            (Type::Unknown, other) | (other, Type::Unknown) => other.clone(),
            (Type::Number(left_form), Type::Number(right_form)) => {
                let terms = [(left.0, left_form), (right.0, right_form)]
                    .map(|(expression, form)| Term { expression, form: Some(form.clone()) });
                self.equal(&terms, place)
            }
            (Type::Truth, Type::Truth) => Type::Truth,
            (Type::Text, Type::Text) => Type::Text,
            _ => {
                let what = if place == Place::Branches {
                    words("the branches of `if`")
                } else {
                    words("the sides of a comparison")
                };
                let diagnostic = Diagnostic::error("type-mismatch", words!("{what} are not of one kind"), left.0.span)
                    .saying(words!("this is {kind}", kind = left.1.described()))
                    .with_label(right.0.span, words!("this is {kind}", kind = right.1.described()));
                self.refuse(diagnostic)
            }
        }
    }

    fn power(&mut self, base: &Expression, exponent: &Expression, span: Span) -> Type {
        let forms = (self.number(base, &|| POWER), self.number(exponent, &|| POWER));
        let (Some(form), Some(exponent_form)) = forms else { return Type::Unknown };
        let rational = self.constant(exponent).and_then(Exponent::from_number);
        if let Some(rational) = rational {
            return form.power(rational).map_or_else(|_| self.too_large(span), Type::Number);
        }
        self.pure(exponent, &exponent_form, || words("an exponent"));
        let reason = if self.constant(exponent).is_some() {
            words!("the base of a power with the exponent {}", quote(exponent))
        } else {
            words!("the base of a power whose exponent, `{}`, is not a fixed number", quote(exponent))
        };
        self.pure(base, &form, || reason);
        Type::Number(Form::pure())
    }

    /// Value of an expression of literal numbers without units.
    pub fn constant(&self, expression: &Expression) -> Option<f64> {
        match &expression.kind {
            ExpressionKind::Number { value, unit: None } => Some(*value),
            ExpressionKind::Name { name, order: 0 } => match self.scope.meaning(name)? {
                Meaning::Definition(index) => self.types.numbers.get(index).copied().flatten(),
                _ => None,
            },
            ExpressionKind::Unary(UnaryOperator::Negate, operand) => Some(-self.constant(operand)?),
            ExpressionKind::Expansion(expansion) => self.constant(&expansion.body),
            ExpressionKind::Component { of, axis } => self.constant(of.operands().get(*axis)?),
            ExpressionKind::Binary(operator, left, right) => {
                let (left, right) = (self.constant(left)?, self.constant(right)?);
                match operator {
                    BinaryOperator::Add => Some(left + right),
                    BinaryOperator::Subtract => Some(left - right),
                    BinaryOperator::Multiply => Some(left * right),
                    BinaryOperator::Divide => Some(left / right),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Requires a dimensionless number.
    pub(super) fn pure(&mut self, expression: &Expression, form: &Form, what: impl FnOnce() -> Words) {
        match self.solver.unify(form, &Form::pure(), expression.span) {
            Ok(()) => {}
            Err(Conflict::TooLarge) => {
                self.too_large(expression.span);
            }
            Err(Conflict::Different) if self.has_told_enough() => {}
            Err(Conflict::Different) => {
                let diagnostic = self.not_pure(expression, form, &what());
                self.diagnostics.push(diagnostic);
            }
        }
    }

    /// Reports an error and returns [`Type::Unknown`].
    pub fn refuse(&mut self, diagnostic: Diagnostic) -> Type {
        self.diagnostics.push(diagnostic);
        Type::Unknown
    }

    /// Reports that an exponent is out of bounds.
    pub fn too_large(&mut self, span: Span) -> Type {
        let message = words("the dimension of this has an exponent beyond all reason");
        self.refuse(Diagnostic::error("dimension-too-large", message, span))
    }
}
