//! Attributes: those that are allowed, with the values of the model in them.

use super::allowed::{ATTRIBUTES, REFERRING, danger, is_id, is_idle, reference};
use super::builder::Builder;
use super::choice::{is_colour, palette};
use super::template::{self, RawPiece};
use program::{Attribute, Kind, Piece, Template};
use std::ops::Range;
use units::words;

impl Builder<'_, '_> {
    /// The attribute, unless it is not allowed.
    pub fn attribute(&mut self, name: Range<usize>, value: Range<usize>) -> Option<Attribute> {
        let text = self.source(&name).to_owned();
        if is_idle(&text) {
            return None;
        }
        if !ATTRIBUTES.contains(&text.as_str()) {
            let message = words!(
                "the attribute `{text}` is not allowed in a scene; it is left out",
                "el atributo `{text}` no se admite en una escena; se omite"
            );
            let hint = match text.as_str() {
                "style" => words(
                    "write the properties as attributes, `fill=\"red\"`, or in a `<style>`",
                    "escribe las propiedades como atributos, `fill=\"red\"`, o en un `<style>`",
                ),
                "href" | "xlink:href" => {
                    words("a scene refers to nothing outside itself", "una escena no remite a nada fuera de sí misma")
                }
                _ => {
                    self.refuse_word(message, name, units::nearest(&text, ATTRIBUTES));
                    return None;
                }
            };
            self.refuse(message, name, Some(hint));
            return None;
        }
        let raw = template::split(self.expressions.source, value.clone(), &mut self.expressions.diagnostics);
        if let [RawPiece::Literal(literal)] = &raw[..]
            && is_colour(&text)
            && let Some(colour) = palette(literal)
        {
            return Some(Attribute { name: text, value: vec![Piece::Literal(colour.to_owned())] });
        }
        if let [RawPiece::Placeholder { expression, .. }] = &raw[..]
            && is_colour(&text)
        {
            let placed = self.expressions.bare(expression.clone())?;
            let piece = if placed.value.kind == Kind::Text {
                self.colour(placed)?
            } else {
                Piece::Value { index: self.value(placed)?, decimals: None }
            };
            return Some(Attribute { name: text, value: vec![piece] });
        }
        if let [RawPiece::Literal(literal)] = &raw[..]
            && let Some(id) = reference(literal)
            && REFERRING.contains(&text.as_str())
        {
            self.references.push((id.to_owned(), value));
            return Some(Attribute { name: text, value: vec![Piece::Literal(format!("url(#{id})"))] });
        }
        let literals: String = raw
            .iter()
            .filter_map(|piece| match piece {
                RawPiece::Literal(literal) => Some(literal.as_str()),
                RawPiece::Placeholder { .. } => None,
            })
            .collect();
        if let Some(word) = danger(&literals) {
            let hint = REFERRING.contains(&text.as_str()).then_some(words(
                "only `url(#id)` with the id of an element of this scene can stand here",
                "aquí solo puede estar `url(#id)` con el id de un elemento de esta escena",
            ));
            self.refuse(
                words!(
                    "`{word}` is not allowed in a scene; `{text}` is left out",
                    "`{word}` no se admite en una escena; `{text}` se omite"
                ),
                value,
                hint,
            );
            return None;
        }
        if matches!(text.as_str(), "id" | "class") {
            return self.name_attribute(
                text,
                literals,
                raw.len() > 1 || matches!(raw[..], [RawPiece::Placeholder { .. }]),
                value,
            );
        }
        let value = raw.into_iter().map(|piece| self.piece(piece, true)).collect::<Option<Template>>()?;
        Some(Attribute { name: text, value })
    }

    /// `id` and `class`, which hold no values of the model.
    fn name_attribute(
        &mut self,
        name: String,
        text: String,
        has_values: bool,
        place: Range<usize>,
    ) -> Option<Attribute> {
        if name == "id" && self.repeating > 0 {
            self.refuse(
                words("what is repeated cannot have an `id`", "lo que se repite no puede tener un `id`"),
                place,
                None,
            );
            return None;
        }
        if has_values {
            self.refuse(
                words!("`{name}` cannot hold values of the model", "`{name}` no puede contener valores del modelo"),
                place,
                None,
            );
            return None;
        }
        let text = if name == "id" {
            is_id(&text).then_some(text)?
        } else {
            let names = || text.split_whitespace();
            let known: Vec<&str> = names().filter(|name| is_id(name)).collect();
            if known.len() < names().count() {
                self.refuse(
                    words!("`{text}` is not a list of class names", "`{text}` no es una lista de nombres de clase"),
                    place,
                    None,
                );
            }
            known.join(" ")
        };
        Some(Attribute { name, value: vec![Piece::Literal(text)] })
    }
}
