//! Grips of elements for moving and resizing.

use super::item::Item;
use crate::scene::{ARC_RADIUS, BOB_RADIUS};

/// A grip of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grip {
    /// The whole element.
    Whole,
    /// Its beginning, attribute `from`.
    Beginning,
    /// Its end, attribute `to`.
    End,
    /// A corner; changes the size.
    Corner,
    /// A point on the edge; changes the radius.
    Edge,
    /// A point beside the element; turns it.
    Turn,
}

impl Item {
    /// Default radius of the element, in units of the drawing.
    pub(crate) fn usual_radius(&self) -> f64 {
        if self.kind.name == "angle" { ARC_RADIUS } else { BOB_RADIUS }
    }

    /// Grips of the element, the whole first. A frame has none; axes cannot be moved as a whole.
    pub fn grips(&self) -> Vec<Grip> {
        let has = |name: &str| self.attribute(name).is_some();
        let can = |name: &str| self.kind.attributes.contains(&name);
        if self.is_frame() {
            return Vec::new();
        }
        let mut grips = Vec::new();
        if self.kind.name != "axes" {
            grips.push(Grip::Whole);
        }
        // `from` and `to` of an angle's arc are angles, not points.
        if self.kind.name != "angle" && has("from") && has("to") || has("x1") && has("x2") {
            grips.extend([Grip::Beginning, Grip::End]);
        }
        if has("size") || self.kind.name == "rect" && has("width") && has("height") {
            grips.push(Grip::Corner);
        }
        if has("r") || can("r") && self.kind.name != "circle" {
            grips.push(Grip::Edge);
        }
        if can("turn") && (self.framed || self.kind.name != "g") {
            grips.push(Grip::Turn);
        }
        grips
    }
}
