//! Where the elements of a scene come to stand while it is built, for those who draw by hand.

use super::{Space, Spot};
use program::NodeId;
use std::collections::BTreeMap;
use units::Dimension;

/// What is noted of a scene. Places in the text are where an element or the value of an attribute begins.
#[derive(Default)]
pub struct Marks {
    /// The elements, each copy by itself.
    pub elements: Vec<Marked>,
    /// Points and sizes, in units of the drawing.
    pub spots: BTreeMap<usize, Spot>,
    /// Coordinates, lengths and angles, in units of the drawing and radians.
    pub numbers: BTreeMap<usize, NodeId>,
    /// What stands in the first frame.
    pub ground: Option<Space>,
    /// The places among their neighbours of the elements that are being built, outermost first.
    pub path: Vec<usize>,
}

/// An element.
pub struct Marked {
    /// Where it begins.
    pub place: usize,
    /// Which child of which child of the `svg` it is; texts count.
    pub path: Vec<usize>,
    /// Units of the drawing for an SI unit of length, where it stands.
    pub scale: NodeId,
    /// What lengths are there.
    pub dimension: Dimension,
}
