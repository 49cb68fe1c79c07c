//! Remedies for a wrong dimension: a factor to multiply or divide by, names in the model with that dimension, and a
//! parameter that probably lacks its unit.

use super::describe::{Factor, as_factor};
use super::form::Form;
use super::infer::Inference;
use super::mismatch::is_bare;
use super::types::Type;
use crate::names::{Meaning, alternatives, for_each_name};
use crate::notation::quote;
use crate::{BinaryOperator, Diagnostic, Expression, ExpressionKind, Span, UnaryOperator};
use units::{Dimension, Words, words};

/// Maximum number of names in a hint.
const MOST_OFFERS: usize = 3;

impl Inference<'_> {
    /// Adds a remedy for a part with a wrong dimension.
    pub fn with_remedy(
        &self,
        diagnostic: Diagnostic,
        expression: &Expression,
        found: &Form,
        expected: &Form,
    ) -> Diagnostic {
        let expected_unit = self.solver.resolve(expected).ok().and_then(|form| form.dimension()).map(units::Unit::si);
        let (true, Some(unit)) = (is_bare(expression), expected_unit) else {
            let diagnostic = diagnostic.with_hint(self.change(expression, found, expected));
            return match self.other_unit(expression, found, expected) {
                Some((place, unit)) => diagnostic.with_fix(place, unit),
                None => diagnostic,
            };
        };
        let quoted = quote(expression);
        diagnostic
            .with_hint(words!("give the number a unit: `{quoted} [{unit}]`"))
            .with_fix(expression.span.after(), format!(" [{unit}]"))
    }

    /// Unit that one parameter among the factors of a product would need for the product to fit, with its place. Candidates
    /// are a parameter without a unit, or the only parameter of a product with an unknown, such as `k*y`; the latter only
    /// if no name of the model could be the missing or surplus factor, which is more likely. Parameters that fit elsewhere
    /// are not considered.
    fn other_unit(&self, product: &Expression, found: &Form, expected: &Form) -> Option<(Span, String)> {
        let factor = self.factor(found, expected)?;
        let mut parameters = self.parameters_of(product);
        parameters.retain(|index| !self.is_confirmed(*index));
        let pure = parameters.iter().find(|index| self.types.parameters[**index] == Form::pure());
        let index = match (pure, parameters.as_slice()) {
            (Some(pure), _) => *pure,
            (None, [only]) if self.has_unknown(product) && !self.has_offer(factor, product) => *only,
            _ => return None,
        };
        let place = self.types.parameter_places.get(index)?;
        let unit = units::Unit::si(self.types.parameters.get(index)?.dimension()?.times(factor.lacking())?);
        Some(match place.unit {
            Some(brackets) if unit.dimension.is_none() => (brackets, String::new()),
            Some(brackets) => (brackets, format!("[{unit}]")),
            None => (place.value.after(), format!(" [{unit}]")),
        })
    }

    fn is_confirmed(&self, parameter: usize) -> bool {
        self.types.parameter_places.get(parameter).is_some_and(|place| place.is_confirmed)
    }

    /// True if the expression contains parameters and all of them fit elsewhere.
    pub fn has_confirmed_parameters(&self, expression: &Expression) -> bool {
        let mut found = Vec::new();
        for_each_name(expression, |name, _, _| {
            if let Some(Meaning::Parameter(index)) = self.scope.meaning(name) {
                found.push(self.is_confirmed(index));
            }
        });
        !found.is_empty() && !found.contains(&false)
    }

    fn has_unknown(&self, expression: &Expression) -> bool {
        let mut found = false;
        for_each_name(expression, |name, _, _| found |= matches!(self.scope.meaning(name), Some(Meaning::Variable(_))));
        found
    }

    /// True if the surplus factor is a name in the expression, or the missing factor a name of the model.
    pub fn has_offer(&self, factor: Factor, expression: &Expression) -> bool {
        match factor {
            Factor::Excess(_) => !self.offered_inside(factor, expression).is_empty(),
            Factor::Lacking(_) => !self.offered_anywhere(factor, expression).is_empty(),
        }
    }

    /// Hint by what to multiply or divide.
    fn change(&self, expression: &Expression, found: &Form, expected: &Form) -> Words {
        let Some(factor) = self.factor(found, expected) else {
            return words("state the units of the quantities involved");
        };
        let thing = as_factor(factor.dimension());
        let offers = self.offers(factor, expression);
        let unitless = self.forgotten_unit(expression, factor.lacking());
        match factor {
            Factor::Lacking(_) => words!("multiply it by {thing}{offers}{unitless}"),
            Factor::Excess(_) => words!("divide it by {thing}{offers}{unitless}"),
        }
    }

    /// `, or give `omega` the unit [1/s]`, if a factor of the expression is a parameter without a unit.
    pub fn forgotten_unit(&self, expression: &Expression, lacking: Dimension) -> Words {
        match self.factor_without_unit(expression) {
            Some(name) => {
                let unit = units::Unit::si(lacking);
                words!(", or give `{name}` the unit [{unit}]")
            }
            None => Words::default(),
        }
    }

    /// First dimensionless parameter among the factors of a product: perhaps its unit was forgotten.
    fn factor_without_unit(&self, product: &Expression) -> Option<&str> {
        let pure =
            self.parameters_of(product).into_iter().find(|index| self.types.parameters[*index] == Form::pure())?;
        self.scope
            .names()
            .find(|name| matches!(self.scope.meaning(name), Some(Meaning::Parameter(index)) if index == pure))
    }

    /// Parameters among the factors of a product, each once.
    fn parameters_of(&self, product: &Expression) -> Vec<usize> {
        let mut found = Vec::new();
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
                        && !found.contains(&index)
                    {
                        found.push(index);
                    }
                }
                _ => {}
            }
        }
        found
    }

    /// `, such as L, h_l or h_r`: names with exactly this dimension. A surplus factor is first looked for in the expression
    /// itself, a missing one in the whole model.
    pub fn offers(&self, factor: Factor, expression: &Expression) -> Words {
        let inside = match factor {
            Factor::Excess(_) => self.offered_inside(factor, expression),
            Factor::Lacking(_) => Vec::new(),
        };
        let mut names = if inside.is_empty() { self.offered_anywhere(factor, expression) } else { inside };
        names.truncate(MOST_OFFERS);
        if names.is_empty() {
            return Words::default();
        }
        let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        words!(", such as {names}", names = alternatives(&names))
    }

    /// Names in an expression with the dimension of a factor.
    fn offered_inside<'e>(&self, factor: Factor, expression: &'e Expression) -> Vec<&'e str> {
        let mut names: Vec<&str> = Vec::new();
        for_each_name(expression, |name, order, _| {
            if order == 0 && self.is_offer(name, factor, expression) && !names.contains(&name) {
                names.push(name);
            }
        });
        names
    }

    /// Names of the model with the dimension of a factor.
    fn offered_anywhere(&self, factor: Factor, expression: &Expression) -> Vec<&str> {
        self.scope.names().filter(|name| self.is_offer(name, factor, expression)).collect()
    }

    /// True if a name has the dimension of a factor and is not the whole expression.
    fn is_offer(&self, name: &str, factor: Factor, expression: &Expression) -> bool {
        let wanted = factor.dimension();
        !wanted.is_none()
            && self.dimension_of(name) == Some(wanted)
            && quote(expression).trim_start_matches('-') != name
    }

    /// Dimension of a parameter or definition; `None` for unknowns and the independent variable, which are not offered as
    /// factors.
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
