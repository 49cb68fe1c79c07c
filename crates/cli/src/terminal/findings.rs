//! Findings as JSON.

use super::inside;
use model::{Diagnostic, Severity, Span};
use runner::Loaded;
use serde::Serialize;
use std::borrow::Cow;
use units::{Language, Words};

/// JSON form of a finding. Fields are only ever added.
#[derive(Serialize)]
pub struct Finding<'a> {
    file: String,
    severity: &'static str,
    code: &'a str,
    message: Cow<'a, str>,
    #[serde(flatten)]
    place: Place,
    labels: Vec<Remark<'a>>,
    notes: Vec<Cow<'a, str>>,
    hints: Vec<Cow<'a, str>>,
    /// The dimension found and the one needed, in base units of the SI such as `kg m s^-2`; `1` of a pure number.
    #[serde(skip_serializing_if = "Option::is_none")]
    dimensions: Option<Dimensions>,
    /// Remedies as changes of the text.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    fixes: Vec<Remedy<'a>>,
}

#[derive(Serialize)]
struct Dimensions {
    found: String,
    needed: String,
}

/// A remedy: all its edits together, of the text as it is.
#[derive(Serialize)]
struct Remedy<'a> {
    title: String,
    edits: Vec<Replacement<'a>>,
}

/// A replacement of the text from a position to `end`; of nothing for an insertion.
#[derive(Serialize)]
struct Replacement<'a> {
    #[serde(flatten)]
    place: Place,
    text: &'a str,
}

/// A position range. Lines and columns count from 1; columns count characters.
#[derive(Serialize)]
struct Place {
    #[serde(flatten)]
    start: Position,
    end: Position,
}

#[derive(Serialize)]
struct Position {
    line: usize,
    column: usize,
}

#[derive(Serialize)]
struct Remark<'a> {
    text: Cow<'a, str>,
    #[serde(flatten)]
    place: Place,
}

/// All findings as one JSON array. Keys and codes do not depend on the language, the texts do.
pub fn findings_as_json(documents: &[Loaded], language: Language) -> String {
    let findings: Vec<Finding> = documents.iter().flat_map(|loaded| findings(loaded, language)).collect();
    // Texts and numbers can always be serialised.
    serde_json::to_string_pretty(&findings).unwrap_or_default() + "\n"
}

/// The findings about a document and its translations.
pub fn findings(loaded: &Loaded, language: Language) -> impl Iterator<Item = Finding<'_>> {
    let texts: Vec<&str> = loaded.sources.texts().map(|(_, text)| text).collect();
    loaded.opened.diagnostics.iter().map(move |(file, diagnostic)| {
        let name = loaded.sources.file_path(*file).display().to_string();
        Finding::new((name, texts.get(*file).copied().unwrap_or_default()), diagnostic, language)
    })
}

impl<'a> Finding<'a> {
    /// A finding about a file, which has a name and a text.
    pub fn new((file, text): (String, &str), diagnostic: &'a Diagnostic, language: Language) -> Self {
        let fixes = diagnostic.fixes.iter().map(|fix| Remedy {
            title: fix.title(text).text(language).into_owned(),
            edits: fix
                .edits
                .iter()
                .map(|edit| Replacement { place: place(edit.span, text), text: &edit.text })
                .collect(),
        });
        Self {
            file,
            severity: match diagnostic.severity {
                Severity::Error => "error",
                Severity::Warning => "warning",
            },
            code: diagnostic.code,
            message: diagnostic.message.text(language),
            place: place(diagnostic.span(), text),
            labels: (diagnostic.labels.iter())
                .map(|label| Remark { text: label.text.text(language), place: place(label.span, text) })
                .collect(),
            notes: in_language(&diagnostic.notes, language),
            hints: in_language(&diagnostic.hints, language),
            dimensions: diagnostic
                .dimensions
                .map(|[found, needed]| Dimensions { found: found.to_string(), needed: needed.to_string() }),
            fixes: fixes.collect(),
        }
    }
}

fn in_language(all: &[Words], language: Language) -> Vec<Cow<'_, str>> {
    all.iter().map(|words| words.text(language)).collect()
}

fn place(span: Span, text: &str) -> Place {
    let span = inside(span, text);
    Place { start: position(span.start, text), end: position(span.end, text) }
}

fn position(offset: usize, text: &str) -> Position {
    let before = &text[..offset];
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    Position { line: 1 + before.matches('\n').count(), column: 1 + before[line_start..].chars().count() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_characters_from_one() {
        let text = "a\nγ = b\n";
        let Position { line, column } = position(text.find('b').expect("it is there"), text);
        assert_eq!((line, column), (2, 5));
        let Position { line, column } = position(0, text);
        assert_eq!((line, column), (1, 1));
    }
}
