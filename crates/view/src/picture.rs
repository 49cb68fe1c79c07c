//! A picture: SVG nodes made once from the tree of a scene. It follows whatever [`Play`] it is given, and sets only those
//! attributes and texts whose values have changed.

use crate::views::document as page;
use play::Play;
use program::{Child, Drag, Element, Piece, Scene, Template, write_attribute};
use wasm_bindgen::JsCast;
use web_sys::{ShadowRootInit, ShadowRootMode, SvgElement, Text};

const SVG: &str = "http://www.w3.org/2000/svg";

/// The nodes of a scene, and what they show.
pub struct Picture {
    root: SvgElement,
    bindings: Vec<Binding>,
    parts: Vec<Part>,
    /// The values drawn last.
    drawn: Vec<f64>,
    values: Vec<f64>,
    text: String,
}

/// A part that can be dragged.
pub struct Part {
    /// Its node.
    pub node: SvgElement,
    /// What moves it.
    pub drag: Drag,
    /// What the document calls it.
    pub name: Option<String>,
}

/// A node's attribute or text that follows the model.
pub(crate) struct Binding {
    target: Target,
    template: Template,
    /// What it shows.
    shown: String,
}

enum Target {
    Attribute(SvgElement, String),
    Text(Text),
}

impl Picture {
    /// Builds the scene into `place`, an element without content.
    pub fn build(scene: &Scene, place: &web_sys::Element) -> Option<Self> {
        let (mut bindings, mut parts) = (Vec::new(), Vec::new());
        let root = build(&scene.root, &mut bindings, &mut parts)?;
        let _ = root.set_attribute("part", "drawing");
        // A tree of its own: the document's styles stay in it, and the page's class names mean nothing there.
        let shadow = place.attach_shadow(&ShadowRootInit::new(ShadowRootMode::Open)).ok()?;
        let _ = shadow.append_child(&root);
        Some(Self { root, bindings, parts, drawn: Vec::new(), values: Vec::new(), text: String::new() })
    }

    /// Its `svg`, whose user units the document counts in.
    pub fn root(&self) -> &SvgElement {
        &self.root
    }

    /// The parts that can be dragged; nothing listens to them yet.
    pub fn take_parts(&mut self) -> Vec<Part> {
        std::mem::take(&mut self.parts)
    }

    /// Shows the present.
    pub fn draw(&mut self, play: &mut Play) {
        self.values.clear();
        self.values.extend_from_slice(play.scene_values());
        let (values, drawn) = (&self.values, &self.drawn);
        let changed = |index: usize| {
            values.get(index).map(|value| value.to_bits()) != drawn.get(index).map(|value| value.to_bits())
        };
        for binding in &mut self.bindings {
            let trail = match binding.template.as_slice() {
                [Piece::Trail(number)] => Some(*number),
                _ => None,
            };
            if trail.is_none() && !binding.template.iter().filter_map(Piece::value).any(changed) {
                continue;
            }
            match &binding.target {
                Target::Attribute(..) if trail.is_some() => {
                    trail.into_iter().for_each(|number| play.scene_trail(number, &mut self.text));
                }
                Target::Attribute(..) => {
                    if !write_attribute(&binding.template, values, &mut self.text) {
                        continue;
                    }
                }
                Target::Text(_) => {
                    self.text.clear();
                    for piece in &binding.template {
                        match piece {
                            Piece::Literal(literal) => self.text.push_str(literal),
                            Piece::Value { index, decimals } => {
                                self.text.push_str(&play.scene_text(*index, *decimals));
                            }
                            Piece::Choice { .. } | Piece::Trail(_) => {}
                        }
                    }
                }
            }
            binding.show(&self.text);
        }
        std::mem::swap(&mut self.values, &mut self.drawn);
    }
}

impl Binding {
    fn attribute(node: &SvgElement, name: &str, template: &Template) -> Self {
        let target = Target::Attribute(node.clone(), name.to_owned());
        Self { target, template: template.clone(), shown: String::new() }
    }

    /// Writes an attribute for these values; nothing where one of them is no number.
    pub fn write(&mut self, values: &[f64], text: &mut String) {
        if write_attribute(&self.template, values, text) {
            self.show(text);
        }
    }

    fn show(&mut self, text: &str) {
        if text == self.shown {
            return;
        }
        match &self.target {
            Target::Attribute(node, name) => drop(node.set_attribute(name, text)),
            Target::Text(node) => node.set_data(text),
        }
        text.clone_into(&mut self.shown);
    }
}

/// An element of a picture, without attributes.
pub(crate) fn node(name: &str) -> Option<SvgElement> {
    page().create_element_ns(Some(SVG), name).ok()?.dyn_into().ok()
}

/// Gives a node an attribute, or binds it to the values that it shows.
pub(crate) fn set_attribute(node: &SvgElement, attribute: &program::Attribute, bindings: &mut Vec<Binding>) {
    match fixed(&attribute.value) {
        Some(text) => drop(node.set_attribute(&attribute.name, &text)),
        None => bindings.push(Binding::attribute(node, &attribute.name, &attribute.value)),
    }
}

fn build(element: &Element, bindings: &mut Vec<Binding>, parts: &mut Vec<Part>) -> Option<SvgElement> {
    let node = node(&element.name)?;
    for attribute in &element.attributes {
        set_attribute(&node, attribute, bindings);
    }
    for child in &element.children {
        match child {
            Child::Element(child) => {
                if let Some(child) = build(child, bindings, parts) {
                    let _ = node.append_child(&child);
                }
            }
            Child::Text(template) => {
                let words = fixed(template);
                let text = page().create_text_node(words.as_deref().unwrap_or_default());
                let _ = node.append_child(&text);
                if words.is_none() {
                    let target = Target::Text(text);
                    bindings.push(Binding { target, template: template.clone(), shown: String::new() });
                }
            }
        }
    }
    if let Some(drag) = &element.drag {
        // Its `title` names it, as a tooltip does for those who see it.
        let named = |child: &Child| match child {
            Child::Element(title) if title.name == "title" => match title.children.as_slice() {
                [Child::Text(text)] => fixed(text),
                _ => None,
            },
            _ => None,
        };
        let name = element.children.iter().find_map(named);
        parts.push(Part { node: node.clone(), drag: drag.clone(), name });
    }
    Some(node)
}

/// The text of a template without values.
fn fixed(template: &Template) -> Option<String> {
    template
        .iter()
        .map(|piece| match piece {
            Piece::Literal(text) => Some(text.as_str()),
            Piece::Value { .. } | Piece::Choice { .. } | Piece::Trail(_) => None,
        })
        .collect()
}
