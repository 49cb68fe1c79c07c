//! What of an element can be gripped and moved.

use super::item::Item;
use crate::scene::{ARC_RADIUS, BOB_RADIUS};

/// A place of an element that can be gripped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grip {
    /// All of it.
    Whole,
    /// Its beginning, the attribute `from`.
    Beginning,
    /// Its end, the attribute `to`.
    End,
    /// A corner, which changes its size.
    Corner,
    /// A place on its edge, which changes its radius.
    Edge,
    /// A place beside it, which turns it.
    Turn,
}

impl Item {
    /// The radius with which it is drawn where none is written, in units of the drawing.
    pub(crate) fn usual_radius(&self) -> f64 {
        if self.kind.name == "angle" { ARC_RADIUS } else { BOB_RADIUS }
    }

    /// What can be gripped of it, all of it first. A frame and axes stay where they are.
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
        // The ends of an angle's arc are angles.
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
