//! Edits of attributes and texts of elements.

use super::expect::{drawing, expect, item, shapes};
use crate::drawing::{Drawing, Item, shows_text};
use crate::edit::{Edit, EditError, Obstacle};
use crate::text::outline::Outline;
use model::Span;

/// Sets an attribute of an element of the [drawing](crate::drawing::Drawing); an empty text removes it.
///
/// # Errors
///
/// [`EditError::NoDrawing`], [`EditError::UnknownElement`], [`EditError::NotOneElement`] if the text would end the attribute,
/// [`EditError::TooLong`].
pub fn set_attribute(outline: &Outline, number: usize, name: &str, text: &str) -> Result<Vec<Edit>, EditError> {
    let drawing = drawing(outline)?;
    let item = item(&drawing, number)?;
    let text = text.trim();
    let edit = match item.attribute(name) {
        Some(written) if text == &outline.source()[written.value.range()] => return Ok(Vec::new()),
        None if text.is_empty() => return Ok(Vec::new()),
        _ => attribute_edit(outline.source(), item, name, text),
    };
    expect_attributes(outline, &drawing, vec![edit], number, &[(name, text)]).map_err(|error| refused(error, text))
}

/// Sets the text that an element shows, or its title. An empty text removes the title.
///
/// # Errors
///
/// As in [`set_attribute`].
pub fn set_text(outline: &Outline, number: usize, text: &str) -> Result<Vec<Edit>, EditError> {
    let drawing = drawing(outline)?;
    let item = item(&drawing, number)?;
    let text = text.trim();
    let source = outline.source();
    if text.contains('<') {
        return Err(EditError::NotOneElement(Obstacle::Mark("<".to_owned())));
    }
    let is_shown = shows_text(item.kind);
    let edit = match item.says {
        Some(says) if text == &source[says.range()] => return Ok(Vec::new()),
        // Includes the tags of the title.
        Some(says) if text.is_empty() && !is_shown => {
            let before = source[..says.start].rfind("<title").unwrap_or(says.start);
            let behind = source[says.end..].find('>').map_or(says.end, |end| says.end + end + 1);
            Edit { span: Span::new(before, behind), text: String::new() }
        }
        Some(says) => Edit { span: says, text: text.to_owned() },
        None if text.is_empty() => return Ok(Vec::new()),
        None => {
            let inner = if is_shown { text.to_owned() } else { format!("<title>{text}</title>") };
            inside(source, item, &inner)
        }
    };
    let expected = shapes(source, &drawing);
    expect(outline, &drawing, std::slice::from_ref(&edit), &expected).map_err(|error| refused(error, text))?;
    Ok(vec![edit])
}

/// Adds the obstacle in a typed text to the error.
fn refused(error: EditError, text: &str) -> EditError {
    match error {
        EditError::NotOneElement(_) => EditError::NotOneElement(Obstacle::of(text, &["\"", "'", "<", ">", "{", "}"])),
        other => other,
    }
}

/// Edit that inserts a text directly after the opening tag.
fn inside(source: &str, item: &Item, text: &str) -> Edit {
    let tag = &source[item.opening.range()];
    match tag.strip_suffix("/>") {
        Some(open) => {
            let at = item.opening.start + open.trim_end().len();
            Edit { span: Span::new(at, item.opening.end), text: format!(">{text}</{}>", item.kind.name) }
        }
        None => Edit { span: item.opening.after(), text: text.to_owned() },
    }
}

/// Unchecked edit of one attribute.
pub(super) fn attribute_edit(source: &str, item: &Item, name: &str, text: &str) -> Edit {
    match item.attribute(name) {
        Some(written) if text.is_empty() => {
            let before = source[..written.span.start].trim_end().len();
            Edit { span: Span::new(before, written.span.end), text: String::new() }
        }
        Some(written) => Edit { span: written.value, text: text.to_owned() },
        None => {
            let tag = &source[item.opening.range()];
            let length = tag.trim_end_matches(['>', '/']).trim_end().len();
            let at = item.attributes.last().map_or(item.opening.start + length, |last| last.span.end);
            let quote = if text.contains('"') { '\'' } else { '"' };
            Edit { span: Span::new(at, at), text: format!(" {name}={quote}{text}{quote}") }
        }
    }
}

/// Returns the edits if they change only these attributes of this element.
pub(super) fn expect_attributes(
    outline: &Outline,
    drawing: &Drawing,
    edits: Vec<Edit>,
    number: usize,
    changed: &[(&str, &str)],
) -> Result<Vec<Edit>, EditError> {
    let mut expected = shapes(outline.source(), drawing);
    if let Some((_, _, attributes)) = expected.get_mut(number) {
        for &(name, text) in changed {
            match attributes.iter().position(|(known, _)| known == name) {
                Some(place) if text.is_empty() => drop(attributes.remove(place)),
                Some(place) => text.clone_into(&mut attributes[place].1),
                None => attributes.push((name.to_owned(), text.to_owned())),
            }
        }
    }
    expect(outline, drawing, &edits, &expected)?;
    Ok(edits)
}
