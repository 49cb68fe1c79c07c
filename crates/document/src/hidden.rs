//! Parameters that readers do not see, in the parts of a document that readers use.

use crate::expressions::Expressions;
use model::{Diagnostic, Span};
use units::words;

impl Expressions<'_> {
    /// True if readers see the parameter. Reports another one, which they would set here.
    pub fn is_shown(&mut self, parameter: usize, place: Span) -> bool {
        let own = &self.model().parameters[parameter];
        if own.is_shown() {
            return true;
        }
        let message = words!("`{0}` is hidden from readers", own.name);
        let hint = words("leave it out here, or take the word `hidden` away where it is declared");
        let declared = self.places.parameters.get(parameter).copied().unwrap_or_default();
        let diagnostic = Diagnostic::error("hidden-parameter", message, place)
            .with_label(declared, words("it is declared here"))
            .with_hint(hint);
        self.diagnostics.push(diagnostic);
        false
    }
}
