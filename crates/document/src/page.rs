//! Documents inside a page: an exported page carries its source.

/// A file of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Its file name, such as `utube.es.md`.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// What of the page is adapted to its documents.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The content of `<title>`.
    pub title: Option<String>,
    /// The `lang` of `<html>`.
    pub language: Option<String>,
}

/// The place in a page where the documents go.
pub const MARKER: &str = "<!--documents-->";

/// Puts `documents` into `template` in the place of [`MARKER`]. None where the template has no such place.
pub fn embed(template: &str, documents: &[Source], options: &Options) -> Option<String> {
    let _ = (template, documents, options);
    None
}

/// The documents in a page that [`embed`] made. None where it holds none.
pub fn read(page: &str) -> Option<Vec<Source>> {
    let _ = page;
    None
}
