//! Computing the values of a hand-in from its work.

use desk::Desk;
use saved::hand_in::Fact;
use saved::project::Project;
use units::{Words, words};

/// A laboratory in which the work of a hand-in is done again.
#[derive(Debug)]
pub struct Recomputation {
    desk: Desk,
    refused: usize,
}

impl Recomputation {
    /// Opens the document of a work in its state, and restores its records, films, fits and answers.
    ///
    /// # Errors
    /// If the document has errors.
    pub fn begin(work: &Project) -> Result<Self, Words> {
        let mut texts = work.documents.iter().map(|file| file.text.as_str());
        let source = texts.next().unwrap_or_default();
        let opened = document::open(source, &texts.collect::<Vec<_>>());
        let document = opened.sound().ok_or_else(|| {
            words("the document of the hand-in has errors", "el documento de la entrega tiene errores")
        })?;
        let mut desk = Desk::open(document);
        let mut refused = 0;
        if !work.state.is_empty() {
            refused += usize::from(desk.restore(&work.state).1.is_err());
        }
        refused += desk.take_project_items(&work.items);
        Ok(Self { desk, refused })
    }

    /// Opens a work and finishes its fits.
    ///
    /// # Errors
    /// If the document has errors.
    pub fn complete(work: &Project) -> Result<Self, Words> {
        let mut recomputation = Self::begin(work)?;
        while recomputation.advance() {}
        Ok(recomputation)
    }

    /// Works on the fits for one trial. Returns false if all are finished.
    pub fn advance(&mut self) -> bool {
        self.desk.advance_fit()
    }

    /// Number of parts of the work that could not be restored.
    pub fn refused(&self) -> usize {
        self.refused
    }

    /// The values that follow from the work.
    pub fn facts(mut self) -> Vec<Fact> {
        self.desk.facts()
    }

    /// The laboratory with the work, its texts in this language, and the values that follow from the work.
    pub(crate) fn finish(mut self, language: &str) -> (Desk, Vec<Fact>) {
        let facts = self.desk.facts();
        self.desk.set_language(language);
        (self.desk, facts)
    }
}
