//! Documents with other sizes of families.

use crate::Refusal;
use crate::opened::OpenDocument;
use document::Document;
use program::Program;

/// The open document with other sizes of families, given by name.
///
/// # Errors
/// A size is outside its range, or the model has errors with it, for example because it is too large.
pub(crate) fn resized(open: OpenDocument<'_>, sizes: &[(&str, u32)]) -> Result<Document, Refusal> {
    let texts: Vec<(&str, String)> = sizes.iter().map(|(name, value)| (*name, value.to_string())).collect();
    let texts: Vec<(&str, &str)> = texts.iter().map(|(name, value)| (*name, value.as_str())).collect();
    document::resized(open.document, &texts)
        .map_err(|why| Refusal::Size { why: why.text(open.language()).into_owned() })
}

/// A document with the sizes of families that the user has set in the running program, if it still has these families.
pub(crate) fn with_present_sizes(running: &Program, document: Document) -> Document {
    let present = running.model.sizes.iter().filter(|size| size.value != size.stated);
    let kept = present.filter(|size| document.program.model.sizes.iter().any(|other| other.name == size.name));
    let sizes: Vec<(&str, String)> = kept.map(|size| (size.name.as_str(), size.value.to_string())).collect();
    if sizes.is_empty() {
        return document;
    }
    let sizes: Vec<(&str, &str)> = sizes.iter().map(|(name, value)| (*name, value.as_str())).collect();
    document::resized(&document, &sizes).unwrap_or(document)
}
