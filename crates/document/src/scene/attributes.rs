//! Permitted attributes, with values of the model.

use super::allowed::{ATTRIBUTES, REFERRING, danger, is_id, is_idle, reference};
use super::appearance::misfit;
use super::builder::Builder;
use super::colours::{is_colour, palette};
use super::template::{self, RawPiece};
use crate::text::source::trim;
use model::{Diagnostic, Span};
use program::{Attribute, Kind, Piece, Template};
use std::ops::Range;
use units::words;

impl Builder<'_, '_> {
    /// The attribute; `None` if it is not permitted.
    pub fn attribute(&mut self, name: Range<usize>, value: Range<usize>) -> Option<Attribute> {
        let text = self.source(&name).to_owned();
        if is_idle(&text) {
            return None;
        }
        if !ATTRIBUTES.contains(&text.as_str()) {
            let message = words!("the attribute `{text}` is not allowed in a scene; it is left out");
            let hint = match text.as_str() {
                "style" => words("write the properties as attributes, `fill=\"red\"`, or in a `<style>`"),
                "href" | "xlink:href" => words("a scene refers to nothing outside itself"),
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
            if placed.value.kind != Kind::Text {
                let message = words("a colour is a text, and this is none");
                let hint = words!("such as `{text}=\"{{if x > 0 then \"mark\" else \"liquid\"}}\"`");
                self.refuse_at(message, placed.span, Some(hint));
                return None;
            }
            return Some(Attribute { name: text, value: vec![self.colour(placed)?] });
        }
        if let [RawPiece::Literal(literal)] = &raw[..]
            && let Some(id) = reference(literal)
            && REFERRING.contains(&text.as_str())
        {
            self.ids.refer(id, value);
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
            let hint = REFERRING
                .contains(&text.as_str())
                .then_some(words("only `url(#id)` with the id of an element of this scene can stand here"));
            self.refuse(words!("`{word}` is not allowed in a scene; `{text}` is left out"), value, hint);
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
        if let Some(found) = self.misfit(&text, &raw, value) {
            self.expressions.diagnostics.push(found);
            return None;
        }
        let value = raw.into_iter().map(|piece| self.piece(piece, true)).collect::<Option<Template>>()?;
        Some(Attribute { name: text, value })
    }

    /// Reports a colour or a number that browsers would ignore.
    fn misfit(&self, name: &str, raw: &[RawPiece], place: Range<usize>) -> Option<Diagnostic> {
        let written: String = raw
            .iter()
            .map(|piece| match piece {
                RawPiece::Literal(literal) => literal.as_str(),
                RawPiece::Placeholder { .. } => "0",
            })
            .collect();
        let place = trim(self.expressions.source, place);
        let span = Span::new(place.start, place.end);
        let mut found = misfit(name, &written, span)?;
        if raw.iter().any(|piece| matches!(piece, RawPiece::Placeholder { .. })) {
            // The fix would overwrite the values of the model.
            found.fixes.clear();
        }
        Some(found)
    }

    /// `id` and `class`, which cannot contain values of the model.
    fn name_attribute(
        &mut self,
        name: String,
        text: String,
        has_values: bool,
        place: Range<usize>,
    ) -> Option<Attribute> {
        if name == "id" && self.quantity.is_repeating() {
            self.refuse(words("what is repeated cannot have an `id`"), place, None);
            return None;
        }
        if has_values {
            self.refuse(words!("`{name}` cannot hold values of the model"), place, None);
            return None;
        }
        let text = if name == "id" {
            is_id(&text).then_some(text)?
        } else {
            let names = || text.split_whitespace();
            let known: Vec<&str> = names().filter(|name| is_id(name)).collect();
            if known.len() < names().count() {
                self.refuse(words!("`{text}` is not a list of class names"), place, None);
            }
            known.join(" ")
        };
        Some(Attribute { name, value: vec![Piece::Literal(text)] })
    }
}
