//! Families: a statement for all values of its indices is expanded to one statement for each. `m*x[i]'' = -k*x[i] for i in
//! 1..N` becomes N equations of the unknowns `x[1]` to `x[N]`. All later stages (names, dimensions, lowering) see single
//! quantities only.

mod declared;
mod index;
mod sizes;
mod write_out;

pub(crate) use declared::declared;
pub(crate) use index::{Bindings, whole_number};
pub(crate) use sizes::sizes;

use crate::{Diagnostic, Expression, ExpressionKind, Statement, StatementKind, limits};
use declared::taken;
use program::Size;
use std::borrow::Cow;
use units::words;
use write_out::WriteOut;

/// Expands all families. Statements that declare sizes are removed.
pub(crate) fn without_families<'a>(
    statements: &'a [Statement],
    sizes: &[Size],
    diagnostics: &mut Vec<Diagnostic>,
) -> Cow<'a, [Statement]> {
    if sizes.is_empty() && !statements.iter().any(has_families) {
        return Cow::Borrowed(statements);
    }
    let mut write_out = WriteOut::new(sizes, taken(statements));
    let mut written = Vec::with_capacity(statements.len());
    for statement in statements {
        write_out.statement(statement, &mut written);
        if written.len() > limits::STATEMENTS || write_out.is_full() {
            let message = words("the families have too many members: the model becomes too large here");
            diagnostics.push(Diagnostic::error("model-too-large", message, statement.span));
            break;
        }
    }
    diagnostics.extend(write_out.finish());
    Cow::Owned(written)
}

/// Expands the families in an expression and substitutes the values of the bound indices.
pub(crate) fn expression_without_families<'e>(
    expression: &'e Expression,
    sizes: &[Size],
    bindings: &Bindings,
) -> (Cow<'e, Expression>, Vec<Diagnostic>) {
    if sizes.is_empty() && bindings.is_empty() && !belongs_to_families(expression) {
        return (Cow::Borrowed(expression), Vec::new());
    }
    let mut write_out = WriteOut::new(sizes, Vec::new());
    write_out.bindings = bindings.clone();
    let written = write_out.expression(expression);
    let mut diagnostics = Vec::new();
    if write_out.is_full() {
        let message = words("this expression becomes too large: its sums have too many terms");
        diagnostics.push(Diagnostic::error("too-large", message, expression.span));
    }
    diagnostics.extend(write_out.finish());
    (Cow::Owned(written), diagnostics)
}

/// Family of a member: `x` for `x[3]`.
pub(crate) fn family(name: &str) -> Option<&str> {
    name.split_once('[').map(|(family, _)| family)
}

/// True if an expression contains members or reductions of families.
fn belongs_to_families(expression: &Expression) -> bool {
    let mut found = false;
    crate::names::for_each(expression, |part| {
        found |= matches!(part.kind, ExpressionKind::Member { .. } | ExpressionKind::Reduction { .. });
    });
    found
}

/// True if a statement contains families.
fn has_families(statement: &Statement) -> bool {
    let belongs = belongs_to_families;
    !statement.over.is_empty()
        || match &statement.kind {
            StatementKind::Size(_) | StatementKind::Members { .. } => true,
            StatementKind::Parameter(_)
            | StatementKind::Independent { .. }
            | StatementKind::Function(_)
            | StatementKind::Table(_)
            | StatementKind::Group(_) => false,
            StatementKind::Definition { value, .. }
            | StatementKind::InitialValue { value, .. }
            | StatementKind::Discrete { value, .. } => belongs(value),
            StatementKind::Choice(choice) => {
                choice.alternatives.iter().flat_map(|alternative| &alternative.values).any(|one| belongs(&one.value))
            }
            StatementKind::Equation { left, right } => belongs(left) || belongs(right),
            StatementKind::Event { condition, actions, extras } => {
                let acts = |action: &crate::Action| {
                    !action.indices.is_empty() || !action.over.is_empty() || belongs(&action.value)
                };
                let moments =
                    extras.every.iter().any(|every| belongs(&every.0) || every.1.as_ref().is_some_and(belongs));
                belongs(condition) || moments || actions.iter().chain(&extras.names).any(acts)
            }
        }
}
