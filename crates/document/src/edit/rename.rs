//! Other names for quantities.

use super::{Edit, EditError, layout};
use crate::assist::{NameAt, name_at, names_in};
use crate::outline::Outline;
use model::{ExpressionKind, Severity, Span};
use program::functions::Function;

/// Attributes whose values are texts and no expressions, outside braces.
const TEXTS: [&str; 12] = [
    "id",
    "class",
    "style",
    "href",
    "viewBox",
    "d",
    "transform",
    "text-anchor",
    "font-family",
    "clip-path",
    "fill",
    "stroke",
];

/// Gives the name that stands at `offset` (bytes) another one, everywhere in the document: in the model, in the drawing, in
/// plots, presets, questions and claims, and in the braces of the prose. Comments, labels and formulas stay as they are.
///
/// # Errors
///
/// [`EditError::NoName`] if no name of the model stands there, [`EditError::NewName`] if the new one cannot be a name or has a
/// meaning already, [`EditError::Incomplete`] if the document has more errors afterwards, and [`EditError::TooLong`].
pub fn rename(outline: &Outline, offset: usize, new: &str) -> Result<Vec<Edit>, EditError> {
    let source = outline.source();
    let names = names_in(outline);
    let NameAt { span, .. } = name_at(outline, offset).ok_or(EditError::NoName)?;
    let old = &source[span.range()];
    if !names.iter().any(|name| name == old) {
        return Err(EditError::NoName);
    }
    if !can_be_name(new) || names.iter().any(|name| name == new) {
        return Err(EditError::NewName(new.to_owned()));
    }
    let mut edits = Vec::new();
    for (at, _) in source.match_indices(old) {
        let found = name_at(outline, at + old.len()).filter(|found| found.span == Span::new(at, at + old.len()));
        if let Some(found) = found
            && found.attribute.is_none_or(|attribute| !TEXTS.contains(&attribute))
        {
            edits.push(Edit { span: found.span, text: new.to_owned() });
        }
    }
    let errors = |text: &str| {
        let opened = crate::open(text, &[]);
        opened.diagnostics.iter().filter(|(_, found)| found.severity == Severity::Error).count()
    };
    let text = layout::result(outline, &edits)?;
    if errors(&text) > errors(source) { Err(EditError::Incomplete(old.to_owned())) } else { Ok(edits) }
}

/// Whether a text is a name of the language that nothing else uses.
fn can_be_name(text: &str) -> bool {
    let (expression, unit, found) = model::parse_expression(text, 0..text.len());
    let is_name = matches!(&expression.kind, ExpressionKind::Name { name, order: 0 } if name == text);
    is_name && unit.is_none() && found.is_empty() && text != "pi" && Function::named(text).is_none()
}
