//! Coordinate systems: position of a point of the problem in the drawing. Outside a `<frame>`, coordinates are those of the
//! drawing.

pub(in crate::scene) mod frame;
pub(in crate::scene) mod marks;
pub(in crate::scene) mod measures;
pub(in crate::scene) mod noting;
pub(in crate::scene) mod points;
pub(in crate::scene) mod shapes;

use model::Span;
use program::{Graph, NodeId, Unary};
use units::Dimension;

/// A coordinate system.
#[derive(Clone, Debug)]
pub struct Space {
    /// Dimension of lengths.
    pub dimension: Dimension,
    /// Place where it is declared.
    pub declared: Span,
    /// Units of the drawing per SI unit.
    pub scale: NodeId,
    /// Position of the origin in the drawing.
    pub origin: Spot,
    /// True in a frame: y points up, and attributes hold expressions.
    pub framed: bool,
    /// Enclosing rotated groups, outermost first: position and angle in the drawing, clockwise in radians.
    pub turns: Vec<(Spot, NodeId)>,
}

/// A position in the drawing, in its units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spot {
    /// To the right.
    pub x: NodeId,
    /// Downwards.
    pub y: NodeId,
}

impl Space {
    /// Coordinate system of the drawing itself.
    pub fn drawing(graph: &mut Graph) -> Self {
        let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
        Self {
            dimension: Dimension::NONE,
            declared: Span::default(),
            scale: one,
            origin: Spot { x: zero, y: zero },
            framed: false,
            turns: Vec::new(),
        }
    }

    /// Coordinate system of a group at `place` in it, rotated clockwise by `angle` (radians), with its own `origin`.
    pub fn turned(&self, place: Spot, angle: NodeId, origin: Spot) -> Self {
        let turns = self.turns.iter().copied().chain([(place, angle)]).collect();
        Self { origin, turns, ..self.clone() }
    }

    /// A length in units of the drawing.
    pub fn length(&self, graph: &mut Graph, length: NodeId) -> NodeId {
        graph.multiply(self.scale, length)
    }

    /// A displacement in units of the drawing.
    pub fn way(&self, graph: &mut Graph, x: NodeId, y: NodeId) -> Spot {
        let (x, y) = (self.length(graph, x), self.length(graph, y));
        Spot { x, y: if self.framed { graph.negate(y) } else { y } }
    }

    /// Position of a point in the drawing.
    pub fn spot(&self, graph: &mut Graph, x: NodeId, y: NodeId) -> Spot {
        let way = self.way(graph, x, y);
        Spot { x: graph.add(self.origin.x, way.x), y: graph.add(self.origin.y, way.y) }
    }

    /// Position of a point of this coordinate system in the whole drawing, outside all rotated groups.
    pub fn outside(&self, graph: &mut Graph, spot: Spot) -> Spot {
        self.turns.iter().rev().fold(spot, |spot, (middle, angle)| {
            let (sine, cosine) = (graph.unary(Unary::Sin, *angle), graph.unary(Unary::Cos, *angle));
            let [cx, cy, sx, sy] =
                [(cosine, spot.x), (cosine, spot.y), (sine, spot.x), (sine, spot.y)].map(|(a, b)| graph.multiply(a, b));
            let (x, y) = (graph.subtract(cx, sy), graph.add(sx, cy));
            Spot { x: graph.add(middle.x, x), y: graph.add(middle.y, y) }
        })
    }
}
