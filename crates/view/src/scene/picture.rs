//! A picture: SVG nodes built once from the tree of a scene. It shows the state of any [`Play`] passed to it, and
//! updates only the attributes and texts whose values have changed.

use crate::views::document as page;
use play::Play;
use program::{Child, Drag, Element, Piece, Scene, Template, write_attribute};
use wasm_bindgen::JsCast;
use web_sys::{ShadowRootInit, ShadowRootMode, SvgElement, Text};

const SVG: &str = "http://www.w3.org/2000/svg";

/// Nodes of a scene, and the values that they show.
pub struct Picture {
    root: SvgElement,
    bindings: Bindings,
    parts: Vec<Part>,
    /// Values drawn last.
    drawn: Vec<f64>,
    values: Vec<f64>,
    text: String,
}

/// Attributes and texts that depend on the model.
#[derive(Default)]
struct Bindings {
    attributes: Vec<Binding>,
    texts: Vec<Label>,
}

/// A draggable part.
pub struct Part {
    /// Its node.
    pub node: SvgElement,
    /// Its drag target.
    pub drag: Drag,
    /// Name from the document.
    pub name: Option<String>,
}

/// An attribute that depends on the model.
pub(crate) struct Binding {
    node: SvgElement,
    name: String,
    template: Template,
    /// Text shown now.
    shown: String,
}

/// A text that depends on the model.
struct Label {
    node: Text,
    template: Template,
    /// Text shown now.
    shown: String,
}

impl Picture {
    /// Builds the scene in `place`, an empty element.
    pub fn build(scene: &Scene, place: &web_sys::Element) -> Option<Self> {
        let (mut bindings, mut parts) = (Bindings::default(), Vec::new());
        let root = build(&scene.root, &mut bindings, &mut parts)?;
        let _ = root.set_attribute("part", "drawing");
        // A shadow tree isolates the styles of the document from those of the page.
        let shadow = place.attach_shadow(&ShadowRootInit::new(ShadowRootMode::Open)).ok()?;
        let _ = shadow.append_child(&root);
        Some(Self { root, bindings, parts, drawn: Vec::new(), values: Vec::new(), text: String::new() })
    }

    /// Its `svg`, which defines the user units of the document.
    pub fn root(&self) -> &SvgElement {
        &self.root
    }

    /// Takes the draggable parts; they have no listeners yet.
    pub fn take_parts(&mut self) -> Vec<Part> {
        std::mem::take(&mut self.parts)
    }

    /// Updates all nodes to the present state.
    pub fn draw(&mut self, play: &mut Play) {
        self.draw_shapes(play);
        self.draw_texts(play);
    }

    /// Updates all nodes except texts.
    pub fn draw_shapes(&mut self, play: &mut Play) {
        self.values.clear();
        self.values.extend_from_slice(play.scene().values());
        let (values, drawn) = (&self.values, &self.drawn);
        let changed = |index: usize| {
            values.get(index).map(|value| value.to_bits()) != drawn.get(index).map(|value| value.to_bits())
        };
        for binding in &mut self.bindings.attributes {
            if let [Piece::Trail(number)] = binding.template.as_slice() {
                play.scene().write_trail(*number, &mut self.text);
                binding.show(&self.text);
            } else if binding.template.iter().filter_map(Piece::value).any(changed) {
                binding.write(values, &mut self.text);
            }
        }
        std::mem::swap(&mut self.values, &mut self.drawn);
    }

    /// Updates the texts. Each changed text costs the browser a layout.
    pub fn draw_texts(&mut self, play: &mut Play) {
        for label in &mut self.bindings.texts {
            self.text.clear();
            for piece in &label.template {
                match piece {
                    Piece::Literal(literal) => self.text.push_str(literal),
                    Piece::Value { index, decimals } => self.text.push_str(&play.scene().text(*index, *decimals)),
                    Piece::Choice { .. } | Piece::Trail(_) => {}
                }
            }
            if self.text != label.shown {
                label.node.set_data(&self.text);
                label.shown.clone_from(&self.text);
            }
        }
    }
}

impl Binding {
    /// Writes an attribute for these values; does nothing if one of them is not a number.
    pub fn write(&mut self, values: &[f64], text: &mut String) {
        if write_attribute(&self.template, values, text) {
            self.show(text);
        }
    }

    fn show(&mut self, text: &str) {
        if text != self.shown {
            let _ = self.node.set_attribute(&self.name, text);
            text.clone_into(&mut self.shown);
        }
    }
}

/// Creates an SVG element without attributes.
pub(crate) fn node(name: &str) -> Option<SvgElement> {
    page().create_element_ns(Some(SVG), name).ok()?.dyn_into().ok()
}

/// Sets an attribute of a node, or binds it to the values that it depends on.
pub(crate) fn set_attribute(node: &SvgElement, attribute: &program::Attribute, bindings: &mut Vec<Binding>) {
    match fixed(&attribute.value) {
        Some(text) => drop(node.set_attribute(&attribute.name, &text)),
        None => bindings.push(Binding {
            node: node.clone(),
            name: attribute.name.clone(),
            template: attribute.value.clone(),
            shown: String::new(),
        }),
    }
}

fn build(element: &Element, bindings: &mut Bindings, parts: &mut Vec<Part>) -> Option<SvgElement> {
    let node = node(&element.name)?;
    for attribute in &element.attributes {
        set_attribute(&node, attribute, &mut bindings.attributes);
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
                    bindings.texts.push(Label { node: text, template: template.clone(), shown: String::new() });
                }
            }
        }
    }
    if let Some(drag) = &element.drag {
        // The `title` child is the accessible name; it is also the tooltip.
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

/// Text of a template without values; `None` if it contains values.
fn fixed(template: &Template) -> Option<String> {
    template
        .iter()
        .map(|piece| match piece {
            Piece::Literal(text) => Some(text.as_str()),
            Piece::Value { .. } | Piece::Choice { .. } | Piece::Trail(_) => None,
        })
        .collect()
}
