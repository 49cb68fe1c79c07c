//! What to do about a wrong dimension: what to multiply or divide by, which names of the model would do, and which
//! parameter probably lacks its unit.

use super::describe::{Factor, as_factor};
use super::form::Form;
use super::infer::Inference;
use super::mismatch::is_bare;
use super::types::Type;
use crate::names::{Meaning, alternatives, for_each_name};
use crate::notation::quote;
use crate::{BinaryOperator, Diagnostic, Expression, ExpressionKind, Span, UnaryOperator};
use units::{Dimension, Words, words};

/// The most names that a hint offers.
const MOST_OFFERS: usize = 3;

impl Inference<'_> {
    /// The diagnostic with what to do about a part of the wrong dimension.
    pub fn with_remedy(
        &self,
        diagnostic: Diagnostic,
        expression: &Expression,
        found: &Form,
        expected: &Form,
    ) -> Diagnostic {
        let expected_unit = self.solver.resolve(expected).ok().and_then(|form| form.dimension()).map(units::Unit::si);
        let (true, Some(unit)) = (is_bare(expression), expected_unit) else {
            return diagnostic.with_hint(self.change(expression, found, expected));
        };
        let quoted = quote(expression);
        let end = expression.span.end;
        diagnostic
            .with_hint(words!(
                "give the number a unit: `{quoted} [{unit}]`",
                "da una unidad al número: `{quoted} [{unit}]`"
            ))
            .with_fix(Span::new(end, end), format!(" [{unit}]"))
    }

    /// What to multiply or divide by.
    fn change(&self, expression: &Expression, found: &Form, expected: &Form) -> Words {
        let Some(factor) = self.factor(found, expected) else {
            return words(
                "state the units of the quantities involved",
                "declara las unidades de las magnitudes implicadas",
            );
        };
        let thing = as_factor(factor.dimension());
        let offers = self.offers(factor, expression);
        let unitless = self.forgotten_unit(expression, factor.lacking());
        let change = match factor {
            Factor::Lacking(_) => words("multiply", "multiplícalo"),
            Factor::Excess(_) => words("divide", "divídelo"),
        };
        words!(
            "{change} it by {thing}{offers}{unitless}",
            "{change} por {thing}{offers}{unitless}",
            change = change,
            thing = thing,
            offers = offers,
            unitless = unitless
        )
    }

    /// `, or give `omega` the unit [1/s]`, if a parameter without a unit is a factor of the expression.
    pub fn forgotten_unit(&self, expression: &Expression, lacking: Dimension) -> Words {
        match self.factor_without_unit(expression) {
            Some(name) => {
                let unit = units::Unit::si(lacking);
                words!(", or give `{name}` the unit [{unit}]", ", o da a `{name}` la unidad [{unit}]")
            }
            None => Words::default(),
        }
    }

    /// A parameter among the factors of a product that is a pure number: perhaps its unit was forgotten.
    fn factor_without_unit<'e>(&self, product: &'e Expression) -> Option<&'e str> {
        let mut waiting = vec![product];
        while let Some(next) = waiting.pop() {
            match &next.kind {
                ExpressionKind::Unary(UnaryOperator::Negate, inner) => waiting.push(inner),
                ExpressionKind::Binary(BinaryOperator::Multiply, left, right) => {
                    waiting.extend([right.as_ref(), left.as_ref()])
                }
                ExpressionKind::Binary(BinaryOperator::Divide, numerator, _) => waiting.push(numerator),
                ExpressionKind::Name { name, order: 0 } => {
                    if let Some(Meaning::Parameter(index)) = self.scope.meaning(name)
                        && self.types.parameters[index] == Form::pure()
                    {
                        return Some(name);
                    }
                }
                _ => {}
            }
        }
        None
    }

    /// `, such as L, h_l or h_r`: the names of the model with just this dimension. What is too many is first looked for in
    /// the expression itself, what is lacking everywhere.
    pub fn offers(&self, factor: Factor, expression: &Expression) -> Words {
        let wanted = factor.dimension();
        if wanted.is_none() {
            return Words::default();
        }
        let fits = |name: &str| self.dimension_of(name) == Some(wanted);
        let mut names: Vec<&str> = Vec::new();
        let quoted = quote(expression);
        let alone = |name: &str| quoted.trim_start_matches('-') == name;
        if matches!(factor, Factor::Excess(_)) {
            for_each_name(expression, |name, order, _| {
                if order == 0 && fits(name) && !alone(name) && !names.contains(&name) {
                    names.push(name);
                }
            });
        }
        if names.is_empty() {
            names = self.scope.names().filter(|name| fits(name) && !alone(name)).collect();
        }
        names.truncate(MOST_OFFERS);
        if names.is_empty() {
            return Words::default();
        }
        let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        words!(", such as {names}", ", por ejemplo {names}", names = alternatives(&names))
    }

    /// The dimension of a parameter, definition or unknown; the independent variable is no factor to offer.
    fn dimension_of(&self, name: &str) -> Option<Dimension> {
        let form = match self.scope.meaning(name)? {
            Meaning::Parameter(index) => self.types.parameters.get(index)?,
            Meaning::Definition(index) => match self.types.definitions.get(index)? {
                Type::Number(form) => form,
                _ => return None,
            },
            Meaning::Variable(_) | Meaning::Independent | Meaning::Pi => return None,
        };
        self.solver.resolve(form).ok()?.dimension()
    }
}
