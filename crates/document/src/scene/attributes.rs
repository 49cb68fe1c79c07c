//! Attributes: those that are allowed, with the values of the model in them.

use super::allowed::{ATTRIBUTES, REFERRING, danger, is_id, is_idle, reference};
use super::build::Builder;
use super::style::PREFIX;
use super::template::{self, RawPiece};
use super::{Attribute, Piece, Template};
use std::ops::Range;

impl Builder<'_, '_> {
    /// The attribute, unless it is not allowed.
    pub fn attribute(&mut self, name: Range<usize>, value: Range<usize>) -> Option<Attribute> {
        let text = self.source(&name).to_owned();
        if is_idle(&text) {
            return None;
        }
        if !ATTRIBUTES.contains(&text.as_str()) {
            let hint = match text.as_str() {
                "style" => Some("write the properties as attributes, `fill=\"red\"`, or in a `<style>`".to_owned()),
                "href" | "xlink:href" => Some("a scene refers to nothing outside itself".to_owned()),
                _ => model::nearest(&text, ATTRIBUTES).map(|near| format!("did you mean `{near}`?")),
            };
            self.refuse(
                format!("the attribute `{text}` is not allowed in a scene; it is left out"),
                name,
                hint.as_deref(),
            );
            return None;
        }
        let raw = template::split(self.expressions.source, value.clone(), &mut self.expressions.diagnostics);
        if let [RawPiece::Literal(literal)] = &raw[..]
            && let Some(id) = reference(literal)
            && REFERRING.contains(&text.as_str())
        {
            self.references.push((id.to_owned(), value));
            return Some(Attribute { name: text, value: vec![Piece::Literal(format!("url(#{PREFIX}{id})"))] });
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
                .then_some("only `url(#id)` with the id of an element of this scene can stand here");
            self.refuse(format!("`{word}` is not allowed in a scene; `{text}` is left out"), value, hint);
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
        if has_values {
            self.refuse(format!("`{name}` cannot hold values of the model"), place, None);
            return None;
        }
        let text = if name == "id" {
            is_id(&text).then(|| format!("{PREFIX}{text}"))?
        } else {
            let names = || text.split_whitespace();
            let known: Vec<String> = names().filter(|name| is_id(name)).map(|name| format!("{PREFIX}{name}")).collect();
            if known.len() < names().count() {
                self.refuse(format!("`{text}` is not a list of class names"), place, None);
            }
            known.join(" ")
        };
        Some(Attribute { name, value: vec![Piece::Literal(text)] })
    }
}
