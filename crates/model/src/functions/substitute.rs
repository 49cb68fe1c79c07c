//! Substitutes arguments into the body of a function.

use super::Function;
use super::budget::Budget;
use crate::components::split_component;
use crate::names::for_each;
use crate::notation::quote;
use crate::{Diagnostic, Expression, ExpressionKind, Span};
use units::words;

/// Substitution for one call.
pub(super) struct Substitution<'a> {
    pub function: &'a Function,
    pub arguments: &'a [Expression],
    /// Place of the call.
    pub call: Span,
    pub budget: &'a mut Budget,
    pub diagnostics: &'a mut Vec<Diagnostic>,
}

impl<'a> Substitution<'a> {
    /// Part of the body with the arguments substituted. `None` if it becomes too large.
    pub fn of(&mut self, part: &Expression) -> Option<Expression> {
        if !self.budget.take() {
            return None;
        }
        let kind = match &part.kind {
            ExpressionKind::Name { name, order } => match self.argument(name) {
                Some(argument) if *order == 0 => return self.of_argument(argument),
                Some(argument) => self.primed(argument, *order, part.span),
                None => match split_component(name).and_then(|(vector, axis)| Some((self.argument(vector)?, axis))) {
                    Some((argument, axis)) => self.component(argument, axis, *order, part.span)?,
                    None => part.kind.clone(),
                },
            },
            ExpressionKind::InitialValue { name, order } => match self.argument(name) {
                Some(argument) => match self.primed(argument, *order, part.span) {
                    ExpressionKind::Name { name, order } => ExpressionKind::InitialValue { name, order },
                    ExpressionKind::Member { name, indices, order, .. } => {
                        ExpressionKind::Member { name, indices, order, at_start: true }
                    }
                    other => other,
                },
                None => part.kind.clone(),
            },
            ExpressionKind::Member { name, indices, order, at_start } => {
                let indices = indices.iter().map(|index| self.of(index)).collect::<Option<_>>()?;
                // An argument may be the name of a family.
                let family = match self.argument(name).map(|argument| &argument.kind) {
                    Some(ExpressionKind::Name { name, order: 0 }) => name,
                    _ => name,
                };
                ExpressionKind::Member { name: family.clone(), indices, order: *order, at_start: *at_start }
            }
            // The body of another function has been substituted already.
            ExpressionKind::Expansion(_) => part.kind.clone(),
            _ => return part.with_operands(&mut |operand| self.of(operand)),
        };
        Some(Expression { kind, span: part.span })
    }

    /// Argument of the call for a name in the body.
    fn argument(&self, name: &str) -> Option<&'a Expression> {
        let place = self.function.parameters.iter().position(|parameter| parameter == name)?;
        self.arguments.get(place)
    }

    /// Component of an argument that is a vector, or of its derivative.
    fn component(&mut self, argument: &Expression, axis: usize, order: u32, place: Span) -> Option<ExpressionKind> {
        let of = if order == 0 {
            self.of_argument(argument)?
        } else {
            Expression { kind: self.primed(argument, order, place), span: place }
        };
        Some(ExpressionKind::Component { of: Box::new(of), axis })
    }

    /// A copy of the argument. `None` if the budget is exhausted.
    fn of_argument(&mut self, argument: &Expression) -> Option<Expression> {
        let mut affordable = true;
        for_each(argument, |_| affordable &= self.budget.take());
        affordable.then(|| argument.clone())
    }

    /// Derivative of an argument; only a name or a member has one.
    fn primed(&mut self, argument: &Expression, order: u32, place: Span) -> ExpressionKind {
        if let ExpressionKind::Name { name, order: own } = &argument.kind {
            return ExpressionKind::Name { name: name.clone(), order: own.saturating_add(order) };
        }
        if let ExpressionKind::Member { name, indices, order: own, at_start: false } = &argument.kind {
            let order = own.saturating_add(order);
            return ExpressionKind::Member { name: name.clone(), indices: indices.clone(), order, at_start: false };
        }
        let function = &self.function.name;
        let message = words!(
            "`{function}` needs a quantity here, with a derivative and a value at the start, not `{}`",
            quote(argument)
        );
        let diagnostic = Diagnostic::error("argument-without-name", message, argument.span)
            .with_label(place, words("it is used here"))
            .with_label(self.call, words!("with this call of `{function}`"))
            .with_hint(words("give the expression a name (v = ...) and write that here"));
        self.diagnostics.push(diagnostic);
        ExpressionKind::Error
    }
}
