//! Traversal of expressions without recursion.

use crate::{Expression, ExpressionKind};

/// Initial capacity of the stack, rarely exceeded.
const USUAL: usize = 16;

/// Calls `visit` with the expression and all its subexpressions, in text order.
pub(crate) fn for_each<'a>(expression: &'a Expression, mut visit: impl FnMut(&'a Expression)) {
    let mut waiting = Vec::with_capacity(USUAL);
    waiting.push(expression);
    while let Some(next) = waiting.pop() {
        visit(next);
        let before = waiting.len();
        next.for_each_operand(|operand| waiting.push(operand));
        if waiting.len() > before + 1 {
            waiting[before..].reverse();
        }
    }
}

/// Calls `visit` with each name, its derivative order and its expression. Includes `y'(0)`, and the family of a member.
pub(crate) fn for_each_name<'a>(expression: &'a Expression, mut visit: impl FnMut(&'a str, u32, &'a Expression)) {
    for_each(expression, |part| {
        if let ExpressionKind::Name { name, order }
        | ExpressionKind::InitialValue { name, order }
        | ExpressionKind::Member { name, order, .. } = &part.kind
        {
            visit(name, *order, part);
        }
    });
}
