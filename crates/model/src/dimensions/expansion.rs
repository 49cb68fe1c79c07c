//! Types of calls of user-defined functions; each call is checked separately.

use super::infer::Inference;
use super::types::Type;
use crate::{Expansion, Span};
use std::collections::HashSet;
use units::words;

impl Inference<'_> {
    /// Type of a call of a user-defined function. Errors in its body also show the place of the call.
    pub(super) fn expansion(&mut self, expansion: &Expansion, call: Span) -> Type {
        let before = self.diagnostics.len();
        let found = self.expression(&expansion.body);
        if let Some(stated) = &expansion.unit {
            self.check_stated(&expansion.body, &found, stated);
        }
        let mut places = HashSet::new();
        for mut diagnostic in self.diagnostics.split_off(before) {
            if !call.contains(diagnostic.span()) {
                let place = words!("with this call of `{}`", expansion.function);
                diagnostic = diagnostic.with_label(call, place);
            }
            // A wrong argument that is used twice in the body is reported once.
            if places.insert(diagnostic.labels.iter().map(|label| label.span).collect::<Vec<_>>()) {
                self.diagnostics.push(diagnostic);
            }
        }
        found
    }
}
