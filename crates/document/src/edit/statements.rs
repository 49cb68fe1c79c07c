//! Edits of whole statements of the model.

use super::blocks::{insert_block, remove_block};
use super::cell::expect;
use super::layout::{line_end, with_line_ends_of};
use super::lines::lines_around;
use super::{Edit, EditError};
use crate::BlockKind;
use crate::form::{CellKind, Part, Section, structure};
use crate::text::outline::Outline;
use model::Span;

/// Adds statements in a section of the form: on lines of their own after the last statement of the section, or else at the
/// end of the last model. A document without a model gets one.
///
/// # Errors
///
/// [`EditError::NotOneStatement`] if the text leaves a brace or parenthesis open, [`EditError::ChangesOthers`], and
/// [`EditError::TooLong`].
pub fn add_statement(outline: &Outline, section: Section, text: &str) -> Result<Edit, EditError> {
    let source = outline.source();
    let text = with_line_ends_of(source, text.trim());
    let Some((number, model)) =
        outline.blocks().iter().enumerate().rev().find(|(_, block)| block.kind == BlockKind::Model)
    else {
        let first_prose = outline.blocks().iter().position(|block| block.kind == BlockKind::Prose);
        return insert_block(outline, first_prose, BlockKind::Model, &text);
    };
    let parts = structure(outline);
    let in_model = |part: &&Part| outline.blocks().get(part.block).is_some_and(|one| one.kind == BlockKind::Model);
    let last = parts.iter().rev().find(|part| part.section == section && in_model(part));
    let last = last.or_else(|| parts.iter().rev().find(|part| part.block == number));
    let (block, edit) = match last {
        Some(part) => {
            let at = lines_around(source, part.span).end;
            (part.block, Edit { span: Span::new(at, at), text: format!("{}{text}", line_end(source)) })
        }
        None => {
            let at = model.content.start;
            (number, Edit { span: Span::new(at, at), text: format!("{text}{}", line_end(source)) })
        }
    };
    let added = model::parse(&text, std::slice::from_ref(&(0..text.len()))).0;
    let whole = |part: &Part| vec![(CellKind::Text, source[part.span.range()].to_owned())];
    let mut expected: Vec<Vec<(CellKind, String)>> = parts.iter().map(whole).collect();
    let place = parts.iter().take_while(|part| part.span.end <= edit.span.start).count();
    let added = added.iter().map(|statement| vec![(CellKind::Text, text[statement.span.range()].to_owned())]);
    expected.splice(place..place, added);
    expect(outline, std::slice::from_ref(&edit), &[block], &expected, EditError::NotOneStatement)?;
    Ok(edit)
}

/// Removes the statement with this index in the [form](crate::form::Form), including the comment on its line. A table in a
/// block of its own is removed with its fence.
///
/// # Errors
///
/// [`EditError::UnknownCell`] if there is no such statement, [`EditError::ChangesOthers`].
pub fn remove_statement(outline: &Outline, number: usize) -> Result<Edit, EditError> {
    let source = outline.source();
    let parts = structure(outline);
    let part = parts.get(number).ok_or(EditError::UnknownCell)?;
    if outline.blocks().get(part.block).is_some_and(|block| block.kind == BlockKind::Table) {
        return remove_block(outline, part.block);
    }
    let Span { start, end } = lines_around(source, part.span);
    let next = source[end..].find('\n').map_or(source.len(), |length| end + length + 1);
    let shares_line = |other: &Part| other.span != part.span && other.span.start < next && start < other.span.end;
    let span = if parts.iter().any(shares_line) { part.span } else { Span::new(start, next) };
    let edit = Edit { span, text: String::new() };
    let whole = |part: &Part| vec![(CellKind::Text, source[part.span.range()].to_owned())];
    let mut expected: Vec<Vec<(CellKind, String)>> = parts.iter().map(whole).collect();
    expected.remove(number);
    expect(outline, std::slice::from_ref(&edit), &[part.block], &expected, EditError::ChangesOthers)?;
    Ok(edit)
}
