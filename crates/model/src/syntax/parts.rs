//! Traversal of the expressions in statements.

use super::expression::Expression;
use super::statement::{Statement, StatementKind};

/// All expressions of a statement.
pub(crate) fn expressions(statement: &Statement) -> Vec<&Expression> {
    match &statement.kind {
        StatementKind::Definition { value, .. }
        | StatementKind::InitialValue { value, .. }
        | StatementKind::Discrete { value, .. } => vec![value],
        StatementKind::Equation { left, right } => vec![left, right],
        StatementKind::Function(function) => vec![&function.body],
        StatementKind::Event { condition, actions, extras } => {
            let values = extras.names.iter().chain(actions).map(|action| &action.value);
            let moments = extras.every.iter().flat_map(|every| std::iter::once(&every.0).chain(&every.1));
            std::iter::once(condition).chain(values).chain(moments).collect()
        }
        _ => Vec::new(),
    }
}

/// All expressions of a statement, mutable.
pub(crate) fn expressions_mut(statement: &mut Statement) -> Vec<&mut Expression> {
    match &mut statement.kind {
        StatementKind::Definition { value, .. }
        | StatementKind::InitialValue { value, .. }
        | StatementKind::Discrete { value, .. } => vec![value],
        StatementKind::Equation { left, right } => vec![left, right],
        StatementKind::Event { condition, actions, extras } => {
            let values = extras.names.iter_mut().chain(actions).map(|action| &mut action.value);
            std::iter::once(condition).chain(values).collect()
        }
        StatementKind::Function(function) => vec![&mut function.body],
        _ => Vec::new(),
    }
}

/// Applies `change` to an expression and all its subexpressions, without recursion.
pub(crate) fn rewrite(expression: &mut Expression, change: &mut impl FnMut(&mut Expression)) {
    let mut waiting = vec![expression];
    while let Some(next) = waiting.pop() {
        change(next);
        waiting.extend(next.operands_mut());
    }
}

/// Name of the independent variable, `t` by default.
pub(crate) fn independent(statements: &[Statement]) -> String {
    let stated = statements.iter().find_map(|statement| match &statement.kind {
        StatementKind::Independent { name, .. } => Some(name.text.clone()),
        _ => None,
    });
    stated.unwrap_or_else(|| "t".to_owned())
}
