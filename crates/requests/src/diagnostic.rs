//! Diagnostics with all texts in English.

use model::Severity;
use runner::{Sources, in_keywords};
use serde::Serialize;
use units::{Language, Words};

/// Something that is wrong with a document, a setting or a run: where, why, and what to do.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Diagnostic {
    /// `error` or `warning`.
    severity: &'static str,
    /// Stable code, such as `unknown-name`; empty for a wrong argument.
    code: String,
    /// Sentence about the fault.
    message: String,
    /// Action that mends it; empty if none is known.
    remedy: String,
    /// Further remarks.
    notes: Vec<String>,
    /// File or argument in which it is.
    file: String,
    /// Line, from 1; `None` without a place.
    line: Option<usize>,
    /// Column in characters, from 1; `None` without a place.
    column: Option<usize>,
    /// The text at the place; empty without a place.
    text: String,
}

impl Diagnostic {
    /// A diagnostic of a text. `file`: index of the text in the sources.
    pub fn new(sources: &Sources, file: usize, found: &model::Diagnostic) -> Self {
        let text = sources.texts().nth(file).map_or("", |(_, text)| text);
        let span = found.span();
        let end = text.floor_char_boundary(span.end.min(text.len()));
        let start = text.floor_char_boundary(span.start.min(end));
        let before = &text[..start];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let labels = found.labels.iter().map(|label| &label.text).filter(|text| !text.is_empty());
        Self {
            severity: severity(found.severity),
            code: found.code.to_owned(),
            message: english(&found.message),
            remedy: found.hints.iter().map(english).collect::<Vec<_>>().join("; "),
            notes: labels.chain(&found.notes).map(english).collect(),
            file: sources.file_path(file).display().to_string(),
            line: Some(1 + before.matches('\n').count()),
            column: Some(1 + before[line_start..].chars().count()),
            text: text[start..end].to_owned(),
        }
    }

    /// A diagnostic without a place.
    pub fn without_place(severity: Severity, code: &str, message: &Words, remedy: Option<&Words>) -> Self {
        Self {
            severity: self::severity(severity),
            code: code.to_owned(),
            message: english(message),
            remedy: remedy.map(english).unwrap_or_default(),
            notes: Vec::new(),
            file: String::new(),
            line: None,
            column: None,
            text: String::new(),
        }
    }
}

fn severity(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    }
}

fn english(words: &Words) -> String {
    in_keywords(&words.text(Language::English))
}
