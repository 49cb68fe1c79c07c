//! The scene of the page: the picture of the simulation with draggable handles, the outline of measured positions, and
//! a ruler.
//!
//! `picture.rs` has the SVG nodes of a scene. A `Picture` follows whatever `Play` it is given and needs no `App`. While the
//! run plays, shapes and plots follow every frame, texts ten times a second: each text that differs costs the browser a
//! layout. `grip.rs` drags handles of the scene and prevents scrolling there.

mod drag;
pub(crate) mod drawings;
mod grip;
pub mod picture;

use crate::app::App;
use crate::scene::grip::Grips;
use crate::stage::ruler::Ruler;
use drag::Handle;
use picture::{Binding, Picture};
use play::{Follows, Play};
use program::{Child, Element, Piece, Scene};
use wasm_bindgen::JsCast;
use web_sys::{SvgElement, SvgGraphicsElement};

/// Nodes of a scene.
pub struct SceneNodes {
    picture: Picture,
    handles: Vec<Handle>,
    /// Keeps the listeners of the handles alive.
    _grips: Grips,
    outline: Outline,
    /// The ruler on the scene, if any.
    pub ruler: Option<Ruler>,
    root: SvgGraphicsElement,
}

impl SceneNodes {
    /// Builds the scene in `place`.
    pub fn build(app: App, scene: &Scene, place: &web_sys::Element, label: &str) -> Option<Self> {
        let mut picture = Picture::build(scene, place)?;
        let root: SvgGraphicsElement = picture.root().clone().dyn_into().ok()?;
        let _ = root.set_attribute("role", "group");
        let _ = root.set_attribute("aria-label", label);
        let mut handles: Vec<Handle> =
            picture.take_parts().into_iter().map(|part| Handle::new(part.node, part.drag, part.name)).collect();
        Handle::number_unnamed(&mut handles);
        if app.host().embedding().locked {
            handles.clear();
        }
        for handle in &mut handles {
            drag::attach(app, handle, &root);
        }
        let grips = Grips::new(app, root.clone(), handles.iter().map(Handle::part).collect());
        let outline = Outline { place: Some((scene.clone(), picture.root().clone())), ..Outline::default() };
        Some(Self { picture, handles, _grips: grips, outline, ruler: None, root })
    }

    /// The SVG root of the drawing.
    pub fn root(&self) -> SvgGraphicsElement {
        self.root.clone()
    }

    /// Node of a handle, in the order of the drawing.
    pub fn handle(&self, index: usize) -> Option<SvgElement> {
        self.handles.get(index).map(|handle| handle.part().0)
    }

    /// Updates the scene to the present state; its texts only if `values` is true.
    pub fn draw(&mut self, play: &mut Play, values: bool) {
        self.picture.draw_shapes(play);
        if values {
            self.picture.draw_texts(play);
        }
        for handle in &mut self.handles {
            handle.describe(play);
        }
        self.outline.draw(play);
        if let Some(ruler) = &self.ruler {
            ruler.draw(play);
        }
    }
}

/// Outline of measured positions over the scene: the parts that depend on measured values only.
#[derive(Default)]
struct Outline {
    /// The scene and its node.
    place: Option<(Scene, SvgElement)>,
    /// Sources of its values when it was built.
    follows: Vec<Follows>,
    node: Option<SvgElement>,
    bindings: Vec<Binding>,
    text: String,
}

impl Outline {
    fn draw(&mut self, play: &mut Play) {
        let follows = play.values().outline().map_or(&[][..], |outline| &outline.follows);
        if self.follows != follows {
            self.follows = follows.to_vec();
            self.build();
        }
        let Some(node) = &self.node else { return };
        let values = play.values().outline().and_then(|outline| outline.values.as_ref());
        let _ = if values.is_some() { node.remove_attribute("display") } else { node.set_attribute("display", "none") };
        let Some(values) = values else { return };
        for binding in &mut self.bindings {
            binding.write(values, &mut self.text);
        }
    }

    /// Builds the nodes for the present measurements.
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
            // On top of the drawing, but pointers pass through it to the handles.
            let _ = root.append_child(&node);
            self.node = Some(node);
        }
    }

    /// Copies, with tag `name`, the parts of an element that move with the measurement; `None` if there are none.
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
        let node = picture::node(name)?;
        // The id stays with the original.
        for attribute in element.attributes.iter().filter(|one| name == element.name && one.name != "id") {
            picture::set_attribute(&node, attribute, &mut self.bindings);
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
