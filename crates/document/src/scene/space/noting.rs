//! Records the places of elements while a scene is built.

use super::marks::Marked;
use super::shapes::is_geometry;
use super::{Space, Spot};
use crate::scene::builder::Builder;
use program::NodeId;
use std::ops::Range;

impl Builder<'_, '_> {
    /// Begins the child with this index.
    pub fn enter(&mut self, number: usize) {
        if let Some(marks) = &mut self.marks {
            marks.path.push(number);
        }
    }

    /// Ends the current child, and records it if it was built.
    pub fn leave(&mut self, place: usize, is_built: bool) {
        let (scale, dimension) = (self.space.scale, self.space.dimension);
        if let Some(marks) = &mut self.marks {
            if is_built {
                marks.elements.push(Marked { place, path: marks.path.clone(), scale, dimension });
            }
            marks.path.pop();
        }
    }

    /// Records the coordinate system of the first frame.
    pub fn note_frame(&mut self, space: &Space) {
        if let Some(marks) = &mut self.marks {
            marks.ground.get_or_insert_with(|| space.clone());
        }
    }

    /// Records a point or a size; for a repeated element, that of the first copy.
    pub fn note_spot(&mut self, place: usize, spot: Spot) {
        if let Some(marks) = &mut self.marks {
            marks.spots.entry(place).or_insert(spot);
        }
    }

    /// Records a coordinate, a length or an angle.
    pub fn note_number(&mut self, place: usize, node: NodeId) {
        if let Some(marks) = &mut self.marks {
            marks.numbers.entry(place).or_insert(node);
        }
    }

    /// Records the coordinates and lengths of an element outside frames, whose attributes are texts with values.
    pub fn note_plain(&mut self, element: &str, attributes: &[(Range<usize>, Range<usize>)]) {
        if self.marks.is_none() || self.space.framed {
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
