//! Expands statements and expressions with families.

use super::index::{Bindings, whole_number};
use crate::components::component_name;
use crate::{
    Action, Diagnostic, EventExtras, Expression, ExpressionKind, Members, Name, Over, Span, Statement, StatementKind,
    limits,
};
use program::Size;
use units::words;

/// Expands families.
#[derive(Debug)]
pub(crate) struct WriteOut<'a> {
    sizes: &'a [Size],
    /// Names of the model; an index must not have one of them.
    taken: Vec<&'a str>,
    pub(super) bindings: Bindings,
    /// Number of operations written so far.
    operations: usize,
    diagnostics: Vec<Diagnostic>,
}

impl<'a> WriteOut<'a> {
    /// Expander without bound indices.
    pub fn new(sizes: &'a [Size], taken: Vec<&'a str>) -> Self {
        Self { sizes, taken, bindings: Bindings::default(), operations: 0, diagnostics: Vec::new() }
    }

    /// True if more has been written than a model may have; nothing more is written then.
    pub fn is_full(&self) -> bool {
        self.operations > limits::MEMBER_OPERATIONS
    }

    /// Returns the diagnostics. A fault that occurs in every member is reported once.
    pub fn finish(mut self) -> Vec<Diagnostic> {
        let mut told: Vec<(&'static str, Span)> = Vec::new();
        self.diagnostics.retain(|diagnostic| {
            let fault = (diagnostic.code, diagnostic.span());
            let new = !told.contains(&fault);
            told.push(fault);
            new
        });
        self.diagnostics
    }

    /// Appends a copy of a statement for each combination of its indices.
    pub fn statement(&mut self, statement: &Statement, written: &mut Vec<Statement>) {
        if let StatementKind::Size(_) = statement.kind {
            return;
        }
        self.for_each_index(&statement.over, &mut |own| {
            if written.len() <= limits::STATEMENTS
                && let Some(kind) = own.kind(&statement.kind)
            {
                let label = statement.label.clone();
                written.push(Statement { label, ..Statement::of(kind, statement.span) });
            }
        });
    }

    /// Calls `visit` with all combinations of values of the indices.
    fn for_each_index(&mut self, over: &[Over], visit: &mut dyn FnMut(&mut Self)) {
        let Some((first, rest)) = over.split_first() else {
            if !self.is_full() {
                visit(self);
            }
            return;
        };
        let index = &first.index;
        if self.bindings.value(&index.text).is_some() || self.taken.contains(&index.text.as_str()) {
            let message = words!("`{}` cannot be an index: it has a meaning already", index.text);
            self.diagnostics.push(
                Diagnostic::error("duplicate-name", message, index.span)
                    .with_hint(words("choose another letter, as in `for j in 1..N`")),
            );
            return;
        }
        let (Some(low), Some(high)) = (self.whole(&first.low), self.whole(&first.high)) else { return };
        let most = i64::from(limits::MEMBERS);
        if high - low >= most {
            let message = words!("an index takes at most {most} values");
            let span = first.low.span.to(first.high.span);
            self.diagnostics.push(Diagnostic::error("model-too-large", message, span));
            return;
        }
        for value in low..=high {
            if self.is_full() {
                return;
            }
            // Each binding counts as an operation, to limit nested ranges.
            self.operations += 1;
            self.bindings.push(&index.text, value);
            self.for_each_index(rest, visit);
            self.bindings.pop();
        }
    }

    fn whole(&mut self, expression: &Expression) -> Option<i64> {
        whole_number(expression, self.sizes, &self.bindings)
            .map_err(|diagnostic| self.diagnostics.push(*diagnostic))
            .ok()
    }

    /// The statement for the present values of the indices; `None` after an error.
    fn kind(&mut self, kind: &StatementKind) -> Option<StatementKind> {
        Some(match kind {
            StatementKind::Parameter(_)
            | StatementKind::Independent { .. }
            | StatementKind::Size(_)
            | StatementKind::Table(_)
            | StatementKind::Group(_)
            | StatementKind::Function(_) => kind.clone(),
            StatementKind::Choice(choice) => {
                let mut choice = choice.clone();
                for assignment in choice.alternatives.iter_mut().flat_map(|alternative| &mut alternative.values) {
                    assignment.value = self.expression(&assignment.value);
                }
                StatementKind::Choice(choice)
            }
            StatementKind::Definition { name, value, unit } => {
                StatementKind::Definition { name: name.clone(), value: self.expression(value), unit: unit.clone() }
            }
            StatementKind::InitialValue { name, order, value, unit } => StatementKind::InitialValue {
                name: name.clone(),
                order: *order,
                value: self.expression(value),
                unit: unit.clone(),
            },
            StatementKind::Discrete { name, value, unit, rate } => StatementKind::Discrete {
                name: name.clone(),
                value: self.expression(value),
                unit: unit.clone(),
                rate: rate.clone(),
            },
            StatementKind::Members { what, left, value, unit } => {
                let ExpressionKind::Member { name, indices, order, .. } = &left.kind else { return None };
                let name = Name { text: self.member(name, indices)?, span: left.span };
                let (value, unit) = (self.expression(value), unit.clone());
                match what {
                    Members::Definitions => StatementKind::Definition { name, value, unit },
                    Members::InitialValues => StatementKind::InitialValue { name, order: *order, value, unit },
                    Members::Discrete => StatementKind::discrete(name, value, unit),
                }
            }
            StatementKind::Equation { left, right } => {
                StatementKind::Equation { left: self.expression(left), right: self.expression(right) }
            }
            StatementKind::Event { condition, actions, extras } => {
                let condition = self.expression(condition);
                let actions = self.actions(actions);
                let names = self.actions(&extras.names);
                let every = extras.every.as_ref().map(|every| {
                    Box::new((self.expression(&every.0), every.1.as_ref().map(|from| self.expression(from))))
                });
                let extras = EventExtras { names, every, ..extras.clone() };
                StatementKind::Event { condition, actions, extras }
            }
        })
    }

    fn actions(&mut self, actions: &[Action]) -> Vec<Action> {
        let mut written = Vec::new();
        for action in actions {
            self.for_each_index(&action.over, &mut |own| written.extend(own.action(action)));
        }
        written
    }

    fn action(&mut self, action: &Action) -> Option<Action> {
        let name = if action.indices.is_empty() {
            action.name.clone()
        } else {
            let member = self.member(&action.name.text, &action.indices)?;
            let text = action.component.map_or_else(|| member.clone(), |axis| component_name(&member, axis));
            Name { text, span: action.name.span }
        };
        let value = self.expression(&action.value);
        Some(Action::of(name, action.order, value))
    }

    /// `x[3]` for `x[i+1]`.
    fn member(&mut self, family: &str, indices: &[Expression]) -> Option<String> {
        let mut numbers = Vec::with_capacity(indices.len());
        for index in indices {
            numbers.push(self.whole(index)?.to_string());
        }
        Some(format!("{family}[{}]", numbers.join(",")))
    }

    /// The expression for the present values of the indices.
    pub fn expression(&mut self, expression: &Expression) -> Expression {
        self.operations += 1;
        let span = expression.span;
        if self.is_full() {
            return Expression { kind: ExpressionKind::Error, span };
        }
        let kind = match &expression.kind {
            ExpressionKind::Name { name, order: 0 } => match self.number(name) {
                Some(value) => ExpressionKind::Number { value, unit: None },
                None => expression.kind.clone(),
            },
            ExpressionKind::Member { name, indices, order, at_start } => match self.member(name, indices) {
                Some(name) if *at_start => ExpressionKind::InitialValue { name, order: *order },
                Some(name) => ExpressionKind::Name { name, order: *order },
                None => ExpressionKind::Error,
            },
            ExpressionKind::Reduction { function, body, over } => self.reduction(function, body, over, span),
            _ => {
                let written = expression.with_operands(&mut |operand| Some(self.expression(operand)));
                return written.unwrap_or_else(|| Expression::nothing(span));
            }
        };
        Expression { kind, span }
    }

    /// Value of an index or a size.
    fn number(&self, name: &str) -> Option<f64> {
        let size = || self.sizes.iter().find(|size| size.name == name).map(|size| f64::from(size.value));
        self.bindings.value(name).map(|value| value as f64).or_else(size)
    }

    fn reduction(&mut self, function: &Name, body: &Expression, over: &[Over], span: Span) -> ExpressionKind {
        let mut arguments = Vec::new();
        let before = self.diagnostics.len();
        self.for_each_index(over, &mut |own| arguments.push(own.expression(body)));
        if !arguments.is_empty() {
            return ExpressionKind::Call { function: function.clone(), arguments };
        }
        if self.diagnostics.len() > before || self.is_full() {
            return ExpressionKind::Error;
        }
        if function.text == "sum" {
            return ExpressionKind::Number { value: 0.0, unit: None };
        }
        let message = words!("`{}` of no values: the range of the index is empty", function.text);
        self.diagnostics.push(Diagnostic::error("index-range", message, span));
        ExpressionKind::Error
    }
}
