//! Places where a name of the model stands.

use super::names::{declared, independent};
use super::place::{NameAt, name_at, word_at};
use crate::Outline;
use model::{ExpressionKind, Name, Span};
use std::borrow::Cow;

/// Keys of the front matter whose values are lists of names.
const LISTS: [&str; 2] = ["vary", "main"];

/// Attributes of a drawing whose values are texts, with expressions only in braces.
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

/// A name and the places where it stands in a document, in text order. Places are without primes and indices.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Uses {
    /// The name in ASCII letters, as `omega_0`.
    pub name: String,
    /// Places that declare it. The independent variable and `pi` may have none.
    pub declared: Vec<Span>,
    /// All places, also those that declare it.
    pub places: Vec<Span>,
    /// True if the name holds within a statement only.
    pub is_local: bool,
}

/// The name in ASCII letters that stands at byte `offset` in an expression or in a list of names, whether it is declared or not.
pub fn named(outline: &Outline, offset: usize) -> Option<String> {
    named_at(outline, offset).map(|span| plain(&outline.source()[span.range()]).into_owned())
}

/// The name at byte `offset` with its places; `None` if there is no name of the model. A name that holds within a statement
/// only, such as the argument of a function, has its places there.
pub fn uses(outline: &Outline, offset: usize) -> Option<Uses> {
    let span = named_at(outline, offset)?;
    let name = plain(&outline.source()[span.range()]).into_owned();
    let locals = locals(outline);
    let inner = locals.iter().filter(|(local, extent)| local.text == name && holds(*extent, span));
    match inner.min_by_key(|(_, extent)| extent.end - extent.start) {
        Some((local, extent)) => {
            let mut places = places_of(outline, &name);
            places.retain(|place| holds(*extent, *place));
            let declared = word_at(outline.source(), local.span.start);
            Some(Uses { name, declared: declared.into_iter().collect(), places, is_local: true })
        }
        None => uses_of(outline, &name),
    }
}

/// The places of a name, given in ASCII letters, outside of the statements in which it holds only; `None` if it is no name of the
/// model.
pub fn uses_of(outline: &Outline, name: &str) -> Option<Uses> {
    let declared: Vec<Span> =
        declared(outline).into_iter().filter(|one| one.name == name).map(|one| one.span).collect();
    let is_given = || name == "pi" || name == independent(outline).0;
    if declared.is_empty() && !is_given() {
        return None;
    }
    Some(Uses { name: name.to_owned(), declared, places: outer_places(outline, name), is_local: false })
}

/// The places of a name of a document in it or in one of its translations, outside of the statements in which it holds only.
pub fn outer_places(outline: &Outline, name: &str) -> Vec<Span> {
    let locals = locals(outline);
    let mut places = places_of(outline, name);
    places.retain(|place| !locals.iter().any(|(local, extent)| local.text == name && holds(*extent, *place)));
    places
}

/// The name that a text is, in ASCII letters; the text itself if it is none.
pub(crate) fn plain(text: &str) -> Cow<'_, str> {
    if text.is_ascii() {
        return Cow::Borrowed(text);
    }
    match model::parse_expression(text, 0..text.len()).0.kind {
        ExpressionKind::Name { name, order: 0 } => Cow::Owned(name),
        _ => Cow::Borrowed(text),
    }
}

fn holds(extent: Span, place: Span) -> bool {
    extent.start <= place.start && place.end <= extent.end
}

/// Names that hold within a statement only, with the part in which they hold.
fn locals<'a>(outline: &'a Outline) -> Vec<(&'a Name, Span)> {
    outline.blocks().iter().flat_map(|block| &block.statements).flat_map(|statement| statement.local_names()).collect()
}

/// All words of the document that are this name in an expression or in a list of names, also where it is a local name.
pub(crate) fn places_of(outline: &Outline, name: &str) -> Vec<Span> {
    let source = outline.source();
    let is_part = |letter: char| letter.is_alphanumeric() || letter == '_';
    let (mut places, mut at) = (Vec::new(), 0);
    while let Some(begin) = source[at..].find(is_part).map(|begin| at + begin) {
        let end = source[begin..].find(|letter| !is_part(letter)).map_or(source.len(), |length| begin + length);
        at = end;
        let span = Span::new(begin, end);
        if plain(&source[begin..end]) == name && named_at(outline, end) == Some(span) {
            places.push(span);
        }
    }
    places
}

/// Place of the word at byte `offset`, if it can be a name there.
fn named_at(outline: &Outline, offset: usize) -> Option<Span> {
    let source = outline.source();
    let listed = LISTS.iter().filter_map(|key| outline.front_matter().get(key)).any(|value| {
        let all = value.span;
        all.start <= offset && offset <= all.end
    });
    if listed {
        return word_at(source, offset);
    }
    let NameAt { span, attribute } = name_at(outline, offset)?;
    attribute.is_none_or(|attribute| !TEXTS.contains(&attribute)).then_some(span)
}
