//! What is known of the texts in the editor.

use super::mark::{Mark, TextChange, changes, in_utf16, marks};
use model::{Diagnostic, Fix, Severity};

/// The texts of a document as they stand in the editor, the base document first, and what was found in them.
#[derive(Clone, Debug, Default)]
pub struct Writing {
    pub(super) texts: Vec<String>,
    pub(super) findings: Vec<(usize, Diagnostic)>,
    /// How many errors the texts have that run. Texts with more do not take their place.
    pub(super) tolerated: usize,
    pub(super) runs: bool,
}

impl Writing {
    /// The texts.
    pub fn texts(&self) -> &[String] {
        &self.texts
    }

    /// What was found in them, each with the number of its text.
    pub fn findings(&self) -> &[(usize, Diagnostic)] {
        &self.findings
    }

    /// How many of the findings are errors.
    pub fn errors(&self) -> usize {
        self.findings.iter().filter(|(_, found)| found.severity == Severity::Error).count()
    }

    /// Whether these texts are what runs. Otherwise it is the last version that had no more errors than the one before it.
    pub fn runs(&self) -> bool {
        self.runs
    }

    /// Whether writing has begun.
    pub fn has_begun(&self) -> bool {
        !self.texts.is_empty()
    }

    /// A place in one text, in bytes, as browsers count it: in units of UTF-16.
    pub fn in_utf16(&self, file: usize, place: usize) -> usize {
        let text = self.texts.get(file).map_or("", String::as_str);
        in_utf16(text, [place].into_iter()).into_values().next().unwrap_or_default()
    }

    /// The changes of one text that a remedy makes.
    pub fn changes(&self, file: usize, fix: &Fix) -> Vec<TextChange> {
        changes(self.texts.get(file).map_or("", String::as_str), fix)
    }

    /// The places of the findings in one text.
    pub fn marks(&self, file: usize) -> Vec<Mark> {
        let text = self.texts.get(file).map_or("", String::as_str);
        marks(text, self.findings.iter().filter(|(number, _)| *number == file).map(|(_, found)| found))
    }
}
