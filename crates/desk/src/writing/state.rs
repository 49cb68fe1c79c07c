//! State of the texts in the editor.

use super::mark::{Mark, TextChange, in_utf16, marks, text_changes};
use document::{Document, Opened};
use model::{Diagnostic, Fix, Severity};

/// The texts of a document in the editor, the base document first, and their findings.
#[derive(Clone, Debug, Default)]
pub struct Writing {
    texts: Vec<String>,
    findings: Vec<(usize, Diagnostic)>,
    /// Number of errors in the running texts. Texts with more errors do not replace them.
    tolerated: usize,
    runs: bool,
}

impl Writing {
    /// State of texts that run.
    pub fn of_running(texts: Vec<String>) -> Self {
        let opened = open(&texts);
        Self { tolerated: errors(&opened.diagnostics), findings: opened.diagnostics, texts, runs: true }
    }

    /// State of texts that cannot run because of these errors. The first edit that gives a document runs, regardless of
    /// its other errors.
    pub fn of_faulty(texts: Vec<String>, findings: Vec<(usize, Diagnostic)>) -> Self {
        Self { tolerated: usize::MAX, findings, texts, runs: false }
    }

    /// Replaces the text of one file and checks all texts. Returns the new document, `None` if the texts have more
    /// errors than the running ones or the text has not changed.
    pub fn change(&mut self, file: usize, text: String) -> Option<Document> {
        let before = self.texts.get_mut(file).filter(|before| **before != text)?;
        *before = text;
        self.check()
    }

    /// Replaces all texts, possibly with another number of them, and checks them. Returns the document as
    /// [`Writing::change`].
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

    /// Findings, each with the index of its text.
    pub fn findings(&self) -> &[(usize, Diagnostic)] {
        &self.findings
    }

    /// Number of findings that are errors.
    pub fn errors(&self) -> usize {
        errors(&self.findings)
    }

    /// True if these texts are the running ones. Otherwise the last version without additional errors runs.
    pub fn runs(&self) -> bool {
        self.runs
    }

    /// True if editing has started.
    pub fn has_begun(&self) -> bool {
        !self.texts.is_empty()
    }

    /// Converts a byte offset in one text to UTF-16 code units.
    pub fn in_utf16(&self, file: usize, place: usize) -> usize {
        let text = self.texts.get(file).map_or("", String::as_str);
        in_utf16(text, [place].into_iter()).into_values().next().unwrap_or_default()
    }

    /// Text changes made by a remedy in one text.
    pub fn changes(&self, file: usize, fix: &Fix) -> Vec<TextChange> {
        text_changes(self.texts.get(file).map_or("", String::as_str), &fix.edits)
    }

    /// Marks of the findings in one text.
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
