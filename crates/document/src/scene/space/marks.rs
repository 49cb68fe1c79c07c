//! Places of the elements of a scene in the picture, for graphical editing.

use super::{Space, Spot};
use program::NodeId;
use std::collections::BTreeMap;
use units::Dimension;

/// Recorded places of a scene. Keys are the bytes at which an element or the value of an attribute begins.
#[derive(Default)]
pub struct Marks {
    /// Elements; each copy has an entry.
    pub elements: Vec<Marked>,
    /// Points and sizes, in units of the drawing.
    pub spots: BTreeMap<usize, Spot>,
    /// Coordinates and lengths in units of the drawing, angles in radians.
    pub numbers: BTreeMap<usize, NodeId>,
    /// Coordinate system of the first frame.
    pub ground: Option<Space>,
    /// Child indices of the open elements, outermost first.
    pub path: Vec<usize>,
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
