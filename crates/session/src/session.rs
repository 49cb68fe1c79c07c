//! The session itself: a document, a run of it, and what the person has chosen.

use document::Document;
use model::Model;

/// Counts changes, so that the shell draws only what has changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Revision {
    /// The time or the state shown: scene, readouts, plots.
    pub frame: u64,
    /// Parameters, method, step.
    pub parameters: u64,
    /// Transport: status, speed, problem.
    pub transport: u64,
    /// Rows were recorded or dropped: plots, table, the time line's length.
    pub rows: u64,
    /// Kept runs and ghost.
    pub runs: u64,
    /// Plots shown, zoom.
    pub plots: u64,
    /// The language.
    pub language: u64,
}

/// A laboratory with one document open.
#[derive(Debug)]
pub struct Session {
    document: Document,
    language: String,
    revision: Revision,
}

impl Session {
    /// Opens a document: the first row is drawn and the run stands still at 0.
    pub fn open(document: Document) -> Self {
        let language = document.language.clone();
        Self {
            document,
            language,
            revision: Revision::default(),
        }
    }

    /// The document.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// Its model.
    pub fn model(&self) -> &Model {
        &self.document.model
    }

    /// The language in which everything is said, `en` or `es`.
    pub fn language(&self) -> &str {
        &self.language
    }

    /// Chooses the language; any tag, what has no translation stays in the document's own.
    pub fn set_language(&mut self, language: &str) {
        language.clone_into(&mut self.language);
        self.revision.language += 1;
    }

    /// A text of the document in the session's language.
    pub fn text<'a>(&'a self, original: &'a str) -> &'a str {
        self.document.text(&self.language, original)
    }

    /// What has changed since when.
    pub fn revision(&self) -> Revision {
        self.revision
    }
}
