//! Text that is not in a document but refers to it: what is taken of each of many runs, and over which values they go.

use crate::Document;
use crate::blocks::sweeps::{self, Limits};
use crate::expressions::Expressions;
use crate::text::grammar;
use model::{Diagnostic, Grammar, Span, has_errors, sentence};
use program::Outcomes;
use units::words;

/// Reads `y at end, maximum(y) from 2 [s] in [cm]`: numbers that are taken of each run, as in plots over a parameter. Their nodes
/// are added to the graph of the model.
///
/// # Errors
/// Diagnostics with their places in `text`.
pub fn outcomes(document: &mut Document, text: &str) -> Result<Outcomes, Vec<Diagnostic>> {
    with_expressions(document, text, |expressions| {
        sweeps::outcomes(expressions, sentence(text, 0..text.len(), &grammar::OUTCOMES).phrases())
    })
}

/// Reads `b in 0..100 [kg/s] step 2`: index of a parameter that is a number, and its range.
///
/// # Errors
/// Diagnostics with their places in `text`.
pub fn parameter_range(document: &mut Document, text: &str) -> Result<(usize, Limits), Vec<Diagnostic>> {
    with_expressions(document, text, |expressions| {
        let range = sentence(text, 0..text.len(), &Grammar { is_list: false, ..grammar::OUTCOMES });
        let Some(swept) = range.phrases().next().and_then(sweeps::find) else {
            let hint = words("write it as `b in 0..100 [kg/s] step 2`");
            let missing = Diagnostic::error("sweep", words("this is no range of values"), Span::new(0, text.len()));
            expressions.diagnostics.push(missing.with_hint(hint));
            return None;
        };
        sweeps::parameter_range(expressions, swept)
    })
}

fn with_expressions<T>(
    document: &mut Document,
    text: &str,
    read: impl FnOnce(&mut Expressions) -> Option<T>,
) -> Result<T, Vec<Diagnostic>> {
    let Document { places, functions, program, .. } = document;
    let mut expressions = Expressions::new(text, &mut program.model, places, functions);
    let found = read(&mut expressions);
    let diagnostics = std::mem::take(&mut expressions.diagnostics);
    found.filter(|_| !has_errors(&diagnostics)).ok_or(diagnostics)
}
