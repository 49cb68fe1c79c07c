//! Values of attributes and properties that browsers would pass over in silence.

use super::amounts;
use super::colours::{self, is_colour};
use model::{Diagnostic, Span};

/// Reports a colour or a number that is none.
pub fn misfit(name: &str, text: &str, span: Span) -> Option<Diagnostic> {
    if is_colour(name) { colours::misfit(text, span) } else { amounts::misfit(name, text, span) }
}
