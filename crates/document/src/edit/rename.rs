//! Renaming of quantities.

use super::{Edit, EditError, layout};
use crate::Opened;
use crate::assist::{name_at, names_in, places_of, plain};
use crate::text::outline::{Outline, read};
use model::{ExpressionKind, Severity};
use program::Program;
use program::functions::Function;

/// Renames the quantity at byte `offset` in the whole document: in the model, the drawing, plots, presets, questions and
/// claims, and in the braces of the prose. Comments, labels and formulas are not changed. The renamed document computes
/// bit-identical results.
///
/// # Errors
///
/// [`EditError::NoName`] if there is no name of the model at the place, [`EditError::NewName`] if the new name is invalid
/// or already in use, [`EditError::Captured`] if an argument, an index or another local name would take its place,
/// [`EditError::Incomplete`] if the document would have more errors, [`EditError::ComputesOthers`] if the results would
/// change for another reason, and [`EditError::TooLong`].
pub fn rename(outline: &Outline, offset: usize, new: &str) -> Result<Vec<Edit>, EditError> {
    rename_with(outline, offset, new, &[]).map(|mut edits| edits.pop().unwrap_or_default())
}

/// Renames a quantity in the document and in the braces of its translations, in prose and in texts of the drawing. Returns
/// the edits of the document and those of each translation.
///
/// # Errors
///
/// As in [`rename`].
pub fn rename_with(
    outline: &Outline,
    offset: usize,
    new: &str,
    translations: &[&str],
) -> Result<Vec<Vec<Edit>>, EditError> {
    let source = outline.source();
    let names = names_in(outline);
    let span = name_at(outline, offset).ok_or(EditError::NoName)?.span;
    let old = &*plain(&source[span.range()]);
    if !names.iter().any(|name| name == old) {
        return Err(EditError::NoName);
    }
    if !can_be_name(new) || names.iter().any(|name| name == new) {
        return Err(EditError::NewName(new.to_owned()));
    }
    let others: Vec<Outline> = translations.iter().map(|text| read(text)).collect();
    let files = || std::iter::once(outline).chain(&others);
    let edits: Vec<Vec<Edit>> = files().map(|file| in_file(file, old, new)).collect();
    let renamed = files().zip(&edits).map(|(file, edits)| layout::result(file, edits));
    let renamed = renamed.collect::<Result<Vec<String>, _>>()?;
    let (text, texts) = renamed.split_first().ok_or(EditError::NoName)?;
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    let (before, after) = (crate::open(source, translations), crate::open(text, &texts));
    let is_incomplete = errors(&after) > errors(&before);
    let is_used = || files().any(|file| !in_file(file, new, new).is_empty());
    let is_captured = match (&before.document, &after.document) {
        // With other sizes of families, the equations may differ.
        (Some(before), Some(after)) if before.program.model.sizes.is_empty() => {
            computed(&before.program) != computed(&after.program)
        }
        _ => is_used(),
    };
    match (is_captured, is_incomplete) {
        (false, false) => Ok(edits),
        _ if is_used() => Err(EditError::Captured { old: old.to_owned(), new: new.to_owned() }),
        (_, true) => Err(EditError::Incomplete(old.to_owned())),
        (true, false) => Err(EditError::ComputesOthers(new.to_owned())),
    }
}

/// Number of errors.
fn errors(opened: &Opened) -> usize {
    opened.diagnostics.iter().filter(|(_, found)| found.severity == Severity::Error).count()
}

/// Everything that determines the results of a program: its debug format without texts, and thus without names.
fn computed(program: &Program) -> String {
    let whole = format!("{program:?}");
    let mut rest = whole.as_str();
    let mut kept = String::new();
    while let Some((before, text)) = rest.split_once('"') {
        kept.push_str(before);
        let mut is_escaped = false;
        let end = text.find(|letter| {
            let ends = letter == '"' && !is_escaped;
            is_escaped = letter == '\\' && !is_escaped;
            ends
        });
        rest = end.and_then(|end| text.get(end + 1..)).unwrap_or_default();
    }
    kept + rest
}

/// Edits that replace the old name where it means the quantity, and where a local name is the same.
fn in_file(outline: &Outline, old: &str, new: &str) -> Vec<Edit> {
    places_of(outline, old).into_iter().map(|span| Edit { span, text: new.to_owned() }).collect()
}

/// True if a text is a valid, unreserved name.
fn can_be_name(text: &str) -> bool {
    let (expression, unit, found) = model::parse_expression(text, 0..text.len());
    let is_name = matches!(&expression.kind, ExpressionKind::Name { name, order: 0 } if name == text);
    is_name && unit.is_none() && found.is_empty() && text != "pi" && Function::named(text).is_none()
}
