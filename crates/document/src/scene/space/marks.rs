//! Places of the elements of a scene in the picture, for graphical editing.

use super::{Space, Spot};
use program::NodeId;
use std::collections::BTreeMap;
use units::Dimension;

/// Recorded places of a scene. Keys are the bytes at which an element or the value of an attribute begins.
#[derive(Default)]
pub struct Marks {
    /// Elements; each copy has an entry.
    elements: Vec<Marked>,
    /// Points and sizes, in units of the drawing.
    spots: BTreeMap<usize, Spot>,
    /// Coordinates and lengths in units of the drawing, angles in radians.
    numbers: BTreeMap<usize, NodeId>,
    /// Coordinate system of the first frame.
    ground: Option<Space>,
    /// Child indices of the open elements, outermost first.
    path: Vec<usize>,
}

impl Marks {
    /// Begins the child with this index.
    pub(super) fn enter(&mut self, child: usize) {
        self.path.push(child);
    }

    /// Ends the current child, which began at the byte `place`, and records it if it was built in the coordinates of `space`.
    pub(super) fn leave(&mut self, place: usize, space: Option<&Space>) {
        let mark =
            |space: &Space| Marked { place, path: self.path.clone(), scale: space.scale, dimension: space.dimension };
        self.elements.extend(space.map(mark));
        self.path.pop();
    }

    /// Records the coordinate system of a frame, if it is the first one.
    pub(super) fn note_frame(&mut self, space: &Space) {
        self.ground.get_or_insert_with(|| space.clone());
    }

    /// Records a point or a size, in units of the drawing; of copies the first.
    pub(super) fn note_spot(&mut self, place: usize, spot: Spot) {
        self.spots.entry(place).or_insert(spot);
    }

    /// Records a coordinate or a length in units of the drawing, or an angle in radians; of copies the first.
    pub(super) fn note_number(&mut self, place: usize, node: NodeId) {
        self.numbers.entry(place).or_insert(node);
    }

    /// The copies of the element that begins at the byte `place`.
    pub fn copies(&self, place: usize) -> impl Iterator<Item = &Marked> {
        self.elements.iter().filter(move |marked| marked.place == place)
    }

    /// The point or the size of an attribute whose value begins at the byte `place`, in units of the drawing.
    pub fn spot(&self, place: usize) -> Option<Spot> {
        self.spots.get(&place).copied()
    }

    /// The number of an attribute whose value begins at the byte `place`: in units of the drawing, or in radians.
    pub fn number(&self, place: usize) -> Option<NodeId> {
        self.numbers.get(&place).copied()
    }

    /// Coordinate system of the first frame.
    pub fn ground(&self) -> Option<&Space> {
        self.ground.as_ref()
    }
}

/// A recorded element.
pub struct Marked {
    /// Byte at which it begins.
    pub place: usize,
    /// Path of child indices from the `svg` element; text nodes count as children.
    pub path: Vec<usize>,
    /// Units of the drawing per SI unit of length at its place.
    pub scale: NodeId,
    /// Dimension of lengths at its place.
    pub dimension: Dimension,
}
