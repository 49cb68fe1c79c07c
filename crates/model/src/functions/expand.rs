//! Expands the function calls in an expression.

use super::budget::Budget;
use super::substitute::Substitution;
use super::{Function, Functions};
use crate::notation::quote;
use crate::{Diagnostic, Expansion, Expression, ExpressionKind, Span, limits};
use std::borrow::Cow;
use units::words;

impl Functions {
    /// The expression with all calls of these functions expanded. A call that cannot be expanded becomes
    /// [`ExpressionKind::Error`], with a diagnostic.
    pub(crate) fn expanded<'e>(
        &self,
        expression: &'e Expression,
        budget: &mut Budget,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Cow<'e, Expression> {
        if self.by_name.is_empty() {
            return Cow::Borrowed(expression);
        }
        let mut expanded = expression.clone();
        let mut writing = Writing { functions: self, budget, diagnostics };
        writing.expand(&mut expanded, 1);
        Cow::Owned(expanded)
    }
}

impl Functions {
    /// The user-defined function that an expression calls.
    fn called(&self, expression: &Expression) -> Option<&Function> {
        match &expression.kind {
            ExpressionKind::Call { function, .. } => self.by_name.get(&function.text),
            // The parser reads `f(0)` as an initial value.
            ExpressionKind::InitialValue { name, order: 0 } => self.by_name.get(name),
            _ => None,
        }
    }
}

/// Expands calls.
struct Writing<'a> {
    functions: &'a Functions,
    budget: &'a mut Budget,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl<'a> Writing<'a> {
    /// Expands the calls in an expression at nesting depth `depth`.
    fn expand(&mut self, expression: &mut Expression, depth: usize) {
        if depth > limits::NESTING {
            self.refuse(expression);
            return;
        }
        let own = self.functions.called(expression);
        let written = own.map(|own| (own, quote(expression), expression.span));
        let kind = match &mut expression.kind {
            ExpressionKind::Call { arguments, .. } => {
                arguments.iter_mut().for_each(|argument| self.expand(argument, depth + 1));
                let Some((own, text, span)) = written else { return };
                let arguments = std::mem::take(arguments);
                self.call(own, &arguments, (text, span), depth)
            }
            ExpressionKind::InitialValue { .. } => {
                let Some((own, text, span)) = written else { return };
                let kind = ExpressionKind::Number { value: 0.0, unit: None };
                self.call(own, &[Expression { kind, span }], (text, span), depth)
            }
            ExpressionKind::Unary(_, operand) => return self.expand(operand, depth + 1),
            ExpressionKind::Binary(..) => return self.chain(expression, depth),
            ExpressionKind::Member { .. }
            | ExpressionKind::Reduction { .. }
            | ExpressionKind::Tuple { .. }
            | ExpressionKind::Component { .. } => {
                return expression.operands_mut().into_iter().for_each(|part| self.expand(part, depth + 1));
            }
            ExpressionKind::If(condition, chosen, other) => {
                return [condition, chosen, other].into_iter().for_each(|part| self.expand(part, depth + 1));
            }
            ExpressionKind::Number { .. }
            | ExpressionKind::Text(_)
            | ExpressionKind::Name { .. }
            | ExpressionKind::Expansion(_)
            | ExpressionKind::Error => return,
        };
        expression.kind = kind;
        if is_too_deep(expression) {
            self.refuse(expression);
        }
    }

    /// `a + b + c`: operator chains are nested to the left, one level per operator. A loop avoids deep recursion.
    fn chain(&mut self, expression: &mut Expression, depth: usize) {
        let mut first = expression;
        while matches!(first.kind, ExpressionKind::Binary(..)) {
            let ExpressionKind::Binary(_, left, right) = &mut first.kind else { return };
            self.expand(right, depth + 1);
            first = left;
        }
        self.expand(first, depth + 1);
    }

    /// Replacement of a call of `function`.
    fn call(
        &mut self,
        function: &Function,
        arguments: &[Expression],
        (written, call): (String, Span),
        depth: usize,
    ) -> ExpressionKind {
        if arguments.len() != function.parameters.len() {
            self.diagnostics.push(wrong_count(function, arguments.len(), call));
            return ExpressionKind::Error;
        }
        let (budget, diagnostics) = (&mut *self.budget, &mut *self.diagnostics);
        let body = Substitution { function, arguments, call, budget, diagnostics }.of(&function.body);
        let Some(mut body) = body.filter(|body| !is_too_deep(body)) else {
            self.diagnostics.push(too_large(call));
            return ExpressionKind::Error;
        };
        // Calls in the body are expanded after substitution, so that names of the model in another function's body are not
        // taken for arguments.
        self.expand(&mut body, depth + 1);
        let (function, unit) = (function.name.clone(), function.unit.clone());
        ExpressionKind::Expansion(Box::new(Expansion { function, written, body, unit }))
    }

    fn refuse(&mut self, expression: &mut Expression) {
        self.diagnostics.push(too_large(expression.span));
        expression.kind = ExpressionKind::Error;
    }
}

/// True if an expression is nested more deeply than the parser allows.
pub(crate) fn is_too_deep(expression: &Expression) -> bool {
    let mut waiting = vec![(expression, 1, 1)];
    while let Some((next, depth, height)) = waiting.pop() {
        if depth > limits::NESTING || height > limits::HEIGHT {
            return true;
        }
        // Left operands of a chain, as in a sum of many terms, do not count as nesting.
        let chained = matches!(next.kind, ExpressionKind::Binary(..));
        let mut below = if chained { depth } else { depth + 1 };
        next.for_each_operand(|part| {
            waiting.push((part, below, height + 1));
            below = depth + 1;
        });
    }
    false
}

fn too_large(span: Span) -> Diagnostic {
    let message = words("with the functions that it calls written out, this expression is too large");
    Diagnostic::error("model-too-large", message, span)
        .with_hint(words("define parts of it as quantities of their own"))
}

fn wrong_count(function: &Function, given: usize, span: Span) -> Diagnostic {
    let takes = match function.parameters.len() {
        1 => words("1 argument"),
        count => words!("{count} arguments"),
    };
    let name = &function.name;
    let message = match given {
        1 => words!("`{name}` takes {takes}, and 1 was given"),
        given => words!("`{name}` takes {takes}, and {given} were given"),
    };
    Diagnostic::error("wrong-argument-count", message, span).with_label(function.span, words("it is declared here"))
}
