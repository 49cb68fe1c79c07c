//! What an opened document is: its text, and the program that was understood of it.

use model::{Diagnostic, Places, Span};
use program::Program;

/// What came of opening a document.
#[derive(Clone, Debug)]
pub struct Opened {
    /// The document, unless its model has errors.
    pub document: Option<Document>,
    /// What was found, each with the number of its file: 0 is the source, 1 the first translation and so on. In the
    /// order of files and places.
    pub diagnostics: Vec<(usize, Diagnostic)>,
}

impl Opened {
    /// The document, if no finding is an error.
    pub fn sound(self) -> Option<Document> {
        let refused = self.has_errors();
        self.document.filter(|_| !refused)
    }

    /// Whether any finding, in any file, is an error.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|(_, diagnostic)| diagnostic.severity == model::Severity::Error)
    }
}

/// A simulation document and its translations.
#[derive(Clone, Debug)]
pub struct Document {
    /// The Markdown text.
    pub source: String,
    /// The Markdown texts of the translations.
    pub translations: Vec<String>,
    /// Where the parts of the model stand in the source.
    pub places: Places,
    /// Where the claims of the checks stand in the source, in the order of [`Program::checks`].
    pub claims: Vec<Span>,
    /// What runs.
    pub program: Program,
}
