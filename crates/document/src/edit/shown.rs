//! Edits of the order, labels and visibility of controls and values.

use super::cell::expect;
use super::layout::{line_end, with_line_ends_of};
use super::lines::{exchanged, lines_around};
use super::obstacle::Obstacle;
use super::{Edit, EditError};
use crate::form::{CellKind, Part, Place, shown, structure};
use crate::text::outline::Outline;
use model::Span;

/// Exchanges two statements of the [form](crate::form::Form), including the comments on their lines. This changes the order
/// of controls or values.
///
/// # Errors
///
/// [`EditError::UnknownCell`] if there is no such statement, [`EditError::ChangesOthers`] also if statements share a line,
/// and [`EditError::TooLong`].
pub fn exchange_statements(outline: &Outline, one: usize, other: usize) -> Result<Vec<Edit>, EditError> {
    let source = outline.source();
    let parts = structure(outline);
    let (Some(first), Some(second)) = (parts.get(one), parts.get(other)) else { return Err(EditError::UnknownCell) };
    let edits = exchanged(source, first.span, second.span);
    let mut expected: Vec<Vec<(CellKind, String)>> = parts.iter().map(|part| whole(source, part)).collect();
    expected.swap(one, other);
    expect(outline, &edits, &[first.block, second.block], &expected, EditError::ChangesOthers)?;
    Ok(edits)
}

/// Hides the value of the statement with this index from the readouts, or shows it.
///
/// # Errors
///
/// [`EditError::UnknownCell`] if the statement gives no value, [`EditError::ChangesOthers`] and [`EditError::TooLong`].
pub fn set_hidden(outline: &Outline, number: usize, hidden: bool) -> Result<Vec<Edit>, EditError> {
    let source = outline.source();
    let values = shown(outline);
    let value =
        values.iter().find(|one| one.number == number && one.place >= Place::Unknown).ok_or(EditError::UnknownCell)?;
    let parts = structure(outline);
    let part = parts.get(number).ok_or(EditError::UnknownCell)?;
    if value.is_hidden == hidden {
        return Ok(Vec::new());
    }
    let written = &source[part.span.range()];
    let at = part.span.start;
    let edit = match written.strip_prefix(WORD) {
        Some(rest) if !hidden => {
            let end = part.span.end - rest.trim_start().len();
            Edit { span: Span::new(at, end), text: String::new() }
        }
        _ => Edit { span: Span::new(at, at), text: format!("{WORD} ") },
    };
    changed(outline, &parts, number, edit)
}

const WORD: &str = "hidden";

/// Sets or removes the label of the statement with this index in the form; for a group, its name.
///
/// # Errors
///
/// [`EditError::UnknownCell`] if the statement is neither a control nor a value, [`EditError::NotOneCell`] if the text
/// cannot be a label or a group would lose its name, and [`EditError::TooLong`].
pub fn set_label(outline: &Outline, number: usize, text: &str) -> Result<Vec<Edit>, EditError> {
    let all = shown(outline);
    let one = all.iter().find(|one| one.number == number).ok_or(EditError::UnknownCell)?;
    let text = text.trim();
    if one.label == text {
        return Ok(Vec::new());
    }
    if text.contains(['"', '\n', '\r']) || one.is_group && text.is_empty() {
        return Err(EditError::NotOneCell(Obstacle::of(text, &["\n", "\""])));
    }
    let has_none = one.label_at.start == one.label_at.end;
    let edit = match (has_none, text.is_empty()) {
        (true, _) => Edit { span: one.label_at, text: format!(" \"{text}\"") },
        (false, false) => Edit { span: one.label_at, text: format!("\"{text}\"") },
        (false, true) => {
            let before = outline.source()[..one.label_at.start].trim_end_matches(' ').len();
            Edit { span: Span::new(before, one.label_at.end), text: String::new() }
        }
    };
    changed(outline, &structure(outline), number, edit)
}

/// Begins a group of controls with this name: the first group before all controls, further ones before the last control.
///
/// # Errors
///
/// [`EditError::UnknownCell`] if there is no control, [`EditError::NotOneCell`] if the text cannot be a name,
/// [`EditError::ChangesOthers`] if the control shares its line with another statement, and [`EditError::TooLong`].
pub fn add_group(outline: &Outline, name: &str) -> Result<Vec<Edit>, EditError> {
    let source = outline.source();
    let name = name.trim();
    if name.is_empty() || name.contains(['"', '\n', '\r']) {
        return Err(EditError::NotOneCell(Obstacle::of(name, &["\n", "\""])));
    }
    let all = shown(outline);
    let mut controls = all.iter().filter(|one| one.place == Place::Parameter && !one.is_group);
    let control = if all.iter().any(|one| one.is_group) { controls.next_back() } else { controls.next() };
    let number = control.ok_or(EditError::UnknownCell)?.number;
    let parts = structure(outline);
    let part = parts.get(number).ok_or(EditError::UnknownCell)?;
    let at = lines_around(source, part.span).start;
    let written = format!("group \"{name}\"");
    let edits = vec![Edit { span: Span::new(at, at), text: format!("{written}{}", line_end(source)) }];
    let mut expected: Vec<Vec<(CellKind, String)>> = parts.iter().map(|part| whole(source, part)).collect();
    expected.insert(number, vec![(CellKind::Text, written)]);
    expect(outline, &edits, &[part.block], &expected, EditError::ChangesOthers)?;
    Ok(edits)
}

/// Checks that an edit changes only the statement `number`, which remains one statement.
fn changed(outline: &Outline, parts: &[Part], number: usize, edit: Edit) -> Result<Vec<Edit>, EditError> {
    let source = outline.source();
    let part = parts.get(number).ok_or(EditError::UnknownCell)?;
    let mut expected: Vec<Vec<(CellKind, String)>> = parts.iter().map(|part| whole(source, part)).collect();
    let (before, after) =
        (&source[part.span.start..edit.span.start], &source[edit.span.end..part.span.end.max(edit.span.end)]);
    let text = with_line_ends_of(source, &format!("{before}{}{after}", edit.text));
    if let Some(cells) = expected.get_mut(number) {
        *cells = vec![(CellKind::Text, text)];
    }
    let edits = vec![edit];
    expect(outline, &edits, &[part.block], &expected, EditError::NotOneCell(Obstacle::Other))?;
    Ok(edits)
}

fn whole(source: &str, part: &Part) -> Vec<(CellKind, String)> {
    vec![(CellKind::Text, source[part.span.range()].to_owned())]
}
