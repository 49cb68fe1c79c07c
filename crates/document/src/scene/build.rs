//! Builds a scene from its source: definitions, then one `svg` element.

use super::allowed::is_id;
use super::builder::Builder;
use super::space::frame::four_numbers;
use super::space::marks::Marks;
use super::translate::SceneText;
use super::xml::{RawChild, RawElement, parse};
use crate::expressions::Expressions;
use model::{Diagnostic, Span};
use program::{Element, Scene};
use std::ops::Range;
use units::{Language, words};

/// Reads the scene in `range`: definitions, then one `svg` element. Also returns its texts, for translations.
pub fn build(
    expressions: &mut Expressions,
    range: Range<usize>,
    language: Language,
) -> Option<(Scene, Vec<SceneText>)> {
    let (scene, words, _) = build_with(expressions, range, language, None)?;
    Some((scene, words))
}

/// Reads the scene in `range` and returns the places of its elements.
pub fn build_marked(expressions: &mut Expressions, range: Range<usize>, language: Language) -> Option<Marks> {
    build_with(expressions, range, language, Some(Marks::default()))?.2
}

fn build_with(
    expressions: &mut Expressions,
    range: Range<usize>,
    language: Language,
    marks: Option<Marks>,
) -> Option<(Scene, Vec<SceneText>, Option<Marks>)> {
    let source = expressions.source;
    let opening = Span::new(range.start, range.start);
    let Some(length) = source[range.clone()].find("<svg") else {
        expressions.diagnostics.push(
            Diagnostic::error("scene-syntax", words("a scene needs a drawing"), opening)
                .with_hint(words("begin it with `<svg viewBox=\"0 0 400 300\">`")),
        );
        return None;
    };
    let start = range.start + length;
    expressions.define(range.start..start);
    let children = parse(source, start..range.end, &mut expressions.diagnostics);
    let mut builder = Builder::new(expressions, language, opening, marks);
    builder.collect_ids(&children);
    let mut root = None;
    for child in children {
        match child {
            RawChild::Element(element) if root.is_none() => root = builder.root(element),
            RawChild::Element(element) => builder.refuse(words("a scene is one `svg` element"), element.name, None),
            RawChild::Text(text) => {
                let text = crate::text::source::trim(source, text);
                if !text.is_empty() {
                    builder.refuse(words("this text stands outside the drawing"), text, None);
                }
            }
        }
    }
    builder.check_references();
    builder.expressions.forget();
    Some(builder.finish(root?))
}

impl Builder<'_, '_> {
    fn collect_ids(&mut self, children: &[RawChild]) {
        for child in children {
            let RawChild::Element(element) = child else {
                continue;
            };
            for (name, value) in &element.attributes {
                if self.source(name) == "id" {
                    let (id, place) = (self.source(value).to_owned(), value.clone());
                    if !is_id(&id) {
                        self.refuse(
                            words!("`{id}` cannot be an id"),
                            place,
                            Some(words("use letters, digits, `-` and `_`")),
                        );
                    } else if !self.ids.add(id.clone()) {
                        self.refuse(words!("the id `{id}` is used twice"), place, None);
                    }
                }
            }
            self.collect_ids(&element.children);
        }
    }

    fn check_references(&mut self) {
        for (id, place) in self.ids.take_unknown() {
            self.refuse(words!("nothing in the scene has the id `{id}`"), place, None);
        }
    }

    fn root(&mut self, raw: RawElement) -> Option<Element> {
        if self.source(&raw.name) != "svg" {
            self.refuse(words("a scene is one `svg` element"), raw.name, None);
            return None;
        }
        let name = raw.name.clone();
        let view_box = raw.attributes.iter().find(|(name, _)| self.source(name) == "viewBox");
        if let Some((_, value)) = view_box {
            self.set_view_box(four_numbers(self.source(value)));
        }
        let root = self.element(raw)?;
        if !root.attributes.iter().any(|attribute| attribute.name == "viewBox") {
            self.refuse(
                words("the `svg` element needs a `viewBox`"),
                name,
                Some(words("`viewBox=\"0 0 400 300\"` gives the drawing 400 by 300 units")),
            );
        }
        Some(root)
    }
}
