//! Coordinates: where a point of the problem lies in the drawing. Outside a `<frame>` they are those of the drawing.

use super::build::Builder;
use super::points;
use crate::expressions::{Placed, dimension_error};
use model::{Diagnostic, Span};
use program::{Graph, NodeId, Unary};
use std::ops::Range;
use units::{Dimension, words};

/// What lengths mean, and where they are drawn.
#[derive(Clone, Debug)]
pub struct Space {
    /// The dimension of lengths.
    pub dimension: Dimension,
    /// Where that was said.
    pub declared: Span,
    /// Drawing units for an SI unit.
    pub scale: NodeId,
    /// Where the origin is drawn.
    pub origin: Spot,
    /// Whether y goes up, and attributes hold expressions.
    pub framed: bool,
    /// The turned groups around it, outermost first: the place of each and its angle in the drawing, clockwise in radians.
    pub turns: Vec<(Spot, NodeId)>,
}

/// A place in the drawing, in its units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spot {
    /// To the right.
    pub x: NodeId,
    /// Downwards.
    pub y: NodeId,
}

impl Space {
    /// The drawing itself.
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

    /// How far in the drawing a length is.
    pub fn length(&self, graph: &mut Graph, length: NodeId) -> NodeId {
        graph.multiply(self.scale, length)
    }

    /// A way in the drawing.
    pub fn way(&self, graph: &mut Graph, x: NodeId, y: NodeId) -> Spot {
        let (x, y) = (self.length(graph, x), self.length(graph, y));
        Spot { x, y: if self.framed { graph.negate(y) } else { y } }
    }

    /// Where a point lies.
    pub fn spot(&self, graph: &mut Graph, x: NodeId, y: NodeId) -> Spot {
        let way = self.way(graph, x, y);
        Spot { x: graph.add(self.origin.x, way.x), y: graph.add(self.origin.y, way.y) }
    }

    /// Where a place of this space lies in the whole drawing.
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

impl Builder<'_, '_> {
    /// The graph.
    pub fn graph(&mut self) -> &mut Graph {
        self.expressions.graph()
    }

    /// What stands in an attribute, without the braces that may stand around it.
    pub fn inside_braces(&self, range: Range<usize>) -> Range<usize> {
        let range = crate::source::trim(self.expressions.source, range);
        let text = self.source(&range);
        let is_one = text.starts_with('{') && text.find('}') == Some(text.len() - 1);
        if is_one { range.start + 1..range.end - 1 } else { range }
    }

    /// A length or coordinate of the present space, SI.
    pub fn coordinate(&mut self, range: Range<usize>) -> Option<NodeId> {
        let range = self.inside_braces(range);
        let placed = self.expressions.number(range)?;
        self.of_space(placed)
    }

    /// A length in units of the drawing: `5px`, or a length of the present space.
    pub fn extent(&mut self, range: Range<usize>) -> Option<NodeId> {
        let inner = self.inside_braces(range.clone());
        let pixels = self.source(&inner).strip_suffix("px").and_then(|number| number.trim().parse::<f64>().ok());
        if let Some(pixels) = pixels.filter(|pixels| pixels.is_finite()) {
            return Some(self.graph().constant(pixels));
        }
        let length = self.coordinate(range)?;
        let space = self.space.clone();
        Some(space.length(self.graph(), length))
    }

    /// An angle, in radians.
    pub fn angle(&mut self, range: Range<usize>) -> Option<NodeId> {
        let range = self.inside_braces(range);
        let placed = self.expressions.number(range)?;
        if placed.value.dimension() == Dimension::NONE {
            return Some(placed.value.node);
        }
        let message =
            words("an angle is a pure number, such as `30 [deg]`", "un ángulo es un número puro, como `30 [deg]`");
        let expected = (placed.span, Dimension::NONE);
        self.expressions.diagnostics.push(dimension_error(message, (placed.span, placed.value.dimension()), expected));
        None
    }

    /// A point, in the drawing.
    pub fn point(&mut self, range: Range<usize>) -> Option<Spot> {
        let (x, y) = self.components(range)?;
        let (x, y) = (self.of_space(x), self.of_space(y));
        let (x, y) = x.zip(y)?;
        let space = self.space.clone();
        Some(space.spot(self.graph(), x, y))
    }

    /// A point of a list, in the drawing.
    pub fn pair(&mut self, pair: &points::Pair) -> Option<Spot> {
        let (x, y) = (self.coordinate(pair.first.clone()), self.coordinate(pair.second.clone()));
        let (x, y) = x.zip(y)?;
        let space = self.space.clone();
        Some(space.spot(self.graph(), x, y))
    }

    /// Both numbers of a point.
    fn components(&mut self, range: Range<usize>) -> Option<(Placed, Placed)> {
        let range = self.inside_braces(range);
        let Some(pairs) = points::pairs(self.expressions.source, range.clone()) else {
            self.expressions.diagnostics.push(
                Diagnostic::error(
                    "scene-point",
                    words("a point is two numbers in parentheses", "un punto son dos números entre paréntesis"),
                    Span::new(range.start, range.end),
                )
                .with_hint(words(
                    "write `(x, 0)`; it may be multiplied, `2*(x, y)`, and points may be added",
                    "escribe `(x, 0)`; se puede multiplicar, `2*(x, y)`, y los puntos se pueden sumar",
                )),
            );
            return None;
        };
        if let [pair] = &pairs[..]
            && pair.whole == range
        {
            let (x, y) = (self.expressions.number(pair.first.clone()), self.expressions.number(pair.second.clone()));
            return x.zip(y);
        }
        // Each component is the expression without the other one and the comma.
        let second: Vec<_> = pairs.iter().map(|pair| pair.first.end..pair.second.end).collect();
        let first: Vec<_> = pairs.iter().map(|pair| pair.first.start..pair.second.start).collect();
        let x = self.expressions.component(range.clone(), &second);
        let y = self.expressions.component(range, &first);
        x.zip(y)
    }

    /// A number that has the dimension of lengths in the present space. 0 fits any.
    pub fn of_space(&mut self, Placed { value, span }: Placed) -> Option<NodeId> {
        let expected = self.space.dimension;
        if value.dimension() == expected || self.graph().as_constant(value.node) == Some(0.0) {
            return Some(value.node);
        }
        let diagnostic = if self.space.framed {
            let message = words(
                "a length in a frame must have the dimension of its axes",
                "una longitud en un marco debe tener la dimensión de sus ejes",
            );
            dimension_error(message, (span, value.dimension()), (self.space.declared, expected))
        } else {
            let message = words(
                "a length in the drawing is a pure number, in units of the `viewBox`",
                "una longitud en el dibujo es un número puro, en unidades del `viewBox`",
            );
            dimension_error(message, (span, value.dimension()), (span, expected)).with_hint(words(
                "inside a `<frame x=\"-2..2 [m]\" y=\"-1..2 [m]\">` lengths are those of the problem",
                "dentro de un `<frame x=\"-2..2 [m]\" y=\"-1..2 [m]\">` las longitudes son las del problema",
            ))
        };
        self.expressions.diagnostics.push(diagnostic);
        None
    }
}
