//! Edits of single cells of a form.

use super::columns::keeping_columns;
use super::layout::{self, with_line_ends_of};
use super::obstacle::Obstacle;
use super::rename::rename_with;
use super::{Edit, EditError};
use crate::form::{CellKind, Part, structure};
use crate::text::outline::Outline;
use model::Span;

/// Replaces the text of a cell of the statement with this index in the [form](crate::form::Form). An empty text removes a
/// unit, range, step or label. The text may contain errors, which [`crate::open()`] then reports in the cell; it is refused
/// only if it would not be parsed as this one cell. The name of a parameter or state is changed in the whole document.
///
/// # Errors
///
/// [`EditError::UnknownCell`], [`EditError::NotOneCell`], [`EditError::NotOneStatement`], [`EditError::TooLong`], and those of
/// [`rename_with`].
pub fn set_cell(outline: &Outline, number: usize, kind: CellKind, text: &str) -> Result<Vec<Edit>, EditError> {
    let parts = structure(outline);
    let cell = parts.get(number).and_then(|part| part.cell(kind)).ok_or(EditError::UnknownCell)?;
    let text = with_line_ends_of(outline.source(), text.trim());
    let text = if kind == CellKind::Unit { without_brackets(text) } else { text };
    if text == cell.text {
        return Ok(Vec::new());
    }
    if kind == CellKind::Name {
        return set_name(outline, number, &text, &[]).map(|mut edits| edits.pop().unwrap_or_default());
    }
    let edit = match (kind, cell.outer.start == cell.outer.end) {
        (CellKind::Text | CellKind::Value, _) => Edit { span: cell.span, text: text.clone() },
        (_, false) if text.is_empty() => Edit { span: cell.outer, text: String::new() },
        // Includes the closing bracket or quotation mark, so that blanks for alignment stay outside.
        (_, false) => {
            let end = &outline.source()[cell.span.end..cell.outer.end];
            Edit { span: Span::new(cell.span.start, cell.outer.end), text: format!("{text}{end}") }
        }
        (_, true) => Edit { span: cell.outer, text: dressed(&parts[number], kind, &text) },
    };
    let others = parts.iter().filter_map(|part| part.cell(kind)).map(|cell| cell.outer);
    let others = others.filter(|span| span.start < span.end).map(|span| Span::new(span.end, span.end));
    let others = others.filter(|other| other.end != cell.outer.end);
    let keeps = kind != CellKind::Text && (kind == CellKind::Value || !text.is_empty());
    let edit = if keeps { keeping_columns(outline.source(), edit, others) } else { edit };
    let refusal = match kind {
        CellKind::Text => EditError::NotOneStatement,
        _ => EditError::NotOneCell(Obstacle::of(&text, obstacles(kind))),
    };
    let mut expected: Vec<Vec<(CellKind, String)>> = parts.iter().map(texts).collect();
    match expected.get_mut(number) {
        Some(cells) if kind == CellKind::Text => *cells = vec![(kind, text)],
        Some(cells) => cells.iter_mut().filter(|(one, _)| *one == kind).for_each(|(_, old)| old.clone_from(&text)),
        None => {}
    }
    expect(outline, std::slice::from_ref(&edit), &[parts[number].block], &expected, refusal)?;
    Ok(vec![edit])
}

/// `kg` for `[kg]`.
fn without_brackets(unit: String) -> String {
    let inner = unit.strip_prefix('[').and_then(|unit| unit.strip_suffix(']'));
    match inner.filter(|inner| !inner.contains(['[', ']'])) {
        Some(inner) => inner.trim().to_owned(),
        None => unit,
    }
}

/// Characters and words that a cell of this kind must not contain.
fn obstacles(kind: CellKind) -> &'static [&'static str] {
    match kind {
        CellKind::Label => &["\n", "\"", "“", "”", "«", "»", "#"],
        CellKind::Unit => &["\n", "]", "[", "\"", "#"],
        _ => &["\n", "\"", "[", "]", "#", "=", "in", "step"],
    }
}

/// Renames a parameter or state in the document and in its translations. Returns the edits of each file.
///
/// # Errors
///
/// [`EditError::UnknownCell`], and those of [`rename_with`].
pub fn set_name(
    outline: &Outline,
    number: usize,
    text: &str,
    translations: &[&str],
) -> Result<Vec<Vec<Edit>>, EditError> {
    let parts = structure(outline);
    let cell = parts.get(number).and_then(|part| part.cell(CellKind::Name)).ok_or(EditError::UnknownCell)?;
    let text = text.trim();
    if text == cell.text {
        return Ok(Vec::new());
    }
    // In `y'(0)` the name is the part before the primes.
    let letters = cell.text.find(|letter: char| !letter.is_alphanumeric() && letter != '_').unwrap_or(cell.text.len());
    let rest = &cell.text[letters..];
    rename_with(outline, cell.span.start + letters, text.strip_suffix(rest).unwrap_or(text), translations)
}

/// Text of a new cell, with the keyword or mark that introduces it.
fn dressed(part: &Part, kind: CellKind, text: &str) -> String {
    match kind {
        // The unit of a parameter belongs to its value; that of an initial value is its display unit.
        CellKind::Unit if part.word == "parameter" => format!(" [{text}]"),
        CellKind::Unit => format!(" in [{text}]"),
        CellKind::Range => format!(" in {text}"),
        CellKind::Step => format!(" step {text}"),
        CellKind::Label => format!(" \"{text}\""),
        CellKind::Name | CellKind::Value | CellKind::Text => text.to_owned(),
    }
}

/// Cells of a part without their places. If the text of a whole statement changes the kind of part, it is compared as a
/// whole.
fn texts(part: &Part) -> Vec<(CellKind, String)> {
    part.cells.iter().map(|cell| (cell.kind, cell.text.clone())).collect()
}

/// Requires that edits change only these blocks and turn the form into `expected`; otherwise [`EditError::ChangesOthers`] or
/// `refusal`.
pub(super) fn expect(
    outline: &Outline,
    edits: &[Edit],
    blocks: &[usize],
    expected: &[Vec<(CellKind, String)>],
    refusal: EditError,
) -> Result<(), EditError> {
    let is_expected = |after: &Outline| {
        let parts = structure(after);
        let is_same = |(part, cells): (&Part, &Vec<(CellKind, String)>)| {
            let whole = |span: Span| (CellKind::Text, after.source()[span.range()].to_owned());
            texts(part) == *cells || cells.as_slice() == [whole(part.span)]
        };
        parts.len() == expected.len() && parts.iter().zip(expected).all(is_same)
    };
    layout::expect(outline, edits, |block, _| blocks.contains(&block), is_expected, refusal)
}
