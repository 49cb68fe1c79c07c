//! Names that statements declare.

use crate::{Expression, ExpressionKind, Statement, StatementKind};

/// All declared names; an index must not have one of them.
pub(super) fn taken(statements: &[Statement]) -> Vec<&str> {
    statements.iter().filter_map(declared).collect()
}

/// The name that a statement declares.
pub(crate) fn declared(statement: &Statement) -> Option<&str> {
    match &statement.kind {
        StatementKind::Parameter(parameter) => Some(&parameter.name.text),
        StatementKind::Size(size) => Some(&size.name.text),
        StatementKind::Table(table) => Some(&table.name.text),
        StatementKind::Choice(choice) => Some(&choice.name.text),
        StatementKind::Function(function) => Some(&function.name.text),
        StatementKind::Definition { name, .. }
        | StatementKind::Discrete { name, .. }
        | StatementKind::InitialValue { name, .. }
        | StatementKind::Independent { name, .. } => Some(&name.text),
        StatementKind::Members { left: Expression { kind: ExpressionKind::Member { name, .. }, .. }, .. } => Some(name),
        StatementKind::Members { .. }
        | StatementKind::Equation { .. }
        | StatementKind::Event { .. }
        | StatementKind::Group(_) => None,
    }
}
