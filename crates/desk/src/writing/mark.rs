//! Positions of findings in UTF-16 code units, as counted by editors in browsers.

use model::{Diagnostic, Edit, Severity};
use std::collections::BTreeMap;
use units::Words;

/// Replacement of a piece of text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextChange {
    /// Start, in UTF-16 code units.
    pub from: usize,
    /// End, in UTF-16 code units.
    pub to: usize,
    /// Text that replaces the piece.
    pub text: String,
}

/// Converts edits of a text to UTF-16 code units.
pub fn text_changes(text: &str, edits: &[Edit]) -> Vec<TextChange> {
    let places = in_utf16(text, edits.iter().flat_map(|edit| [edit.span.start, edit.span.end]));
    let place = |bytes: usize| places.get(&bytes).copied().unwrap_or_default();
    let change = |edit: &Edit| {
        let (from, to) = (place(edit.span.start), place(edit.span.end));
        TextChange { from, to: to.max(from), text: edit.text.clone() }
    };
    edits.iter().map(change).collect()
}

/// Position and text of a finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mark {
    /// Start, in UTF-16 code units.
    pub from: usize,
    /// End, in UTF-16 code units.
    pub to: usize,
    /// Severity of the finding.
    pub severity: Severity,
    /// Description of the fault.
    pub message: Words,
    /// Possible remedies.
    pub remedies: Vec<Words>,
}

/// Marks of the findings in a text.
pub(super) fn marks<'a>(text: &str, findings: impl Iterator<Item = &'a Diagnostic> + Clone) -> Vec<Mark> {
    let spans = findings.clone().map(Diagnostic::span);
    let places = in_utf16(text, spans.flat_map(|span| [span.start, span.end]));
    let place = |bytes: usize| places.get(&bytes).copied().unwrap_or_default();
    let mark = |found: &Diagnostic| {
        let span = found.span();
        let (from, to) = (place(span.start), place(span.end));
        let (severity, message, remedies) = (found.severity, found.message.clone(), found.hints.clone());
        Mark { from, to: to.max(from), severity, message, remedies }
    };
    findings.map(mark).collect()
}

/// Converts byte offsets to UTF-16 code units in one pass over the text. An offset inside a character counts as its
/// start.
pub(super) fn in_utf16(text: &str, places: impl Iterator<Item = usize>) -> BTreeMap<usize, usize> {
    let mut found: BTreeMap<usize, usize> = places.map(|place| (place, 0)).collect();
    let (mut bytes, mut units) = (0, 0);
    for (place, counted) in &mut found {
        while let Some(letter) = text.get(bytes..).and_then(|rest| rest.chars().next()) {
            if bytes + letter.len_utf8() > *place {
                break;
            }
            bytes += letter.len_utf8();
            units += letter.len_utf16();
        }
        *counted = units;
    }
    found
}

/// Converts a position in UTF-16 code units to a byte offset. A position inside a character counts as its start.
pub(super) fn from_utf16(text: &str, place: usize) -> usize {
    let mut units = 0;
    for (bytes, letter) in text.char_indices() {
        units += letter.len_utf16();
        if units > place {
            return bytes;
        }
    }
    text.len()
}
