//! Translation of the texts of a scene.

use super::template::{self, RawPiece};
use crate::translating::translation::Texts;
use model::Diagnostic;
use program::{Child, Element, Piece, Scene, Template};
use units::{Language, Words, words};

/// A text of a scene, for its translation.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneText {
    /// Text as written.
    pub(super) key: String,
    /// True if it contains words to translate.
    pub(super) needed: bool,
    /// Text that is not written in the document: the name of a part.
    pub(super) generated: Option<Words>,
    /// Its values as written, with their indices among the values of the scene.
    pub(super) values: Vec<(String, usize)>,
}

impl SceneText {
    /// The text as written, if it is to be translated in the document.
    pub(crate) fn translatable(&self) -> Option<&str> {
        (self.generated.is_none() && self.needed).then_some(self.key.as_str())
    }

    /// The text in another language, if there is one.
    fn translate(&self, texts: &mut Texts, language: Language) -> Option<Template> {
        if let Some(words) = &self.generated {
            return Some(vec![Piece::Literal(words.text(language).into_owned())]);
        }
        if self.key.is_empty() {
            return None;
        }
        let (translated, span) = texts.translate(&self.key, self.needed)?;
        // Each value of the translation must be a value of the original, written in the same way.
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
                words("the translation must contain the same `{expressions}` as the original"),
                span,
            ));
        }
        template
    }
}

/// The scene in another language: the same drawing with the same values. `words`: the texts returned by [`super::build()`].
pub fn translated(scene: &Scene, words: &[SceneText], texts: &mut Texts, language: Language) -> Scene {
    let mut scene = scene.clone();
    translate(&mut scene.root, &mut words.iter(), texts, language);
    scene
}

/// Translates an element and consumes one entry of `originals` per text.
fn translate(
    element: &mut Element,
    originals: &mut std::slice::Iter<SceneText>,
    texts: &mut Texts,
    language: Language,
) {
    if element.name == "style" {
        return;
    }
    for child in &mut element.children {
        match child {
            Child::Element(inner) => translate(inner, originals, texts, language),
            Child::Text(template) => {
                if let Some(translated) = originals.next().and_then(|original| original.translate(texts, language)) {
                    *template = translated;
                }
            }
        }
    }
}

/// True if a text contains a word of more than two letters.
pub fn has_word(text: &str) -> bool {
    text.split(|c: char| !c.is_alphabetic()).any(|word| word.chars().count() > 2)
}
