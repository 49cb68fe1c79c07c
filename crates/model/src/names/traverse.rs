//! Going through expressions without recursion.

use crate::{Expression, ExpressionKind};

/// More parts wait seldom.
const USUAL: usize = 16;

/// Calls `visit` with the expression and everything inside it, in the order of the text.
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

/// The names inside, with their primes; `y'(0)` too, and of the members of families the family's.
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
