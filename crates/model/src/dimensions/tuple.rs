//! Dimensions of vectors: all components have one.

use super::infer::Inference;
use super::terms::{Place, Term};
use super::types::Type;
use crate::{Expression, ExpressionKind};
use units::{Words, words};

const COMPONENT: Words = words("a component of a vector");

impl Inference<'_> {
    /// Type of one component of `(a, b)`. It has the dimension of the others, so a literal 0 gets one. A mismatch between
    /// components is reported with the first component, an error inside a component with that component.
    pub(super) fn component(&mut self, of: &Expression, axis: usize) -> Type {
        let ExpressionKind::Tuple { parts, .. } = &of.kind else { return Type::Unknown };
        let mut terms = Vec::with_capacity(parts.len());
        for (index, expression) in parts.iter().enumerate() {
            let before = self.diagnostics.len();
            let form = self.number(expression, &|| COMPONENT);
            if index != axis {
                self.diagnostics.truncate(before);
            }
            terms.push(Term { expression, form });
        }
        let before = self.diagnostics.len();
        let common = self.equal(&terms, Place::Components);
        if axis > 0 {
            self.diagnostics.truncate(before);
        }
        common
    }
}
