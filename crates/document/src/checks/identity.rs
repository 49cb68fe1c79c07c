//! Claims that are true by definition and therefore test nothing.

use crate::expressions::{Expressions, Placed};
use model::Diagnostic;
use units::words;

/// Warns of a claim that compares something with itself or with its own definition.
pub fn remark_on_identity(expressions: &mut Expressions, left: &Placed, right: &Placed) {
    // Equal expressions share one node of the graph.
    if left.value.node != right.value.node || !expressions.model().depends(left.value.node).varies() {
        return;
    }
    let message = words("this claim is true by definition: both sides are the same whatever the run does");
    expressions.diagnostics.push(
        Diagnostic::warning("true-by-definition", message, left.span.to(right.span))
            .with_hint(words("compare what the run computes with what follows from something else")),
    );
}
