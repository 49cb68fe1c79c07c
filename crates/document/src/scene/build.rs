//! From elements as written to a scene: what is not allowed is left out, what is written in braces is compiled.

use super::allowed::{ATTRIBUTES, ELEMENTS, REFERRING, danger, is_id, is_idle, reference};
use super::style::{PREFIX, SCENE_CLASS, confine};
use super::template::{self, RawPiece, normalised};
use super::xml::{RawChild, RawElement, parse};
use super::{Attribute, Child, Drag, Element, Piece, Scene, Template};
use crate::expressions::{Expressions, dimension_error};
use crate::translation::Texts;
use model::{Compiled, Diagnostic, Kind, Span};
use std::collections::BTreeSet;
use std::ops::Range;

/// How many values a scene may have; all of them are computed for every frame.
const VALUES: usize = 1_000;

/// Reads the scene in `range`: definitions, then one `svg` element. Its texts are looked up in `texts`.
pub fn build(
    expressions: &mut Expressions,
    range: Range<usize>,
    texts: &mut Texts,
) -> Option<Scene> {
    let source = expressions.source;
    let opening = Span::new(range.start, range.start);
    let Some(length) = source[range.clone()].find("<svg") else {
        expressions.diagnostics.push(
            Diagnostic::error("scene-syntax", "a scene needs a drawing", opening)
                .with_hint("begin it with `<svg viewBox=\"0 0 400 300\">`"),
        );
        return None;
    };
    let start = range.start + length;
    expressions.define(range.start..start);
    let children = parse(source, start..range.end, &mut expressions.diagnostics);
    let mut builder = Builder {
        expressions,
        texts,
        values: Vec::new(),
        ids: BTreeSet::new(),
        references: Vec::new(),
    };
    builder.collect_ids(&children);
    let mut root = None;
    for child in children {
        match child {
            RawChild::Element(element) if root.is_none() => root = builder.root(element),
            RawChild::Element(element) => {
                builder.refuse("a scene is one `svg` element", element.name, None)
            }
            RawChild::Text(text) => {
                let text = crate::source::trim(source, text);
                if !text.is_empty() {
                    builder.refuse("this text stands outside the drawing", text, None);
                }
            }
        }
    }
    builder.check_references();
    let values = builder.values;
    expressions.forget();
    Some(Scene {
        root: root?,
        values,
    })
}

struct Builder<'b, 'a> {
    expressions: &'b mut Expressions<'a>,
    texts: &'b mut Texts,
    values: Vec<Compiled>,
    ids: BTreeSet<String>,
    references: Vec<(String, Range<usize>)>,
}

impl Builder<'_, '_> {
    fn source(&self, range: &Range<usize>) -> &str {
        &self.expressions.source[range.clone()]
    }

    fn refuse(&mut self, message: impl Into<String>, range: Range<usize>, hint: Option<&str>) {
        let mut diagnostic =
            Diagnostic::error("scene-refused", message, Span::new(range.start, range.end));
        diagnostic.hints.extend(hint.map(str::to_owned));
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
                            format!("`{id}` cannot be an id"),
                            place,
                            Some("use letters, digits, `-` and `_`"),
                        );
                    } else if !self.ids.insert(id.clone()) {
                        self.refuse(format!("the id `{id}` is used twice"), place, None);
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
                    format!("nothing in the scene has the id `{id}`"),
                    place,
                    None,
                );
            }
        }
    }

    fn root(&mut self, raw: RawElement) -> Option<Element> {
        if self.source(&raw.name) != "svg" {
            self.refuse("a scene is one `svg` element", raw.name, None);
            return None;
        }
        let name = raw.name.clone();
        let mut root = self.element(raw)?;
        if !root
            .attributes
            .iter()
            .any(|attribute| attribute.name == "viewBox")
        {
            self.refuse(
                "the `svg` element needs a `viewBox`",
                name,
                Some("`viewBox=\"0 0 400 300\"` gives the drawing 400 by 300 units"),
            );
        }
        let scene = || vec![Piece::Literal(SCENE_CLASS.to_owned())];
        match root
            .attributes
            .iter_mut()
            .find(|attribute| attribute.name == "class")
        {
            Some(class) => class
                .value
                .splice(0..0, [Piece::Literal(format!("{SCENE_CLASS} "))])
                .for_each(drop),
            None => root.attributes.insert(
                0,
                Attribute {
                    name: "class".to_owned(),
                    value: scene(),
                },
            ),
        }
        Some(root)
    }

    fn element(&mut self, raw: RawElement) -> Option<Element> {
        let name = self.source(&raw.name).to_owned();
        if !ELEMENTS.contains(&name.as_str()) {
            let hint =
                crate::near::nearest(&name, ELEMENTS).map(|near| format!("did you mean `{near}`?"));
            self.refuse(
                format!("a scene cannot contain `<{name}>`; it is left out with what it holds"),
                raw.name,
                hint.as_deref(),
            );
            return None;
        }
        let mut element = Element {
            name,
            attributes: Vec::new(),
            children: Vec::new(),
            drag: None,
        };
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
                    let confined = confine(
                        self.expressions.source,
                        text,
                        &mut self.expressions.diagnostics,
                    );
                    element
                        .children
                        .push(Child::Text(vec![Piece::Literal(confined)]));
                }
                RawChild::Element(inner)
                    if element.name == "style" || self.source(&inner.name) == "svg" =>
                {
                    self.refuse(
                        format!(
                            "`<{}>` cannot contain `<{}>`",
                            element.name,
                            self.source(&inner.name)
                        ),
                        inner.name,
                        None,
                    );
                }
                RawChild::Element(inner) => element
                    .children
                    .extend(self.element(inner).map(Child::Element)),
                RawChild::Text(text)
                    if matches!(element.name.as_str(), "text" | "tspan" | "title" | "desc") =>
                {
                    element.children.extend(self.text(text).map(Child::Text));
                }
                RawChild::Text(text) => {
                    let text = crate::source::trim(self.expressions.source, text);
                    if !text.is_empty() {
                        self.refuse("text is shown inside `<text>` only", text, None);
                    }
                }
            }
        }
        Some(element)
    }

    fn attribute(&mut self, name: Range<usize>, value: Range<usize>) -> Option<Attribute> {
        let text = self.source(&name).to_owned();
        if is_idle(&text) {
            return None;
        }
        if !ATTRIBUTES.contains(&text.as_str()) {
            let hint = match text.as_str() {
                "style" => Some(
                    "write the properties as attributes, `fill=\"red\"`, or in a `<style>`"
                        .to_owned(),
                ),
                "href" | "xlink:href" => {
                    Some("a scene refers to nothing outside itself".to_owned())
                }
                _ => crate::near::nearest(&text, ATTRIBUTES)
                    .map(|near| format!("did you mean `{near}`?")),
            };
            self.refuse(
                format!("the attribute `{text}` is not allowed in a scene; it is left out"),
                name,
                hint.as_deref(),
            );
            return None;
        }
        let raw = template::split(
            self.expressions.source,
            value.clone(),
            &mut self.expressions.diagnostics,
        );
        if let [RawPiece::Literal(literal)] = &raw[..]
            && let Some(id) = reference(literal)
            && REFERRING.contains(&text.as_str())
        {
            self.references.push((id.to_owned(), value));
            return Some(Attribute {
                name: text,
                value: vec![Piece::Literal(format!("url(#{PREFIX}{id})"))],
            });
        }
        let literals: String = raw
            .iter()
            .filter_map(|piece| match piece {
                RawPiece::Literal(literal) => Some(literal.as_str()),
                RawPiece::Placeholder { .. } => None,
            })
            .collect();
        if let Some(word) = danger(&literals) {
            let hint = REFERRING.contains(&text.as_str()).then_some(
                "only `url(#id)` with the id of an element of this scene can stand here",
            );
            self.refuse(
                format!("`{word}` is not allowed in a scene; `{text}` is left out"),
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
        let value = raw
            .into_iter()
            .map(|piece| self.piece(piece, true))
            .collect::<Option<Template>>()?;
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
            self.refuse(
                format!("`{name}` cannot hold values of the model"),
                place,
                None,
            );
            return None;
        }
        let text = if name == "id" {
            is_id(&text).then(|| format!("{PREFIX}{text}"))?
        } else {
            let names = || text.split_whitespace();
            let known: Vec<String> = names().filter(|name| is_id(name)).map(|name| format!("{PREFIX}{name}")).collect();
            if known.len() < names().count() {
                self.refuse(
                    format!("`{text}` is not a list of class names"),
                    place,
                    None,
                );
            }
            known.join(" ")
        };
        Some(Attribute {
            name,
            value: vec![Piece::Literal(text)],
        })
    }

    /// A text, in the language asked for.
    fn text(&mut self, range: Range<usize>) -> Option<Template> {
        let raw = template::split(
            self.expressions.source,
            range.clone(),
            &mut self.expressions.diagnostics,
        );
        let original: Option<Template> = raw
            .iter()
            .cloned()
            .map(|piece| self.piece(piece, false))
            .collect();
        let mut original = original?;
        let key = normalised(self.source(&range));
        if key.is_empty() {
            return (!original.is_empty()).then_some(original);
        }
        let has_words = raw
            .iter()
            .any(|piece| matches!(piece, RawPiece::Literal(text) if has_word(text)));
        let Some((translated, span)) = self.texts.translate(&key, has_words) else {
            return Some(original);
        };
        // Each value of the translation must be one of the original, written the same way.
        let mut scratch = Vec::new();
        let template = template::split(&translated, 0..translated.len(), &mut scratch)
            .into_iter()
            .map(|piece| match piece {
                RawPiece::Literal(text) => Some(Piece::Literal(text)),
                RawPiece::Placeholder {
                    expression,
                    decimals,
                } => {
                    let wanted = translated[expression].trim();
                    raw.iter()
                        .zip(&original)
                        .find_map(|(raw, piece)| match (raw, piece) {
                            (
                                RawPiece::Placeholder { expression, .. },
                                Piece::Value { index, .. },
                            ) if self.source(expression).trim() == wanted => Some(Piece::Value {
                                index: *index,
                                decimals,
                            }),
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

    fn piece(&mut self, piece: RawPiece, in_attribute: bool) -> Option<Piece> {
        let RawPiece::Placeholder {
            expression,
            decimals,
        } = piece
        else {
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
    fn value(&mut self, compiled: Compiled) -> Option<usize> {
        let known = self.values.iter().position(|value| {
            value.node == compiled.node
                && value.unit == compiled.unit
                && value.kind == compiled.kind
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

    fn drag(&mut self, dragging: Dragging) -> Option<Drag> {
        let Some(place) = dragging.state else {
            if let Some(place) = dragging.up.or(dragging.right) {
                self.refuse(
                    "what does the pointer change?",
                    place,
                    Some("name a state: `drag=\"y\" drag-up=\"0.01 [m]\"`"),
                );
            }
            return None;
        };
        let place = crate::source::trim(self.expressions.source, place);
        let name = self.source(&place).to_owned();
        let states: Vec<String> = self
            .expressions
            .model
            .states
            .iter()
            .map(model::State::name)
            .collect();
        let Some(state) = states.iter().position(|known| *known == name) else {
            let mut hint = format!("the states are {}", states.join(", "));
            if let Some(near) = crate::near::nearest(&name, states.iter().map(String::as_str)) {
                hint = format!("did you mean `{near}`?");
            }
            self.refuse(
                format!("`{name}` is not a state, so it cannot be dragged"),
                place,
                Some(&hint),
            );
            return None;
        };
        if dragging.up.is_none() && dragging.right.is_none() {
            self.refuse(
                "dragging needs `drag-up`, `drag-right` or both",
                place,
                Some("`drag-up=\"0.01 [m]\"` is what one unit upwards adds"),
            );
            return None;
        }
        let up = dragging.up.and_then(|range| self.drag_rate(range, state));
        let right = dragging
            .right
            .and_then(|range| self.drag_rate(range, state));
        (up.is_some() || right.is_some()).then_some(Drag { state, up, right })
    }

    /// What one unit of the drawing adds to a state.
    fn drag_rate(&mut self, range: Range<usize>, state: usize) -> Option<usize> {
        let rate = self.expressions.number(range)?;
        let state = &self.expressions.model.states[state];
        if rate.dimension() != state.unit.dimension {
            let message = format!(
                "one unit of the drawing must add to `{}` something of its dimension",
                state.name()
            );
            let expected = (state.span, state.unit.dimension);
            self.expressions.diagnostics.push(dimension_error(
                message,
                (rate.span, rate.dimension()),
                expected,
            ));
            return None;
        }
        self.value(rate)
    }
}

/// Where the values of the attributes for dragging stand.
#[derive(Default)]
struct Dragging {
    state: Option<Range<usize>>,
    up: Option<Range<usize>>,
    right: Option<Range<usize>>,
}

/// Whether a text has something to translate.
pub fn has_word(text: &str) -> bool {
    text.split(|c: char| !c.is_alphabetic())
        .any(|word| word.chars().count() > 2)
}
