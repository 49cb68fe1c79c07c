//! Values of attributes and properties that browsers would silently ignore.

use super::amounts;
use super::colours::{self, is_colour};
use model::{Diagnostic, Span};

/// Reports an invalid colour or number.
pub fn misfit(name: &str, text: &str, span: Span) -> Option<Diagnostic> {
    if is_colour(name) { colours::misfit(text, span) } else { amounts::misfit(name, text, span) }
}
