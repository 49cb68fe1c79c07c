//! Records the places of elements while a scene is built.

use super::shapes::is_geometry;
use super::{Space, Spot};
use crate::scene::builder::Builder;
use program::NodeId;
use std::ops::Range;

impl Builder<'_, '_> {
    /// Begins the child with this index.
    pub fn enter(&mut self, child: usize) {
        if let Some(marks) = &mut self.marks {
            marks.enter(child);
        }
    }

    /// Ends the current child, which began at the byte `place`, and records it if it was built.
    pub fn leave(&mut self, place: usize, is_built: bool) {
        let space = self.space().clone();
        if let Some(marks) = &mut self.marks {
            marks.leave(place, is_built.then_some(&space));
        }
    }

    /// Records the coordinate system of the first frame.
    pub fn note_frame(&mut self, space: &Space) {
        if let Some(marks) = &mut self.marks {
            marks.note_frame(space);
        }
    }

    /// Records a point or a size; for a repeated element, that of the first copy.
    pub fn note_spot(&mut self, place: usize, spot: Spot) {
        if let Some(marks) = &mut self.marks {
            marks.note_spot(place, spot);
        }
    }

    /// Records a coordinate, a length or an angle.
    pub fn note_number(&mut self, place: usize, node: NodeId) {
        if let Some(marks) = &mut self.marks {
            marks.note_number(place, node);
        }
    }

    /// Records the coordinates and lengths of an element outside frames, whose attributes are texts with values.
    pub fn note_plain(&mut self, element: &str, attributes: &[(Range<usize>, Range<usize>)]) {
        if self.marks.is_none() || self.space().framed {
            return;
        }
        for (name, value) in attributes {
            let name = self.source(name);
            let is_number = !matches!(name, "points" | "d" | "at" | "from" | "to" | "size" | "turn");
            if is_number
                && is_geometry(element, name)
                && let Some(node) = self.coordinate(value.clone())
            {
                self.note_number(value.start, node);
            }
        }
    }
}
