//! Expands the function calls in the statements of a model.

use super::Functions;
use super::budget::Budget;
use crate::{Diagnostic, Expression, Statement, StatementKind};
use std::collections::HashSet;

/// Functions of a model, and its statements with all calls expanded; `None` instead of the statements if there are no
/// functions.
pub(crate) fn written_out(
    statements: &[Statement],
    diagnostics: &mut Vec<Diagnostic>,
) -> (Functions, Option<Vec<Statement>>) {
    if !statements.iter().any(|statement| matches!(statement.kind, StatementKind::Function(_))) {
        return (Functions::default(), None);
    }
    let Some(functions) = Functions::collect(statements, diagnostics) else { return (Functions::default(), None) };
    let mut budget = Budget::default();
    let mut written = statements.to_vec();
    for expression in written.iter_mut().flat_map(|statement| expressions(&mut statement.kind)) {
        *expression = functions.expanded(expression, &mut budget, diagnostics).into_owned();
    }
    for statement in statements {
        // Check the bodies of functions that are never called.
        if let StatementKind::Function(function) = &statement.kind {
            functions.expanded(&function.body, &mut Budget::default(), diagnostics);
        }
    }
    let mut places = HashSet::new();
    diagnostics.retain(|diagnostic| places.insert((diagnostic.code, diagnostic.span())));
    (functions, Some(written))
}

/// Expressions of a statement in which functions may be called.
fn expressions(statement: &mut StatementKind) -> Vec<&mut Expression> {
    match statement {
        StatementKind::Parameter(_)
        | StatementKind::Size(_)
        | StatementKind::Table(_)
        | StatementKind::Group(_)
        | StatementKind::Independent { .. }
        | StatementKind::Function(_) => Vec::new(),
        StatementKind::Members { value, .. } => vec![value],
        StatementKind::Definition { value, .. }
        | StatementKind::InitialValue { value, .. }
        | StatementKind::Discrete { value, .. } => vec![value],
        StatementKind::Choice(choice) => {
            let values = choice.alternatives.iter_mut().flat_map(|alternative| &mut alternative.values);
            values.map(|value| &mut value.value).collect()
        }
        StatementKind::Equation { left, right } => vec![left, right],
        StatementKind::Event { condition, actions, extras } => {
            let values = extras.names.iter_mut().chain(actions).map(|action| &mut action.value);
            let moments = extras.every.iter_mut().flat_map(|every| std::iter::once(&mut every.0).chain(&mut every.1));
            std::iter::once(condition).chain(values).chain(moments).collect()
        }
    }
}
