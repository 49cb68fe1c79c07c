//! Mouse, pen and finger on the canvas: a press selects an element, a drag moves it.

use super::acts;
use super::hand::Hand;
use super::held::Held;
use super::picture::Canvas;
use super::seen::{from_window, path_of};
use document::drawing::Grip;
use view::browser;
use wasm_bindgen::JsCast;
use web_sys::{Element, Event, Node, PointerEvent, TouchEvent};

/// Distance from an element within which it is hit, in CSS pixels: by finger, by mouse.
const MARGIN: [f64; 2] = [14.0, 5.0];

/// Handlers of pointer events.
#[derive(Clone)]
pub struct Pointing {
    /// Handle of the drawing views.
    pub hand: Hand,
    /// Picture on the canvas.
    pub canvas: Canvas,
}

impl Pointing {
    /// Prevents scrolling if the finger touches an element; elsewhere the page scrolls.
    pub fn touched(&self, event: &TouchEvent) {
        let Some(seen) = self.hand.seen.get_clone_untracked() else { return };
        let Some(touch) = event.changed_touches().get(0) else { return };
        let Some(at) = self.place(touch.client_x(), touch.client_y()) else { return };
        let means =
            gripped(event).is_some() || self.hit(event).is_some() || seen.near(at, MARGIN[0] * seen.pixel).is_some();
        if means && event.cancelable() {
            event.prevent_default();
        }
    }

    /// Handles a press: selects the element there and grabs it.
    pub fn begin(&self, event: &PointerEvent) {
        let hand = self.hand;
        let Some(seen) = hand.seen.get_clone_untracked() else { return };
        if event.button() != 0 || hand.held.get_untracked().is_some() {
            return;
        }
        let Some(at) = self.place(event.client_x(), event.client_y()) else { return };
        let margin = MARGIN[usize::from(event.pointer_type() == "mouse")] * seen.pixel;
        let grip = gripped(event).or_else(|| {
            let number = self.hit(event).or_else(|| seen.near(at, margin))?;
            // Pressing one of several selected elements moves them all.
            let moves_all = hand.chosen.with_untracked(|chosen| chosen.contains(&number));
            if !moves_all || event.shift_key() || event.ctrl_key() || event.meta_key() {
                hand.choose(event, number);
            }
            Some((number, Grip::Whole))
        });
        let Some(grip) = grip else {
            hand.pointed.set(Some(at));
            hand.chosen.set(Vec::new());
            return;
        };
        event.prevent_default();
        browser::focus_in_place("drawing-canvas");
        if let Some(node) = event.current_target().and_then(|node| node.dyn_into::<Element>().ok()) {
            let _ = node.set_pointer_capture(event.pointer_id());
        }
        hand.held.set(Some(Held { pointer: event.pointer_id(), grip, from: at, at, pixel: seen.pixel }));
    }

    /// Handles a moved pointer.
    pub fn follow(&self, event: &PointerEvent) {
        let Some(held) = self.held_by(event) else { return };
        if let Some(at) = self.place(event.client_x(), event.client_y()) {
            self.hand.held.set(Some(Held { at, ..held }));
        }
    }

    /// Handles a released pointer: changes the text.
    pub fn end(&self, event: &PointerEvent) {
        self.follow(event);
        let Some(held) = self.held_by(event) else { return };
        self.hand.held.set(None);
        if !held.is_moved() {
            self.hand.pointed.set(Some(held.at));
            return;
        }
        let (number, grip) = held.grip;
        let way = if grip == Grip::Turn { [self.turned(number, &held), 0.0] } else { held.way() };
        acts::move_by(self.hand, held.grip, way);
    }

    /// Converts a place in the window to picture units.
    fn place(&self, x: i32, y: i32) -> Option<[f64; 2]> {
        Some(from_window(&self.canvas.root()?)?.point([f64::from(x), f64::from(y)]))
    }

    fn held_by(&self, event: &PointerEvent) -> Option<Held> {
        self.hand.held.get_untracked().filter(|held| held.pointer == event.pointer_id())
    }

    /// Angle of the drag around the centre of an element, clockwise, in radians.
    fn turned(&self, number: usize, held: &Held) -> f64 {
        let seen = self.hand.seen.get_clone_untracked();
        let middle = seen.and_then(|seen| seen.items.get(number)?.as_ref()?.middle);
        let Some([x, y]) = middle else { return 0.0 };
        let angle = |[right, down]: [f64; 2]| libm::atan2(down - y, right - x);
        let turn = angle(held.at) - angle(held.from);
        // Reduced to the shorter way around.
        let around = std::f64::consts::TAU;
        turn - around * (turn / around).round()
    }

    /// Index of the element under the pointer: the innermost one that can be selected.
    fn hit(&self, event: &Event) -> Option<usize> {
        let root = self.canvas.root()?;
        let node: Node = event.composed_path().get(0).dyn_into().ok()?;
        let shadow: &Node = root.as_ref();
        if !shadow.contains(Some(&node)) {
            return None;
        }
        let path = path_of(&root, &node)?;
        let places = self.hand.app.read_desk(|desk| desk.drawing_places())?;
        let drawing = self.hand.drawing.get_clone_untracked()?;
        let mut best: Option<(usize, usize)> = None;
        for (number, place) in places.elements.iter().enumerate() {
            let is_frame = drawing.items.get(number).is_none_or(|item| item.is_frame());
            let Some(place) = place.as_ref().filter(|_| !is_frame) else { continue };
            let depth = place.paths.iter().filter(|own| path.starts_with(own)).map(Vec::len).max();
            if let Some(depth) = depth.filter(|depth| best.is_none_or(|(_, known)| *depth > known)) {
                best = Some((number, depth));
            }
        }
        best.map(|(number, _)| number)
    }
}

/// Grip under the pointer: (element index, grip).
fn gripped(event: &Event) -> Option<(usize, Grip)> {
    let node: Element = event.composed_path().get(0).dyn_into().ok()?;
    let name = node.closest("[data-grip]").ok()??.get_attribute("data-grip")?;
    let (number, name) = name.split_once(' ')?;
    let all = [Grip::Beginning, Grip::End, Grip::Corner, Grip::Edge, Grip::Turn];
    let grip = all.into_iter().find(|grip| format!("{grip:?}") == name)?;
    Some((number.parse().ok()?, grip))
}
