//! Places of findings as editors in browsers count them: in units of UTF-16.

use model::{Diagnostic, Edit, Severity};
use std::collections::BTreeMap;
use units::Words;

/// A piece of text in the place of another one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextChange {
    /// Where it begins, in units of UTF-16.
    pub from: usize,
    /// Where it ends.
    pub to: usize,
    /// What stands there afterwards.
    pub text: String,
}

/// Edits of a text in the units of an editor.
pub fn text_changes(text: &str, edits: &[Edit]) -> Vec<TextChange> {
    let places = in_utf16(text, edits.iter().flat_map(|edit| [edit.span.start, edit.span.end]));
    let place = |bytes: usize| places.get(&bytes).copied().unwrap_or_default();
    let change = |edit: &Edit| {
        let (from, to) = (place(edit.span.start), place(edit.span.end));
        TextChange { from, to: to.max(from), text: edit.text.clone() }
    };
    edits.iter().map(change).collect()
}

/// The primary place of a finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mark {
    /// Where it begins, in units of UTF-16.
    pub from: usize,
    /// Where it ends.
    pub to: usize,
    /// How grave it is.
    pub severity: Severity,
    /// What is wrong.
    pub message: Words,
    /// What to do.
    pub remedies: Vec<Words>,
}

/// The marks of a text.
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

/// Places in bytes as places in UTF-16, in one pass over the text. A place inside a character is that of its beginning.
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

/// A place in UTF-16 as one in bytes; inside a character, that of its beginning.
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
