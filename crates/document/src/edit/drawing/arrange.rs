//! Edits of whole elements: removing, copying, changing the order.

use super::distance::Measure;
use super::expect::{Shape, drawing, expect, item, shapes};
use super::shift::shift;
use crate::drawing::{Drawing, Grip, Item};
use crate::edit::{Edit, EditError, Obstacle, apply, line_end};
use crate::text::outline::Outline;
use model::Span;

/// Direction of a move among sibling elements. Later elements are drawn on top.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Above the next sibling.
    Forward,
    /// Below the sibling before.
    Backward,
}

/// Removes elements with their content, and the lines that become empty.
///
/// # Errors
///
/// [`EditError::NoDrawing`], [`EditError::UnknownElement`].
pub fn remove_elements(outline: &Outline, numbers: &[usize]) -> Result<Vec<Edit>, EditError> {
    let drawing = drawing(outline)?;
    let mut edits: Vec<Edit> = Vec::new();
    let mut removed = vec![false; drawing.items.len()];
    for number in numbers {
        let span = item(&drawing, *number)?.span;
        for (gone, other) in removed.iter_mut().zip(&drawing.items) {
            *gone |= span.start <= other.span.start && other.span.end <= span.end;
        }
    }
    for (number, item) in drawing.items.iter().enumerate() {
        let parent_goes = item.parent.is_some_and(|parent| removed.get(parent) == Some(&true));
        if removed.get(number) == Some(&true) && !parent_goes {
            edits.push(Edit { span: with_its_line(outline.source(), item.span), text: String::new() });
        }
    }
    let all = shapes(outline.source(), &drawing).into_iter().zip(removed);
    let expected: Vec<Shape> = all.filter(|(_, gone)| !gone).map(|(shape, _)| shape).collect();
    expect(outline, &drawing, &edits, &expected)?;
    Ok(edits)
}

/// Copies an element: the copy follows it in the text, shifted by `by` in the lengths of its place. Ids are not copied, and
/// an element is copied only once. Also returns the index of the copy.
///
/// # Errors
///
/// As in [`shift`].
pub fn duplicate_element(
    outline: &Outline,
    number: usize,
    by: [f64; 2],
    measure: &Measure,
) -> Result<(Edit, usize), EditError> {
    let source = outline.source();
    let drawing = drawing(outline)?;
    let item = item(&drawing, number)?;
    let inner = |span: Span| item.span.start <= span.start && span.end <= item.span.end;
    let mut edits = match shift(outline, number, Grip::Whole, by, measure) {
        Ok(edits) => edits,
        Err(EditError::NotAPoint) => Vec::new(),
        Err(refusal) => return Err(refusal),
    };
    let within = drawing.items.iter().filter(|other| inner(other.span));
    let ids = within.clone().filter_map(|other| other.attribute("id"));
    edits.extend(ids.map(|id| Edit {
        span: Span::new(source[..id.span.start].trim_end().len(), id.span.end),
        text: String::new(),
    }));
    let moved = |edit: Edit| Edit {
        span: Span::new(edit.span.start - item.span.start, edit.span.end - item.span.start),
        text: edit.text,
    };
    let edits: Vec<Edit> = edits.into_iter().map(moved).collect();
    let copy = apply(&source[item.span.range()], &edits)?;
    let indent = indent(source, item.span.start);
    let edit = Edit { span: item.span.after(), text: format!("{}{indent}{copy}", line_end(source)) };
    let count = within.count();
    // The content of the copy follows from its text; it is enough to check that nothing else changes.
    expect_beside(outline, &drawing, &edit, number + count, count)?;
    Ok((edit, number + count))
}

/// Moves an element above or below its neighbour, and returns its new index. Without a neighbour nothing changes.
///
/// # Errors
///
/// [`EditError::NoDrawing`], [`EditError::UnknownElement`].
pub fn reorder_element(outline: &Outline, number: usize, order: Order) -> Result<(Vec<Edit>, usize), EditError> {
    let source = outline.source();
    let drawing = drawing(outline)?;
    let own = item(&drawing, number)?.span;
    let siblings = drawing.siblings(number);
    let place = siblings.iter().position(|sibling| *sibling == number).unwrap_or(0);
    let other = match order {
        Order::Forward => siblings.get(place + 1),
        Order::Backward => place.checked_sub(1).and_then(|before| siblings.get(before)),
    };
    let Some(&other) = other else { return Ok((Vec::new(), number)) };
    let span = item(&drawing, other)?.span;
    let text = |span: Span| source[span.range()].to_owned();
    let edits = vec![Edit { span: own, text: text(span) }, Edit { span, text: text(own) }];
    let mut expected = shapes(source, &drawing);
    // Number of elements in a span, including the content.
    let size = |span: Span| {
        let inside = |one: &&Item| span.start <= one.span.start && one.span.end <= span.end;
        drawing.items.iter().filter(inside).count()
    };
    let moved = if number < other { number + size(span) } else { other };
    let (first, length) = if number < other { (number, size(own)) } else { (other, size(span)) };
    if let Some(both) = expected.get_mut(first..first + size(own) + size(span)) {
        both.rotate_left(length);
    }
    expect(outline, &drawing, &edits, &expected)?;
    Ok((edits, moved))
}

/// Requires that an insertion adds `count` elements at `place` and leaves all others unchanged.
pub(super) fn expect_beside(
    outline: &Outline,
    drawing: &Drawing,
    edit: &Edit,
    place: usize,
    count: usize,
) -> Result<(), EditError> {
    let text = apply(outline.source(), std::slice::from_ref(edit))?;
    let after = crate::text::outline::read(&text);
    let added = crate::drawing::read(&after).map(|after| shapes(&text, &after)).unwrap_or_default();
    let added = added.get(place..place + count).ok_or(EditError::NotOneElement(Obstacle::Other))?;
    let mut expected = shapes(outline.source(), drawing);
    expected.splice(place..place, added.iter().cloned());
    expect(outline, drawing, std::slice::from_ref(edit), &expected)
}

/// Leading blanks of the line at byte `at`.
pub(super) fn indent(source: &str, at: usize) -> &str {
    let start = source[..at].rfind('\n').map_or(0, |before| before + 1);
    let line = &source[start..];
    &line[..line.len() - line.trim_start_matches([' ', '\t']).len()]
}

/// The span, extended to its whole line if nothing else stands on it.
fn with_its_line(source: &str, span: Span) -> Span {
    let start = source[..span.start].rfind('\n').map_or(0, |before| before + 1);
    let end = source[span.end..].find('\n').map_or(source.len(), |length| span.end + length + 1);
    let is_alone = source[start..span.start].trim().is_empty() && source[span.end..end].trim().is_empty();
    if is_alone { Span::new(start, end) } else { span }
}
