//! Kind of text at the cursor.

use crate::{BlockKind, Outline};
use model::{LexemeKind, Span, lexemes};
use std::ops::Range;

/// Kind of text that can stand at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place<'a> {
    /// Text without meaning for the program: prose, comments, labels.
    Nothing,
    /// A key of the front matter.
    Key,
    /// Kind of a block, after three backquotes.
    Fence,
    /// Beginning of a statement of the model.
    Statement,
    /// Rest of a statement, or any other expression.
    Expression,
    /// A unit in brackets.
    Unit,
    /// Name of an element of the scene.
    Element,
    /// An attribute of the named element.
    Attribute(&'a str),
}

/// Kind of place at byte `offset`, and the span of the word before it.
pub fn place<'a>(outline: &Outline<'a>, offset: usize) -> (Place<'a>, Span) {
    let source = outline.source();
    let offset = source.floor_char_boundary(offset);
    let line = source[..offset].rfind('\n').map_or(0, |end| end + 1)..offset;
    let matter = outline.front_matter().span;
    // An unfinished key has no colon yet, so the parsed front matter ends before it.
    let is_begun = outline.front_matter().closing.is_none() && line.start == matter.end && matter.end > matter.start;
    if matter.start <= offset && offset < matter.end || is_begun {
        let is_key = !source[line.clone()].contains(':') && line.start > matter.start;
        let place = if is_key { Place::Key } else { Place::Nothing };
        return (place, word(source, line, letters));
    }
    let text = &source[line.clone()];
    if text.trim_start().starts_with("```") && !text.contains(' ') {
        return (Place::Fence, word(source, line, letters));
    }
    let inside = |block: &&crate::Block| block.content.start <= offset && offset <= block.content.end;
    let Some(block) = outline.blocks().iter().rev().find(inside) else {
        return (Place::Nothing, Span::new(offset, offset));
    };
    match block.kind {
        BlockKind::Prose | BlockKind::Translations => in_braces(source, line),
        BlockKind::Scene => in_scene(source, block.content.start..offset, line),
        BlockKind::Question => {
            let field = ["answer:", "set:", "hide:", "wrong:"].into_iter().find(|field| text.starts_with(field));
            match field {
                Some(field) => in_expression(source, line.start + field.len()..offset, false),
                None => in_braces(source, line),
            }
        }
        BlockKind::Survey => (Place::Nothing, Span::new(offset, offset)),
        kind => in_expression(source, line, kind == BlockKind::Model),
    }
}

/// The whole word at byte `offset`.
pub fn word_at(source: &str, offset: usize) -> Option<Span> {
    around(source, offset, |letter| letters(letter) || matches!(letter, '%' | '°' | 'µ' | 'Ω'))
}

/// A word that can be a name.
pub struct NameAt<'a> {
    /// Place in the document.
    pub span: Span,
    /// Attribute of the drawing in whose value it stands, outside braces.
    pub attribute: Option<&'a str>,
}

/// The word at byte `offset`, if it stands in an expression.
pub fn name_at<'a>(outline: &Outline<'a>, offset: usize) -> Option<NameAt<'a>> {
    let span = word_at(outline.source(), offset)?;
    let (place, _) = place(outline, span.end);
    let attribute = attribute_around(outline, span.start);
    matches!(place, Place::Statement | Place::Expression).then_some(NameAt { span, attribute })
}

/// The whole attribute at byte `offset`, such as `stroke-width`.
pub fn attribute_at(source: &str, offset: usize) -> Option<Span> {
    around(source, offset, |letter| letters(letter) || letter == '-')
}

fn around(source: &str, offset: usize, is_part: impl Fn(char) -> bool) -> Option<Span> {
    let offset = source.floor_char_boundary(offset);
    let start = offset - tail(&source[..offset], &is_part);
    let length = source[offset..].find(|letter| !is_part(letter)).unwrap_or(source.len() - offset);
    (start < offset + length).then(|| Span::new(start, offset + length))
}

/// Attribute of a drawing in whose value `offset` lies, outside braces.
fn attribute_around<'a>(outline: &Outline<'a>, offset: usize) -> Option<&'a str> {
    let mut scenes = outline.blocks_of(BlockKind::Scene);
    let scene = scenes.find(|block| block.content.start <= offset && offset <= block.content.end)?;
    let text = &outline.source()[scene.content.start..offset];
    let tag = &text[text.rfind('<').filter(|&open| !text[open..].contains('>'))?..];
    let quote = tag.rfind('"').filter(|_| tag.matches('"').count() % 2 == 1)?;
    let value = &tag[quote..];
    let is_in_braces = value.rfind('{').is_some_and(|open| !value[open..].contains('}'));
    let before = tag[..quote].trim_end().strip_suffix('=')?.trim_end();
    let name = &before[before.rfind(char::is_whitespace).map_or(0, |blank| blank + 1)..];
    (!is_in_braces).then_some(name)
}

fn letters(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

/// Number of bytes at the end of a text that are such characters.
fn tail(text: &str, is_part: impl Fn(char) -> bool) -> usize {
    text.len() - text.trim_end_matches(is_part).len()
}

/// The word at the end of `range`.
fn word(source: &str, range: Range<usize>, is_part: impl Fn(char) -> bool) -> Span {
    Span::new(range.end - tail(&source[range.clone()], is_part), range.end)
}

/// Place in a line of the model, a plot, a preset or a claim.
fn in_expression<'a>(source: &str, line: Range<usize>, is_model: bool) -> (Place<'a>, Span) {
    let lexemes = lexemes(source, line.clone());
    let last = lexemes.iter().rfind(|lexeme| lexeme.kind != LexemeKind::Blank);
    let begun = last.filter(|last| matches!(last.kind, LexemeKind::Unknown | LexemeKind::Comment));
    let begun = begun.map_or("", |last| last.text(source));
    if begun.starts_with(['"', '“', '„', '«', '#']) {
        return (Place::Nothing, Span::new(line.end, line.end));
    }
    if let Some(last) = last.filter(|_| begun.starts_with('[')) {
        // Brackets directly after a name hold an index.
        if !source[line.start..last.span.start].ends_with(letters) {
            let is_part = |letter: char| letters(letter) || matches!(letter, '%' | '°');
            return (Place::Unit, word(source, last.span.start + 1..line.end, is_part));
        }
    }
    let word = word(source, line.clone(), letters);
    // A number needs no completion.
    if source[word.range()].starts_with(|letter: char| letter.is_ascii_digit()) {
        return (Place::Nothing, word);
    }
    let before = source[line.start..word.start].trim();
    let begins = is_model && (before.is_empty() || before == "hidden" || before.ends_with(['{', ';']));
    (if begins { Place::Statement } else { Place::Expression }, word)
}

/// Place in a text with expressions in braces, outside formulas.
fn in_braces<'a>(source: &str, line: Range<usize>) -> (Place<'a>, Span) {
    let text = &source[line.clone()];
    let paragraph = source[..line.start].rfind("\n\n").map_or(0, |end| end + 2);
    match text.rfind('{').filter(|&open| !text[open..].contains('}')) {
        Some(open) if !is_in_formula(&source[paragraph..line.start + open]) => {
            in_expression(source, line.start + open + 1..line.end, false)
        }
        _ => (Place::Nothing, Span::new(line.end, line.end)),
    }
}

/// True if a formula, between `$` or `$$`, is open at the end of a text.
fn is_in_formula(text: &str) -> bool {
    text.replace("\\$", "").replace("$$", "$").matches('$').count() % 2 == 1
}

/// Place in a drawing: between tags, in a tag, or in the value of an attribute.
fn in_scene<'a>(source: &'a str, scene: Range<usize>, line: Range<usize>) -> (Place<'a>, Span) {
    let text = &source[scene.clone()];
    // In `k < 1` and `k <= 1` it is a comparison.
    let begins = |(open, _): &(usize, &str)| !text[open + 1..].starts_with([' ', '=']);
    let tag = text.rmatch_indices('<').find(begins).map(|(open, _)| open);
    let Some(open) = tag.filter(|&open| !text[open..].contains('>')) else {
        let is_drawn = tag.is_some();
        return if is_drawn { in_braces(source, line) } else { in_expression(source, line, false) };
    };
    let tag = &text[open + 1..];
    let start = scene.start + open + 1;
    let name_end = tag.find(|letter: char| !letter.is_ascii_alphanumeric()).unwrap_or(tag.len());
    if name_end == tag.len() {
        return (Place::Element, Span::new(start, scene.end));
    }
    if let Some(quote) = tag.rfind('"').filter(|_| tag.matches('"').count() % 2 == 1) {
        return in_expression(source, start + quote + 1..scene.end, false);
    }
    let is_part = |letter: char| letters(letter) || letter == '-';
    (Place::Attribute(&tag[..name_end]), word(source, start..scene.end, is_part))
}
