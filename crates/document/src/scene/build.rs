//! From elements as written to a scene: what is not allowed is left out, what is written in braces is compiled.

use super::allowed::{ELEMENTS, is_id};
use super::frame::four_numbers;
use super::shapes::{Geometry, is_geometry};
use super::space::Space;
use super::style;
use super::translate::SceneText;
use super::xml::{RawChild, RawElement, parse};
use crate::expressions::Expressions;
use model::{Diagnostic, Span};
use program::{Child, Compiled, Element, NodeId, Piece, Scene};
use std::collections::{BTreeMap, BTreeSet};
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
    let space = Space::drawing(expressions.graph());
    let mut builder = Builder {
        expressions,
        values: Vec::new(),
        numbers: BTreeMap::new(),
        words: Vec::new(),
        ids: BTreeSet::new(),
        references: Vec::new(),
        view_box: None,
        space,
        place: opening,
    };
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
    /// Which of them have a node.
    pub numbers: BTreeMap<NodeId, Vec<usize>>,
    /// What the texts so far say.
    pub words: Vec<SceneText>,
    /// The ids that elements have.
    ids: BTreeSet<String>,
    /// The ids that attributes refer to.
    pub references: Vec<(String, Range<usize>)>,
    /// Left, top, width and height of the drawing.
    pub view_box: Option<[f64; 4]>,
    /// What lengths mean here.
    pub space: Space,
    /// Where the element stands that is being built.
    pub place: Span,
}

/// Where the values of the attributes for dragging stand.
#[derive(Default)]
pub struct Dragging {
    /// `drag`: the name of a state or a parameter.
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
        let view_box = raw.attributes.iter().find(|(name, _)| self.source(name) == "viewBox");
        self.view_box = view_box.and_then(|(_, value)| four_numbers(self.source(value)));
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
        self.place = Span::new(raw.name.start, raw.name.end);
        if name != "frame" && !ELEMENTS.contains(&name.as_str()) {
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
        let outside = self.space.clone();
        let element = self.placed(name, raw);
        self.space = outside;
        element
    }

    /// An element with its attributes and what it holds. A frame and a group of a frame leave their own space behind.
    fn placed(&mut self, name: String, raw: RawElement) -> Option<Element> {
        let is_frame = name == "frame";
        let mut element = Element {
            name: if is_frame { "g".to_owned() } else { name.clone() },
            attributes: Vec::new(),
            children: Vec::new(),
            drag: None,
        };
        let mut dragging = Dragging::default();
        let mut geometry = Geometry::new();
        let mut visible = None;
        for (attribute, value) in raw.attributes {
            match self.source(&attribute) {
                "drag" => dragging.state = Some(value),
                "drag-up" => dragging.up = Some(value),
                "drag-right" => dragging.right = Some(value),
                "visible" => visible = self.visible(value),
                own @ ("x" | "y" | "box") if is_frame => drop(geometry.insert(own.to_owned(), value)),
                own if self.space.framed && is_geometry(&name, own) => drop(geometry.insert(own.to_owned(), value)),
                "transform" if self.space.framed => self.refuse(
                    words("`transform` counts in units of the drawing", "`transform` cuenta en unidades del dibujo"),
                    attribute,
                    Some(words(
                        "in a frame write `<g at=\"(x, y)\" turn=\"phi\">`",
                        "en un marco escribe `<g at=\"(x, y)\" turn=\"phi\">`",
                    )),
                ),
                _ => element.attributes.extend(self.attribute(attribute, value)),
            }
        }
        let mut take = |name: &str| geometry.remove(name);
        let mut anchor = None;
        if is_frame {
            let axes = [take("x"), take("y"), take("box")];
            self.space = self.frame_space(raw.name, axes)?;
        } else if name == "g" {
            let (at, turn) = (take("at"), take("turn"));
            if at.is_some() || turn.is_some() {
                let outside = self.space.clone();
                let (transform, place) = self.group_space(at, turn)?;
                element.attributes.push(transform);
                let inside = std::mem::replace(&mut self.space, outside);
                element.drag = self.drag(std::mem::take(&mut dragging), Some(place));
                self.space = inside;
            }
        } else if self.space.framed {
            let (attributes, place) = self.shape(&name, &geometry);
            element.attributes.extend(attributes);
            anchor = place;
        }
        element.attributes.extend(visible);
        if element.drag.is_none() {
            element.drag = self.drag(dragging, anchor);
        }
        self.children(&mut element, raw.children);
        Some(element)
    }

    fn children(&mut self, element: &mut Element, children: Vec<RawChild>) {
        for child in children {
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
    }
}
