//! A document with other sizes of families. Another size gives other equations, so the model is built again.

use crate::document::Document;
use crate::edit::{EditError, apply, set_parameter};
use crate::open::open;
use model::Severity;
use units::Words;

/// The document with the values of some sizes replaced in its text, for example `("N", "50")`. The sizes of the original
/// text remain available ([`program::Size::stated`]).
///
/// # Errors
///
/// An unknown size, a value outside its range, or a model that has errors with this size, for example because it is too
/// large.
pub fn resized(document: &Document, sizes: &[(&str, &str)]) -> Result<Document, Words> {
    let mut source = document.source.clone();
    for (name, value) in sizes {
        let why = |error: EditError| error.words();
        let edit = set_parameter(&crate::read(&source), name, value).map_err(why)?;
        source = apply(&source, &[edit]).map_err(why)?;
    }
    let translations: Vec<&str> = document.translations.iter().map(String::as_str).collect();
    let opened = open(&source, &translations);
    if let Some((_, found)) = opened.diagnostics.iter().find(|(_, found)| found.severity == Severity::Error) {
        return Err(found.message.clone());
    }
    let Some(mut resized) = opened.document else { return Err(EditError::ChangesOthers.words()) };
    for (size, before) in resized.program.model.sizes.iter_mut().zip(&document.program.model.sizes) {
        size.stated = before.stated;
    }
    Ok(resized)
}
