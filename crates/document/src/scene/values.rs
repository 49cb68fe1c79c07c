//! Texts and values of a scene.

use super::build::Builder;
use super::template::{self, RawPiece, normalised};
use crate::expressions::Placed;
use crate::translation::Texts;
use model::Diagnostic;
use program::{Child, Element, Kind, Piece, Scene, Template};
use std::ops::Range;
use units::words;

/// How many values a scene may have; all of them are computed for every frame.
const VALUES: usize = 1_000;

impl Builder<'_, '_> {
    /// A text. What it says is kept for translations.
    pub fn text(&mut self, range: Range<usize>) -> Option<Template> {
        let raw = template::split(self.expressions.source, range.clone(), &mut self.expressions.diagnostics);
        let template: Option<Template> = raw.iter().cloned().map(|piece| self.piece(piece, false)).collect();
        let template = template.filter(|template| !template.is_empty())?;
        let mut text = SceneText { key: normalised(self.source(&range)), ..SceneText::default() };
        for (raw, piece) in raw.iter().zip(&template) {
            match (raw, piece) {
                (RawPiece::Literal(literal), _) => text.needed |= has_word(literal),
                (RawPiece::Placeholder { expression, .. }, Piece::Value { index, .. }) => {
                    text.values.push((self.source(expression).trim().to_owned(), *index));
                }
                _ => {}
            }
        }
        self.words.push(text);
        Some(template)
    }

    /// A part of a template, compiled.
    pub fn piece(&mut self, piece: RawPiece, in_attribute: bool) -> Option<Piece> {
        let RawPiece::Placeholder { expression, decimals } = piece else {
            let RawPiece::Literal(text) = piece else {
                return None;
            };
            return Some(Piece::Literal(text));
        };
        let compiled = self.expressions.compile(expression)?;
        if in_attribute && compiled.value.kind == Kind::Text {
            self.expressions.error(
                "not-a-number",
                words(
                    "an attribute can hold numbers only, and this is a text",
                    "un atributo solo puede contener números, y esto es un texto",
                ),
                compiled.span,
            );
            return None;
        }
        let index = self.value(compiled)?;
        Some(Piece::Value { index, decimals })
    }

    /// The place of a value among those of the scene; equal ones are computed once.
    pub fn value(&mut self, Placed { value: compiled, span }: Placed) -> Option<usize> {
        let known = self.values.iter().position(|value| {
            value.node == compiled.node && value.unit == compiled.unit && value.kind == compiled.kind
        });
        if known.is_some() {
            return known;
        }
        if self.values.len() == VALUES {
            self.expressions.error(
                "too-large",
                words!(
                    "a scene cannot have more than {VALUES} values",
                    "una escena no puede tener más de {VALUES} valores"
                ),
                span,
            );
            return None;
        }
        self.values.push(compiled);
        Some(self.values.len() - 1)
    }
}

/// What a text of a scene says, for its translation.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneText {
    /// The text as written.
    key: String,
    /// Whether there is something to translate.
    needed: bool,
    /// Its values as written, and which of the scene's they are.
    values: Vec<(String, usize)>,
}

impl SceneText {
    /// The text in another language, if there is one.
    fn translate(&self, texts: &mut Texts) -> Option<Template> {
        if self.key.is_empty() {
            return None;
        }
        let (translated, span) = texts.translate(&self.key, self.needed)?;
        // Each value of the translation must be one of the original, written the same way.
        let mut scratch = Vec::new();
        let pieces = template::split(&translated, 0..translated.len(), &mut scratch);
        let pieces = pieces.into_iter().map(|piece| match piece {
            RawPiece::Literal(text) => Some(Piece::Literal(text)),
            RawPiece::Placeholder { expression, decimals } => {
                let wanted = translated[expression].trim();
                let (_, index) = self.values.iter().find(|(written, _)| written == wanted)?;
                Some(Piece::Value { index: *index, decimals })
            }
        });
        let template = pieces.collect::<Option<Template>>().filter(|_| scratch.is_empty());
        if template.is_none() {
            texts.refuse(Diagnostic::error(
                "translation",
                words(
                    "the translation must contain the same `{expressions}` as the original",
                    "la traducción debe contener las mismas `{expressions}` que el original",
                ),
                span,
            ));
        }
        template
    }
}

/// The scene in another language: the same drawing with the same values. `words` is what [`super::build`] has given with it.
pub fn translated(scene: &Scene, words: &[SceneText], texts: &mut Texts) -> Scene {
    let mut scene = scene.clone();
    translate(&mut scene.root, &mut words.iter(), texts);
    scene
}

/// Takes from `originals` as many as there are texts in the element.
fn translate(element: &mut Element, originals: &mut std::slice::Iter<SceneText>, texts: &mut Texts) {
    if element.name == "style" {
        return;
    }
    for child in &mut element.children {
        match child {
            Child::Element(inner) => translate(inner, originals, texts),
            Child::Text(template) => {
                if let Some(translated) = originals.next().and_then(|original| original.translate(texts)) {
                    *template = translated;
                }
            }
        }
    }
}

/// Whether a text has something to translate.
pub fn has_word(text: &str) -> bool {
    text.split(|c: char| !c.is_alphabetic()).any(|word| word.chars().count() > 2)
}
