//! What is known of the texts in the editor.

use super::mark::{Mark, TextChange, in_utf16, marks, text_changes};
use document::{Document, Opened};
use model::{Diagnostic, Fix, Severity};

/// The texts of a document as they stand in the editor, the base document first, and what was found in them.
#[derive(Clone, Debug, Default)]
pub struct Writing {
    texts: Vec<String>,
    findings: Vec<(usize, Diagnostic)>,
    /// How many errors the texts have that run. Texts with more do not take their place.
    tolerated: usize,
    runs: bool,
}

impl Writing {
    /// Of texts that run.
    pub(super) fn of_running(texts: Vec<String>) -> Self {
        let opened = open(&texts);
        Self { tolerated: errors(&opened.diagnostics), findings: opened.diagnostics, texts, runs: true }
    }

    /// Of texts in which these errors leave nothing to run. The first of their versions that gives a document runs, whatever else is
    /// wrong with it.
    pub fn of_faulty(texts: Vec<String>, findings: Vec<(usize, Diagnostic)>) -> Self {
        Self { tolerated: usize::MAX, findings, texts, runs: false }
    }

    /// Takes another text for one of the files and checks all of them. The document that they give, unless they have more errors
    /// than the texts that run. The same text again gives none.
    pub fn change(&mut self, file: usize, text: String) -> Option<Document> {
        let before = self.texts.get_mut(file).filter(|before| **before != text)?;
        *before = text;
        self.check()
    }

    /// The same for all texts at once, and for one more of them than before.
    pub fn change_all(&mut self, texts: Vec<String>) -> Option<Document> {
        self.texts = texts;
        self.check()
    }

    fn check(&mut self) -> Option<Document> {
        let opened = open(&self.texts);
        let found = errors(&opened.diagnostics);
        let document = opened.document.filter(|_| found <= self.tolerated);
        self.findings = opened.diagnostics;
        self.runs = document.is_some();
        if self.runs {
            self.tolerated = found;
        }
        document
    }

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
        errors(&self.findings)
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
        text_changes(self.texts.get(file).map_or("", String::as_str), &fix.edits)
    }

    /// The places of the findings in one text.
    pub fn marks(&self, file: usize) -> Vec<Mark> {
        let text = self.texts.get(file).map_or("", String::as_str);
        marks(text, self.findings.iter().filter(|(number, _)| *number == file).map(|(_, found)| found))
    }
}

fn open(texts: &[String]) -> Opened {
    let mut texts = texts.iter().map(String::as_str);
    let source = texts.next().unwrap_or_default();
    let translations: Vec<&str> = texts.collect();
    document::open(source, &translations)
}

fn errors(findings: &[(usize, Diagnostic)]) -> usize {
    findings.iter().filter(|(_, found)| found.severity == Severity::Error).count()
}
