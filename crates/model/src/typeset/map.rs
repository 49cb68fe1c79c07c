//! Maps as a textbook prints them: the next value of p is p with k + 1 below, from those with k below.

use super::expression::Typesetter;
use crate::syntax::{expressions_mut, independent, rewrite};
use crate::{Action, BinaryOperator, EventExtras, Expression, ExpressionKind, Name, Statement, StatementKind};
use std::borrow::Cow;
use std::collections::HashSet;

/// The statements with a further index, the count, at all that `next` gives, in those statements that give it.
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

/// Adds the count to the indices of what is mapped.
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
    /// The value at the next count, from those at the present one.
    pub(super) fn next(&self, action: &Action) -> String {
        let target = self.member(&action.name.text, &action.indices, action.order);
        format!("{target}<mo>=</mo>{}", self.expression(&action.value))
    }
}
