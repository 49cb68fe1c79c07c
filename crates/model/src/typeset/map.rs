//! Iterated maps in textbook notation: p with subscript k + 1, computed from values with subscript k.

use super::expression::Typesetter;
use crate::syntax::{expressions_mut, independent, rewrite};
use crate::{Action, BinaryOperator, EventExtras, Expression, ExpressionKind, Name, Statement, StatementKind};
use std::borrow::Cow;
use std::collections::HashSet;

/// Adds the count as a subscript to all quantities set by `next`, in the statements that set them.
pub(super) fn with_counts(statements: &[Statement]) -> Cow<'_, [Statement]> {
    let given = |statement: &Statement| match &statement.kind {
        StatementKind::Event { actions, extras: EventExtras { next: true, .. }, .. } => {
            actions.first().map(|action| action.name.text.clone())
        }
        _ => None,
    };
    let mapped: HashSet<String> = statements.iter().filter_map(given).collect();
    if mapped.is_empty() {
        return Cow::Borrowed(statements);
    }
    let count = independent(statements);
    let mut written = statements.to_vec();
    for statement in &mut written {
        if given(statement).is_none() {
            continue;
        }
        expressions_mut(statement)
            .into_iter()
            .for_each(|one| rewrite(one, &mut |part| at_count(part, &mapped, &count)));
        if let StatementKind::Event { actions, .. } = &mut statement.kind {
            for Action { name: Name { span, .. }, indices, .. } in actions {
                let (count, one) = (Expression::named(&count, *span), Expression::number(1.0, *span));
                indices.push(Expression::binary(BinaryOperator::Add, count, one, *span));
            }
        }
    }
    Cow::Owned(written)
}

/// Adds the count to the indices of a mapped quantity.
fn at_count(part: &mut Expression, mapped: &HashSet<String>, count: &str) {
    let span = part.span;
    match &mut part.kind {
        ExpressionKind::Name { name, order: 0 } if mapped.contains(name) => {
            let (name, indices) = (std::mem::take(name), vec![Expression::named(count, span)]);
            part.kind = ExpressionKind::Member { name, indices, order: 0, at_start: false };
        }
        ExpressionKind::Member { name, indices, at_start: false, .. } if mapped.contains(name) => {
            indices.push(Expression::named(count, span));
        }
        _ => {}
    }
}

impl Typesetter<'_> {
    /// An assignment of the value at the next count.
    pub(super) fn next(&self, action: &Action) -> String {
        let target = self.member(&action.name.text, &action.indices, action.order);
        format!("{target}<mo>=</mo>{}", self.expression(&action.value))
    }
}
