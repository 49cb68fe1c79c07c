//! Going through expressions without recursion.

use crate::{Expression, ExpressionKind};

/// Calls `visit` with the expression and everything inside it, in the order of the text.
pub(crate) fn for_each<'a>(expression: &'a Expression, mut visit: impl FnMut(&'a Expression)) {
    let mut waiting = vec![expression];
    while let Some(next) = waiting.pop() {
        visit(next);
        let children = children(next);
        waiting.extend(children.into_iter().rev());
    }
}

/// The direct operands, in the order of the text.
pub(crate) fn children(expression: &Expression) -> Vec<&Expression> {
    match &expression.kind {
        ExpressionKind::Number { .. }
        | ExpressionKind::Text(_)
        | ExpressionKind::Name { .. }
        | ExpressionKind::InitialValue { .. }
        | ExpressionKind::Error => Vec::new(),
        ExpressionKind::Unary(_, operand) => vec![operand],
        ExpressionKind::Binary(_, left, right) => vec![left, right],
        ExpressionKind::Call { arguments, .. } => arguments.iter().collect(),
        ExpressionKind::Expansion(expansion) => vec![&expansion.body],
        ExpressionKind::If(condition, chosen, other) => vec![condition, chosen, other],
    }
}

/// The names inside, with their primes; `y'(0)` too.
pub(crate) fn for_each_name<'a>(expression: &'a Expression, mut visit: impl FnMut(&'a str, u32, &'a Expression)) {
    for_each(expression, |part| {
        if let ExpressionKind::Name { name, order } | ExpressionKind::InitialValue { name, order } = &part.kind {
            visit(name, *order, part);
        }
    });
}
