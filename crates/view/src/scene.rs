//! The scene: SVG nodes made once from the document's tree. In a frame only those attributes and texts are set whose
//! values have changed.

use crate::app::App;
use crate::drag::{self, Handle};
use crate::grip::Grips;
use crate::stage::ruler::Ruler;
use crate::views::document as page;
use play::{Follows, Play};
use program::{Child, Element, Piece, Scene, Template, write_attribute};
use wasm_bindgen::JsCast;
use web_sys::{ShadowRootInit, ShadowRootMode, SvgElement, SvgGraphicsElement, Text};

const SVG: &str = "http://www.w3.org/2000/svg";

/// The nodes of a scene.
pub struct SceneNodes {
    bindings: Vec<Binding>,
    handles: Vec<Handle>,
    grips: Option<Grips>,
    outline: Outline,
    /// The ruler that lies on it.
    pub ruler: Option<Ruler>,
    root: Option<SvgGraphicsElement>,
    /// The values drawn last.
    drawn: Vec<f64>,
    values: Vec<f64>,
    text: String,
}

/// A node's attribute or text that follows the model.
struct Binding {
    target: Target,
    template: Template,
    /// What it shows.
    shown: String,
}

enum Target {
    Attribute(SvgElement, String),
    Text(Text),
}

impl SceneNodes {
    /// Builds the scene into `place`.
    pub fn build(app: App, scene: &Scene, place: &web_sys::Element, label: &str) -> Option<Self> {
        let mut nodes = Self {
            bindings: Vec::new(),
            handles: Vec::new(),
            grips: None,
            outline: Outline::default(),
            ruler: None,
            root: None,
            drawn: Vec::new(),
            values: Vec::new(),
            text: String::new(),
        };
        let root = nodes.element(&scene.root)?;
        let _ = root.set_attribute("role", "group");
        let _ = root.set_attribute("aria-label", label);
        let _ = root.set_attribute("part", "drawing");
        // A tree of its own: the document's styles stay in it, and the page's class names mean nothing there.
        let shadow = place.attach_shadow(&ShadowRootInit::new(ShadowRootMode::Open)).ok()?;
        let _ = shadow.append_child(&root);
        nodes.outline.place = Some((scene.clone(), root.clone()));
        let root: SvgGraphicsElement = root.dyn_into().ok()?;
        Handle::number_unnamed(&mut nodes.handles);
        for handle in &mut nodes.handles {
            drag::attach(app, handle, &root);
        }
        nodes.root = Some(root.clone());
        nodes.grips = Some(Grips::new(app, root, nodes.handles.iter().map(Handle::part).collect()));
        Some(nodes)
    }

    fn element(&mut self, element: &Element) -> Option<SvgElement> {
        let node: SvgElement = page().create_element_ns(Some(SVG), &element.name).ok()?.dyn_into().ok()?;
        for attribute in &element.attributes {
            match fixed(&attribute.value) {
                Some(text) => drop(node.set_attribute(&attribute.name, &text)),
                None => {
                    let target = Target::Attribute(node.clone(), attribute.name.clone());
                    self.bindings.push(Binding { target, template: attribute.value.clone(), shown: String::new() });
                }
            }
        }
        for child in &element.children {
            match child {
                Child::Element(child) => {
                    if let Some(child) = self.element(child) {
                        let _ = node.append_child(&child);
                    }
                }
                Child::Text(template) => {
                    let text = page().create_text_node(&fixed(template).unwrap_or_default());
                    let _ = node.append_child(&text);
                    if fixed(template).is_none() {
                        self.bindings.push(Binding {
                            target: Target::Text(text),
                            template: template.clone(),
                            shown: String::new(),
                        });
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
            self.handles.push(Handle::new(node.clone(), drag.clone(), name));
        }
        Some(node)
    }

    /// The drawing.
    pub fn root(&self) -> Option<SvgGraphicsElement> {
        self.root.clone()
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
            if self.text != binding.shown {
                match &binding.target {
                    Target::Attribute(node, name) => drop(node.set_attribute(name, &self.text)),
                    Target::Text(node) => node.set_data(&self.text),
                }
                self.text.clone_into(&mut binding.shown);
            }
        }
        for handle in &mut self.handles {
            handle.describe(play);
        }
        std::mem::swap(&mut self.values, &mut self.drawn);
        self.outline.draw(play);
        if let Some(ruler) = &self.ruler {
            ruler.draw(play);
        }
    }
}

/// What is measured of the scene, in outline over it: those parts that follow nothing but measured positions.
#[derive(Default)]
struct Outline {
    /// The scene and its node.
    place: Option<(Scene, SvgElement)>,
    /// What its values followed when it was built.
    follows: Vec<Follows>,
    node: Option<SvgElement>,
    bindings: Vec<Binding>,
}

impl Outline {
    fn draw(&mut self, play: &mut Play) {
        let follows = play.outline().map_or(&[][..], |outline| &outline.follows);
        if self.follows != follows {
            self.follows = follows.to_vec();
            self.build();
        }
        let Some(node) = &self.node else { return };
        let values = play.outline().and_then(|outline| outline.values.as_ref());
        let _ = if values.is_some() { node.remove_attribute("display") } else { node.set_attribute("display", "none") };
        for binding in &mut self.bindings {
            let (Some(values), Target::Attribute(node, name)) = (values, &binding.target) else { continue };
            let mut text = String::new();
            if write_attribute(&binding.template, values, &mut text) && text != binding.shown {
                let _ = node.set_attribute(name, &text);
                binding.shown = text;
            }
        }
    }

    /// Builds its nodes for what is measured now.
    fn build(&mut self) {
        self.bindings.clear();
        if let Some(node) = self.node.take() {
            node.remove();
        }
        let follows = self.follows.clone();
        let Some((scene, root)) = self.place.clone().filter(|_| !follows.is_empty()) else { return };
        if let Some(node) = self.copy(&scene.root, &follows, "g") {
            let _ = node.set_attribute("aria-hidden", "true");
            let _ = node.set_attribute("pointer-events", "none");
            // The handles stay on top, so that they can be grabbed.
            let _ = root.append_child(&node);
            self.node = Some(node);
        }
    }

    /// A copy, called `name`, of those parts of an element that move with the measurement; none if there are none.
    fn copy(&mut self, element: &Element, follows: &[Follows], name: &str) -> Option<SvgElement> {
        if matches!(element.name.as_str(), "defs" | "clipPath" | "style" | "title" | "text") {
            return None;
        }
        let any = |what: Follows| {
            let uses = |piece: &Piece| piece.value().is_some_and(|index| follows.get(index) == Some(&what));
            element.attributes.iter().any(|attribute| attribute.value.iter().any(uses))
        };
        let moves = any(Follows::Measured) && !any(Follows::Computed);
        let is_group = matches!(element.name.as_str(), "g" | "svg");
        let children: Vec<SvgElement> = element
            .children
            .iter()
            .filter_map(|child| match child {
                Child::Element(child) if is_group => self.copy(child, follows, &child.name),
                _ => None,
            })
            .collect();
        if children.is_empty() && (!moves || is_group) {
            return None;
        }
        let node: SvgElement = page().create_element_ns(Some(SVG), name).ok()?.dyn_into().ok()?;
        for attribute in element.attributes.iter().filter(|_| name == element.name) {
            match fixed(&attribute.value) {
                Some(text) if attribute.name != "id" => drop(node.set_attribute(&attribute.name, &text)),
                Some(_) => {}
                None => self.bindings.push(Binding {
                    target: Target::Attribute(node.clone(), attribute.name.clone()),
                    template: attribute.value.clone(),
                    shown: String::new(),
                }),
            }
        }
        if children.is_empty() {
            let _ = node.set_attribute("part", "measured");
        }
        for child in children {
            let _ = node.append_child(&child);
        }
        Some(node)
    }
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
