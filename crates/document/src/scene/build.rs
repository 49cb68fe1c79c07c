//! Builds a scene from its source: definitions, then one `svg` element.

use super::allowed::is_id;
use super::builder::Builder;
use super::space::Space;
use super::space::frame::four_numbers;
use super::space::marks::Marks;
use super::translate::SceneText;
use super::xml::{RawChild, RawElement, parse};
use crate::expressions::Expressions;
use model::{Diagnostic, Span};
use program::{Element, Scene};
use std::collections::{BTreeMap, BTreeSet};
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
    let space = Space::drawing(expressions.graph());
    let mut builder = Builder {
        expressions,
        values: Vec::new(),
        trails: Vec::new(),
        length: None,
        numbers: BTreeMap::new(),
        words: Vec::new(),
        ids: BTreeSet::new(),
        references: Vec::new(),
        language,
        drawn: 0,
        copied: 0,
        repeating: 0,
        view_box: None,
        space,
        place: opening,
        marks,
    };
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
    let Builder { values, trails, length, words, marks, .. } = builder;
    expressions.forget();
    Some((Scene { root: root?, values, trails, length }, words, marks))
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
                    } else if !self.ids.insert(id.clone()) {
                        self.refuse(words!("the id `{id}` is used twice"), place, None);
                    }
                }
            }
            self.collect_ids(&element.children);
        }
    }

    fn check_references(&mut self) {
        for (id, place) in std::mem::take(&mut self.references) {
            if !self.ids.contains(&id) {
                self.refuse(words!("nothing in the scene has the id `{id}`"), place, None);
            }
        }
    }

    fn root(&mut self, raw: RawElement) -> Option<Element> {
        if self.source(&raw.name) != "svg" {
            self.refuse(words("a scene is one `svg` element"), raw.name, None);
            return None;
        }
        let name = raw.name.clone();
        let view_box = raw.attributes.iter().find(|(name, _)| self.source(name) == "viewBox");
        self.view_box = view_box.and_then(|(_, value)| four_numbers(self.source(value)));
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
