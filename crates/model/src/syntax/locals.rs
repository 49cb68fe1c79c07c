//! Names that hold within a statement only.

use super::expression::{Expression, ExpressionKind};
use super::name::Name;
use super::statement::{Statement, StatementKind};
use crate::Span;

impl Statement {
    /// Names that hold within this statement only, each with the part in which it holds: arguments of a function or of a table,
    /// indices, and names given with `let`. The index of an action holds in the whole event here.
    pub fn local_names(&self) -> Vec<(&Name, Span)> {
        let mut names: Vec<(&Name, Span)> = self.over.iter().map(|over| (&over.index, self.span)).collect();
        match &self.kind {
            StatementKind::Function(function) => names.extend(function.parameters.iter().map(|name| (name, self.span))),
            StatementKind::Table(table) => names.push((&table.argument, self.span)),
            StatementKind::Event { actions, extras, .. } => {
                names.extend(extras.names.iter().map(|action| (&action.name, self.span)));
                names.extend(actions.iter().flat_map(|action| &action.over).map(|over| (&over.index, self.span)));
            }
            _ => {}
        }
        let mut waiting = self.written();
        while let Some(expression) = waiting.pop() {
            if let ExpressionKind::Reduction { over, .. } = &expression.kind {
                names.extend(over.iter().map(|over| (&over.index, expression.span)));
            }
            expression.for_each_operand(|operand| waiting.push(operand));
        }
        names
    }

    /// All expressions of the statement as it was parsed.
    fn written(&self) -> Vec<&Expression> {
        match &self.kind {
            StatementKind::Parameter(_)
            | StatementKind::Group(_)
            | StatementKind::Size(_)
            | StatementKind::Independent { .. }
            | StatementKind::Table(_) => Vec::new(),
            StatementKind::Choice(choice) => {
                choice.alternatives.iter().flat_map(|one| &one.values).map(|value| &value.value).collect()
            }
            StatementKind::Definition { value, .. }
            | StatementKind::InitialValue { value, .. }
            | StatementKind::Discrete { value, .. } => vec![value],
            StatementKind::Members { left, value, .. } => vec![left, value],
            StatementKind::Function(function) => vec![&function.body],
            StatementKind::Equation { left, right } => vec![left, right],
            StatementKind::Event { condition, actions, extras } => {
                let actions = extras.names.iter().chain(actions);
                let parts = actions.flat_map(|action| action.indices.iter().chain([&action.value]));
                let moments = extras.every.iter().flat_map(|every| std::iter::once(&every.0).chain(&every.1));
                std::iter::once(condition).chain(parts).chain(moments).collect()
            }
        }
    }
}
