//! From elements as written to a scene: what is not allowed is left out, what is written in braces is compiled.

use super::allowed::{ELEMENTS, is_id};
use super::style;
use super::translate::SceneText;
use super::xml::{RawChild, RawElement, parse};
use crate::expressions::Expressions;
use model::{Diagnostic, Span};
use program::{Child, Compiled, Element, Piece, Scene};
use std::collections::BTreeSet;
use std::ops::Range;
use units::{Words, words};

/// Reads the scene in `range`: definitions, then one `svg` element. Also what its texts say, for translations.
pub fn build(expressions: &mut Expressions, range: Range<usize>) -> Option<(Scene, Vec<SceneText>)> {
    let source = expressions.source;
    let opening = Span::new(range.start, range.start);
    let Some(length) = source[range.clone()].find("<svg") else {
        expressions.diagnostics.push(
            Diagnostic::error(
                "scene-syntax",
                words("a scene needs a drawing", "una escena necesita un dibujo"),
                opening,
            )
            .with_hint(words(
                "begin it with `<svg viewBox=\"0 0 400 300\">`",
                "empiézala con `<svg viewBox=\"0 0 400 300\">`",
            )),
        );
        return None;
    };
    let start = range.start + length;
    expressions.define(range.start..start);
    let children = parse(source, start..range.end, &mut expressions.diagnostics);
    let mut builder =
        Builder { expressions, values: Vec::new(), words: Vec::new(), ids: BTreeSet::new(), references: Vec::new() };
    builder.collect_ids(&children);
    let mut root = None;
    for child in children {
        match child {
            RawChild::Element(element) if root.is_none() => root = builder.root(element),
            RawChild::Element(element) => builder.refuse(
                words("a scene is one `svg` element", "una escena es un solo elemento `svg`"),
                element.name,
                None,
            ),
            RawChild::Text(text) => {
                let text = crate::source::trim(source, text);
                if !text.is_empty() {
                    builder.refuse(
                        words("this text stands outside the drawing", "este texto está fuera del dibujo"),
                        text,
                        None,
                    );
                }
            }
        }
    }
    builder.check_references();
    let Builder { values, words, .. } = builder;
    expressions.forget();
    Some((Scene { root: root?, values }, words))
}

/// Builds one scene.
pub struct Builder<'b, 'a> {
    /// Where the values are compiled.
    pub expressions: &'b mut Expressions<'a>,
    /// The values so far.
    pub values: Vec<Compiled>,
    /// What the texts so far say.
    pub words: Vec<SceneText>,
    /// The ids that elements have.
    ids: BTreeSet<String>,
    /// The ids that attributes refer to.
    pub references: Vec<(String, Range<usize>)>,
}

/// Where the values of the attributes for dragging stand.
#[derive(Default)]
pub struct Dragging {
    /// `drag`: the name of a state.
    pub state: Option<Range<usize>>,
    /// `drag-up`: what one unit upwards adds to it.
    pub up: Option<Range<usize>>,
    /// `drag-right`: what one unit to the right adds to it.
    pub right: Option<Range<usize>>,
}

impl Builder<'_, '_> {
    /// The source at a place.
    pub fn source(&self, range: &Range<usize>) -> &str {
        &self.expressions.source[range.clone()]
    }

    /// Reports what is left out.
    pub fn refuse(&mut self, message: Words, range: Range<usize>, hint: Option<Words>) {
        let mut diagnostic = Diagnostic::error("scene-refused", message, Span::new(range.start, range.end));
        diagnostic.hints.extend(hint);
        self.expressions.diagnostics.push(diagnostic);
    }

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
                            words!("`{id}` cannot be an id", "`{id}` no puede ser un id"),
                            place,
                            Some(words("use letters, digits, `-` and `_`", "usa letras, cifras, `-` y `_`")),
                        );
                    } else if !self.ids.insert(id.clone()) {
                        self.refuse(
                            words!("the id `{id}` is used twice", "el id `{id}` se usa dos veces"),
                            place,
                            None,
                        );
                    }
                }
            }
            self.collect_ids(&element.children);
        }
    }

    fn check_references(&mut self) {
        for (id, place) in std::mem::take(&mut self.references) {
            if !self.ids.contains(&id) {
                self.refuse(
                    words!("nothing in the scene has the id `{id}`", "nada en la escena tiene el id `{id}`"),
                    place,
                    None,
                );
            }
        }
    }

    fn root(&mut self, raw: RawElement) -> Option<Element> {
        if self.source(&raw.name) != "svg" {
            self.refuse(words("a scene is one `svg` element", "una escena es un solo elemento `svg`"), raw.name, None);
            return None;
        }
        let name = raw.name.clone();
        let root = self.element(raw)?;
        if !root.attributes.iter().any(|attribute| attribute.name == "viewBox") {
            self.refuse(
                words("the `svg` element needs a `viewBox`", "el elemento `svg` necesita un `viewBox`"),
                name,
                Some(words(
                    "`viewBox=\"0 0 400 300\"` gives the drawing 400 by 300 units",
                    "`viewBox=\"0 0 400 300\"` da al dibujo 400 por 300 unidades",
                )),
            );
        }
        Some(root)
    }

    fn element(&mut self, raw: RawElement) -> Option<Element> {
        let name = self.source(&raw.name).to_owned();
        if !ELEMENTS.contains(&name.as_str()) {
            let hint = units::nearest(&name, ELEMENTS)
                .map(|near| words!("did you mean `{near}`?", "¿querías decir `{near}`?"));
            self.refuse(
                words!(
                    "a scene cannot contain `<{name}>`; it is left out with what it holds",
                    "una escena no puede contener `<{name}>`; se omite con lo que contiene"
                ),
                raw.name,
                hint,
            );
            return None;
        }
        let mut element = Element { name, attributes: Vec::new(), children: Vec::new(), drag: None };
        let mut dragging = Dragging::default();
        for (name, value) in raw.attributes {
            match self.source(&name) {
                "drag" => dragging.state = Some(value),
                "drag-up" => dragging.up = Some(value),
                "drag-right" => dragging.right = Some(value),
                _ => element.attributes.extend(self.attribute(name, value)),
            }
        }
        element.drag = self.drag(dragging);
        for child in raw.children {
            match child {
                RawChild::Text(text) if element.name == "style" => {
                    let rules = style::rules(self.expressions.source, text, &mut self.expressions.diagnostics);
                    element.children.push(Child::Text(vec![Piece::Literal(rules)]));
                }
                RawChild::Element(inner) if element.name == "style" || self.source(&inner.name) == "svg" => {
                    self.refuse(
                        words!(
                            "`<{}>` cannot contain `<{}>`",
                            "`<{}>` no puede contener `<{}>`",
                            element.name,
                            self.source(&inner.name)
                        ),
                        inner.name,
                        None,
                    );
                }
                RawChild::Element(inner) => element.children.extend(self.element(inner).map(Child::Element)),
                RawChild::Text(text) if matches!(element.name.as_str(), "text" | "tspan" | "title" | "desc") => {
                    element.children.extend(self.text(text).map(Child::Text));
                }
                RawChild::Text(text) => {
                    let text = crate::source::trim(self.expressions.source, text);
                    if !text.is_empty() {
                        self.refuse(
                            words("text is shown inside `<text>` only", "el texto solo se muestra dentro de `<text>`"),
                            text,
                            None,
                        );
                    }
                }
            }
        }
        Some(element)
    }
}
