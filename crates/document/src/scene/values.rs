//! Texts and values in the elements of a scene.

use super::builder::Builder;
use super::template::{self, RawPiece, normalised};
use super::translate::{SceneText, has_word};
use crate::expressions::Placed;
use program::{Compiled, Kind, NodeId, Piece, Template};
use std::ops::Range;
use units::{Unit, words};

impl Builder<'_, '_> {
    /// Compiles a text and records it for translations.
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
        self.record_text(text);
        Some(template)
    }

    /// Records a text that is not in the document and is not translated.
    pub fn unsaid(&mut self) {
        self.record_text(SceneText::default());
    }

    /// Compiles a piece of a text.
    pub fn piece(&mut self, piece: RawPiece, in_attribute: bool) -> Option<Piece> {
        let RawPiece::Placeholder { expression, decimals } = piece else {
            let RawPiece::Literal(text) = piece else {
                return None;
            };
            return Some(Piece::Literal(text));
        };
        let expressions = &mut self.expressions;
        let compiled = if in_attribute { expressions.bare(expression) } else { expressions.compile(expression) }?;
        if in_attribute && compiled.value.kind == Kind::Text {
            self.expressions.error(
                "not-a-number",
                words("an attribute can hold numbers only, and this is a text"),
                compiled.span,
            );
            return None;
        }
        let index = self.value(compiled)?;
        Some(Piece::Value { index, decimals })
    }

    /// A number in units of the drawing, for an attribute; constants are written as text.
    pub fn drawn(&mut self, node: NodeId) -> Option<Piece> {
        if let Some(constant) = self.graph().as_constant(node) {
            let shown = constant as f32;
            // Avoids `-0`.
            let text = if shown.is_finite() && shown != 0.0 { shown.to_string() } else { "0".to_owned() };
            return Some(Piece::Literal(text));
        }
        let index = self.drawn_value(node)?;
        Some(Piece::Value { index, decimals: None })
    }

    /// Index of a value in units of the drawing.
    pub fn drawn_value(&mut self, node: NodeId) -> Option<usize> {
        let value = Compiled { node, unit: Unit::dimensionless(), kind: Kind::Number };
        self.value(Placed { value, span: self.element_place() })
    }
}
