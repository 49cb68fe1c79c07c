//! Elements of a scene: SVG elements, frames, parts and their copies, with their content.

use super::allowed::ELEMENTS;
use super::builder::{Builder, Dragging};
use super::parts::{Given, PARTS, Part, part_of, title};
use super::space::shapes::{Geometry, is_geometry};
use super::style;
use super::translate::SceneText;
use super::xml::{RawChild, RawElement};
use model::Span;
use program::{Child, Element, Piece};
use units::words;

impl Builder<'_, '_> {
    /// Builds an element; `None` if it is not permitted.
    pub fn element(&mut self, raw: RawElement) -> Option<Element> {
        let name = self.source(&raw.name).to_owned();
        self.begin_element(Span::new(raw.name.start, raw.name.end));
        if let Some(part) = part_of(&name) {
            return self.part(part, raw);
        }
        if name != "frame" && !ELEMENTS.contains(&name.as_str()) {
            let all = ELEMENTS.into_iter().chain(["frame"]).chain(PARTS.iter().map(|part| part.name));
            self.refuse_word(
                words!("a scene cannot contain `<{name}>`; it is left out with what it holds"),
                raw.name,
                units::nearest(&name, all),
            );
            return None;
        }
        let outside = self.space().clone();
        let element = self.placed(name, raw);
        self.enter_space(outside);
        element
    }

    /// Builds an element, or its copies for each value of its index.
    fn repeated(&mut self, mut raw: RawElement, children: &mut Vec<Child>) {
        let Some(place) = raw.attributes.iter().position(|(name, _)| self.source(name) == "repeat") else {
            let place = raw.opening.start;
            self.enter(children.len());
            let element = self.element(raw);
            self.leave(place, element.is_some());
            children.extend(element.map(Child::Element));
            return;
        };
        let (_, range) = raw.attributes.remove(place);
        let Some((index, values)) = self.copies(range) else { return };
        self.quantity.begin_repeating();
        for value in values {
            let before = self.expressions.diagnostics.len();
            self.hold(&index, value);
            self.enter(children.len());
            let copy = self.element(raw.clone());
            self.leave(raw.opening.start, copy.is_some());
            self.release(&index);
            let fits = self.fits(copy.as_ref().map_or(0, size), raw.name.clone());
            children.extend(copy.map(Child::Element));
            // An error in one copy occurs in all copies.
            if !fits || self.expressions.diagnostics.len() > before {
                break;
            }
        }
        self.quantity.end_repeating();
    }

    /// Builds an element with attributes and content. After a frame, or a group in a frame, [`Self::space()`] is the inner
    /// coordinate system; the caller restores the outer one.
    fn placed(&mut self, name: String, raw: RawElement) -> Option<Element> {
        let is_frame = name == "frame";
        let place = raw.name.clone();
        let mut element = Element {
            name: if is_frame { "g".to_owned() } else { name.clone() },
            attributes: Vec::new(),
            children: Vec::new(),
            drag: None,
        };
        let mut dragging = Dragging::default();
        let mut geometry = Geometry::new();
        let mut visible = None;
        self.note_plain(&name, &raw.attributes);
        for (attribute, value) in raw.attributes {
            match self.source(&attribute) {
                "drag" | "drag-up" | "drag-right" | "drag-zero" => dragging.take(self.source(&attribute), value),
                "visible" => visible = self.visible(value),
                own @ ("x" | "y" | "box") if is_frame => drop(geometry.insert(own.to_owned(), value)),
                own if self.space().framed && is_geometry(&name, own) => drop(geometry.insert(own.to_owned(), value)),
                "transform" if self.space().framed => self.refuse(
                    words("`transform` counts in units of the drawing"),
                    attribute,
                    Some(words("in a frame write `<g at=\"(x, y)\" turn=\"phi\">`")),
                ),
                _ => element.attributes.extend(self.attribute(attribute, value)),
            }
        }
        let mut take = |name: &str| geometry.remove(name);
        let mut anchor = None;
        if is_frame {
            let axes = [take("x"), take("y"), take("box")];
            let space = self.frame_space(raw.name, axes)?;
            self.note_frame(&space);
            self.enter_space(space);
        } else if name == "g" {
            let (at, turn) = (take("at"), take("turn"));
            if at.is_some() || turn.is_some() {
                let outside = self.space().clone();
                let (transform, place) = self.group_space(at, turn)?;
                element.attributes.push(transform);
                let inside = self.enter_space(outside);
                element.drag = self.drag(std::mem::take(&mut dragging), Some(place));
                self.enter_space(inside);
            }
        } else if self.space().framed {
            let (attributes, place) = self.shape(&name, &geometry);
            element.attributes.extend(attributes);
            anchor = place;
        }
        element.attributes.extend(visible);
        if element.drag.is_none() {
            element.drag = self.drag(dragging, anchor);
        }
        self.children(&mut element, raw.children);
        if name == "clipPath" {
            self.join_clip(&mut element, place);
        }
        Some(element)
    }

    /// Builds a part: a group with a name, the drawn elements, and the attributes that the document sets on the whole.
    fn part(&mut self, part: &Part, raw: RawElement) -> Option<Element> {
        let mut element = Element { name: "g".to_owned(), attributes: Vec::new(), children: Vec::new(), drag: None };
        let mut dragging = Dragging::default();
        let mut given = Given::new();
        let mut visible = None;
        for (attribute, value) in raw.attributes {
            match self.source(&attribute) {
                "drag" | "drag-up" | "drag-right" | "drag-zero" => dragging.take(self.source(&attribute), value),
                "visible" => visible = self.visible(value),
                own if part.attributes.contains(&own) => drop(given.insert(own.to_owned(), value)),
                _ => element.attributes.extend(self.attribute(attribute, value)),
            }
        }
        if !self.has_needed(part, &given, raw.name.clone()) {
            return None;
        }
        let is_label = part.name == "label";
        let (names, inside): (Vec<RawChild>, Vec<RawChild>) = raw
            .children
            .into_iter()
            .partition(|child| matches!(child, RawChild::Element(inner) if self.source(&inner.name) == "title"));
        if !names.is_empty() {
            self.children(&mut element, names);
        } else if !is_label {
            let words = part.title.clone();
            element
                .children
                .push(Child::Element(title(vec![Piece::Literal(words.text(self.language()).into_owned())])));
            self.record_text(SceneText { generated: Some(words), ..SceneText::default() });
        }
        let mut drawn = self.draw_part(part, &given)?;
        // After the drawn elements: translations take the texts in this order.
        let mut further = Element { name: "g".to_owned(), attributes: Vec::new(), children: Vec::new(), drag: None };
        let holder = drawn.children.first_mut().filter(|_| is_label).unwrap_or(&mut further);
        self.children(holder, inside);
        Self::with_defaults(&drawn.defaults, &mut element.attributes);
        if !is_label {
            Self::with_defaults(&[("role", "img")], &mut element.attributes);
        }
        element.attributes.extend(visible);
        element.children.extend(drawn.children.into_iter().map(Child::Element));
        element.children.extend(further.children);
        element.drag = self.drag(dragging, Some(drawn.anchor));
        self.fits(size(&element), raw.name).then_some(element)
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
                        words!("`<{}>` cannot contain `<{}>`", element.name, self.source(&inner.name)),
                        inner.name,
                        None,
                    );
                }
                RawChild::Element(inner) => self.repeated(inner, &mut element.children),
                RawChild::Text(text) if matches!(element.name.as_str(), "text" | "tspan" | "title" | "desc") => {
                    element.children.extend(self.text(text).map(Child::Text));
                }
                RawChild::Text(text) => {
                    let text = crate::text::source::trim(self.expressions.source, text);
                    if !text.is_empty() {
                        self.refuse(words("text is shown inside `<text>` only"), text, None);
                    }
                }
            }
        }
    }
}

/// Number of elements and pieces of values of an element.
fn size(element: &Element) -> usize {
    let pieces: usize = element.attributes.iter().map(|attribute| attribute.value.len()).sum();
    let inner = element.children.iter().map(|child| match child {
        Child::Element(inner) => size(inner),
        Child::Text(text) => text.len(),
    });
    1 + pieces + inner.sum::<usize>()
}
