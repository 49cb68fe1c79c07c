//! Texts and values of a scene.

use super::build::Builder;
use super::template::{self, RawPiece, normalised};
use super::{Piece, Template};
use model::{Compiled, Diagnostic, Kind};
use std::ops::Range;

/// How many values a scene may have; all of them are computed for every frame.
const VALUES: usize = 1_000;

impl Builder<'_, '_> {
    /// A text, in the language asked for.
    pub fn text(&mut self, range: Range<usize>) -> Option<Template> {
        let raw = template::split(self.expressions.source, range.clone(), &mut self.expressions.diagnostics);
        let original: Option<Template> = raw.iter().cloned().map(|piece| self.piece(piece, false)).collect();
        let mut original = original?;
        let key = normalised(self.source(&range));
        if key.is_empty() {
            return (!original.is_empty()).then_some(original);
        }
        let has_words = raw.iter().any(|piece| matches!(piece, RawPiece::Literal(text) if has_word(text)));
        let Some((translated, span)) = self.texts.translate(&key, has_words) else {
            return Some(original);
        };
        // Each value of the translation must be one of the original, written the same way.
        let mut scratch = Vec::new();
        let template =
            template::split(&translated, 0..translated.len(), &mut scratch).into_iter().map(|piece| match piece {
                RawPiece::Literal(text) => Some(Piece::Literal(text)),
                RawPiece::Placeholder { expression, decimals } => {
                    let wanted = translated[expression].trim();
                    raw.iter().zip(&original).find_map(|(raw, piece)| match (raw, piece) {
                        (RawPiece::Placeholder { expression, .. }, Piece::Value { index, .. })
                            if self.source(expression).trim() == wanted =>
                        {
                            Some(Piece::Value { index: *index, decimals })
                        }
                        _ => None,
                    })
                }
            });
        match template.collect::<Option<Template>>() {
            Some(template) if scratch.is_empty() => original = template,
            _ => self.texts.refuse(Diagnostic::error(
                "translation",
                "the translation must contain the same `{expressions}` as the original",
                span,
            )),
        }
        Some(original)
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
        if in_attribute && compiled.kind == Kind::Text {
            self.expressions.error(
                "not-a-number",
                "an attribute can hold numbers only, and this is a text",
                compiled.span,
            );
            return None;
        }
        let index = self.value(compiled)?;
        Some(Piece::Value { index, decimals })
    }

    /// The place of a value among those of the scene; equal ones are computed once.
    pub fn value(&mut self, compiled: Compiled) -> Option<usize> {
        let known = self.values.iter().position(|value| {
            value.node == compiled.node && value.unit == compiled.unit && value.kind == compiled.kind
        });
        if known.is_some() {
            return known;
        }
        if self.values.len() == VALUES {
            self.expressions.error(
                "too-large",
                format!("a scene cannot have more than {VALUES} values"),
                compiled.span,
            );
            return None;
        }
        self.values.push(compiled);
        Some(self.values.len() - 1)
    }
}

/// Whether a text has something to translate.
pub fn has_word(text: &str) -> bool {
    text.split(|c: char| !c.is_alphabetic()).any(|word| word.chars().count() > 2)
}
