//! Edits of the front matter.

use super::layout::{begin_line, line_end, result};
use super::{Edit, EditError};
use crate::blocks::front_matter::{FrontMatter, Value, is_key, trimmed};
use crate::text::outline::Outline;
use model::Span;

/// Sets a key of the front matter, or removes it for [`None`]. An existing value is replaced; of several, the one in
/// effect. A new key goes to the end of the front matter, which is created if missing. Quotation marks are added if the
/// value needs them. [`None`] removes all lines with the key. Keys and values are not validated.
///
/// # Errors
///
/// [`EditError::Key`], [`EditError::Value`] and [`EditError::TooLong`].
pub fn set_front_matter(outline: &Outline, key: &str, value: Option<&str>) -> Result<Vec<Edit>, EditError> {
    if !is_key(key) {
        return Err(EditError::Key(key.to_owned()));
    }
    let edits = match value {
        None => removals(outline, key),
        Some(value) if value.trim().is_empty() || value.contains(['\r', '\n']) => {
            return Err(EditError::Value(value.to_owned()));
        }
        Some(value) => vec![match counting(outline.front_matter(), key) {
            Some(old) => replacement(outline, old, value),
            None => addition(outline, key, value),
        }],
    };
    result(outline, &edits)?;
    Ok(edits)
}

/// The value of `key` in effect, or else its empty value.
fn counting<'a>(matter: &'a FrontMatter, key: &str) -> Option<&'a Value> {
    let given = || matter.entries.iter().find(|entry| entry.key == key).map(|entry| &entry.value);
    matter.get(key).or_else(given)
}

fn removals(outline: &Outline, key: &str) -> Vec<Edit> {
    let source = outline.source();
    let entries = outline.front_matter().entries.iter().filter(|entry| entry.key == key);
    let line = |at: usize| {
        let start = source[..at].rfind('\n').map_or(0, |at| at + 1);
        let end = source[at..].find('\n').map_or(source.len(), |length| at + length + 1);
        Span::new(start, end)
    };
    entries.map(|entry| Edit { span: line(entry.key_span.start), text: String::new() }).collect()
}

fn replacement(outline: &Outline, old: &Value, value: &str) -> Edit {
    let written = &outline.source()[old.span.range()];
    // Existing quotation marks are kept.
    let mark = written.chars().next().filter(|_| written != old.text);
    let text = match mark {
        Some(mark) => format!("{mark}{value}{mark}"),
        None => quoted_if_needed(value),
    };
    let blank = if outline.source()[..old.span.start].ends_with(':') && written.is_empty() { " " } else { "" };
    Edit { span: old.span, text: format!("{blank}{text}") }
}

fn addition(outline: &Outline, key: &str, value: &str) -> Edit {
    let (source, matter) = (outline.source(), outline.front_matter());
    let at = matter.closing.unwrap_or(Span::new(matter.span.end, matter.span.end)).start;
    let (begin, end) = (begin_line(source, at), line_end(source));
    let entry = format!("{begin}{key}: {}{end}", quoted_if_needed(value));
    let is_absent = matter.span.start == matter.span.end;
    let text = if is_absent { format!("---{end}{entry}---{end}") } else { entry };
    Edit { span: Span::new(at, at), text }
}

/// The value, quoted if it would otherwise be read as another text.
fn quoted_if_needed(value: &str) -> String {
    if trimmed(value, 0).text == value { value.to_owned() } else { format!("\"{value}\"") }
}
