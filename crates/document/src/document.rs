//! An opened document: its text and its program.

use model::{Diagnostic, Functions, Places, Span};
use program::Program;

/// Result of opening a document.
#[derive(Clone, Debug)]
pub struct Opened {
    /// The document; `None` if its model has errors.
    pub document: Option<Document>,
    /// Diagnostics, each with the index of its file: 0 is the source, 1 the first translation and so on. Sorted by file and
    /// place.
    pub diagnostics: Vec<(usize, Diagnostic)>,
}

impl Opened {
    /// Returns the document if there are no errors.
    pub fn sound(self) -> Option<Document> {
        let refused = self.has_errors();
        self.document.filter(|_| !refused)
    }

    /// True if there is an error in any file.
    pub fn has_errors(&self) -> bool {
        self.first_error().is_some()
    }

    /// The first error in any file.
    pub fn first_error(&self) -> Option<&Diagnostic> {
        let mut found = self.diagnostics.iter().map(|(_, diagnostic)| diagnostic);
        found.find(|diagnostic| diagnostic.severity == model::Severity::Error)
    }
}

/// A simulation document and its translations.
#[derive(Clone, Debug)]
pub struct Document {
    /// Markdown text.
    pub source: String,
    /// Markdown texts of the translations.
    pub translations: Vec<String>,
    /// Places of the parts of the model in the source.
    pub places: Places,
    /// Places of the claims of the checks in the source, in the order of [`Program::checks`].
    pub claims: Vec<Span>,
    /// Functions that the document defines.
    pub functions: Functions,
    /// The program made from the document.
    pub program: Program,
}
