//! `<frame x="-2..2 [m]" y="-1..2 [m]">`: inside it, lengths are those of the problem, and y points up.

use super::points;
use super::{Space, Spot};
use crate::expressions::{Placed, dimension_error};
use crate::scene::builder::Builder;
use model::Span;
use program::{Attribute, Binary, Compiled, Graph, Kind, NodeId, Piece};
use std::f64::consts::PI;
use std::ops::Range;
use units::{Dimension, Unit, words};

/// Ends of an axis (SI).
#[derive(Clone, Copy)]
struct Axis {
    low: NodeId,
    high: NodeId,
    dimension: Dimension,
    span: Span,
}

impl Builder<'_, '_> {
    /// Coordinate system inside a frame. `name` is the place of the element, for errors.
    pub fn frame_space(&mut self, name: Range<usize>, [x, y, place]: [Option<Range<usize>>; 3]) -> Option<Space> {
        if self.space().framed {
            self.refuse(
                words("a frame cannot stand inside another one"),
                name,
                Some(words("a `<g at=\"(x, y)\" turn=\"phi\">` has an origin of its own")),
            );
            return None;
        }
        let (Some(x), Some(y)) = (x, y) else {
            self.refuse(
                words("a frame needs the ranges of `x` and `y`"),
                name,
                Some(words("`<frame x=\"-2..2 [m]\" y=\"-1..2 [m]\">`")),
            );
            return None;
        };
        let (x, y) = (self.axis(x), self.axis(y));
        let (x, y) = x.zip(y)?;
        if x.dimension != y.dimension {
            let message = words("both axes of a frame have one scale, so they must have one dimension");
            self.expressions.diagnostics.push(dimension_error(message, (y.span, y.dimension), (x.span, x.dimension)));
            return None;
        }
        let [left, top, width, height] = self.frame_box(place, name)?;
        let graph = self.expressions.graph();
        let scale_of = |graph: &mut Graph, axis: Axis, size: f64| {
            let (size, length) = (graph.constant(size), graph.subtract(axis.high, axis.low));
            graph.divide(size, length)
        };
        let (by_x, by_y) = (scale_of(graph, x, width), scale_of(graph, y, height));
        let scale = graph.binary(Binary::Minimum, by_x, by_y);
        if x.dimension == Dimension::LENGTH {
            self.set_length(|graph| {
                let one = graph.constant(1.0);
                let node = graph.divide(one, scale);
                Placed { value: Compiled { node, kind: Kind::Number, unit: Unit::si(x.dimension) }, span: x.span }
            });
        }
        let graph = self.expressions.graph();
        // The centre of the frame is at the centre of its box.
        let middle = |graph: &mut Graph, axis: Axis| {
            let (sum, half) = (graph.add(axis.low, axis.high), graph.constant(0.5));
            let middle = graph.multiply(half, sum);
            graph.multiply(scale, middle)
        };
        let (across, along) = (middle(graph, x), middle(graph, y));
        let (centre_x, centre_y) = (graph.constant(left + width / 2.0), graph.constant(top + height / 2.0));
        let origin = Spot { x: graph.subtract(centre_x, across), y: graph.add(centre_y, along) };
        Some(Space { dimension: x.dimension, declared: x.span, scale, origin, framed: true, turns: Vec::new() })
    }

    /// Parses `-2..2 [m]`.
    fn axis(&mut self, range: Range<usize>) -> Option<Axis> {
        let range = crate::text::source::trim(self.expressions.source, range);
        let Some((low, high)) = points::interval(self.expressions.source, &range) else {
            self.refuse(words("a range is two values with `..` between them"), range, Some(words("write `-2..2 [m]`")));
            return None;
        };
        let (low, high) = self.expressions.interval(low, high)?;
        let dimension = high.value.dimension();
        let graph = self.expressions.graph();
        let (low_value, high_value) = (graph.as_constant(low.value.node), graph.as_constant(high.value.node));
        if low.value.dimension() != dimension && low_value != Some(0.0) {
            let message = words("both ends of a range have one dimension");
            let found = (low.span, low.value.dimension());
            self.expressions.diagnostics.push(dimension_error(message, found, (high.span, dimension)));
            return None;
        }
        if let (Some(from), Some(to)) = (low_value, high_value)
            && (from >= to || !(to - from).is_finite())
        {
            self.refuse(words("the range is empty"), range, None);
            return None;
        }
        let span = Span::new(range.start, range.end);
        Some(Axis { low: low.value.node, high: high.value.node, dimension, span })
    }

    /// Constant ends of a range in the current coordinate system (SI).
    pub fn fixed_range(&mut self, range: Range<usize>) -> Option<[f64; 2]> {
        let axis = self.axis(range)?;
        let value = Compiled { node: axis.high, kind: Kind::Number, unit: Unit::si(axis.dimension) };
        self.of_space(Placed { value, span: axis.span })?;
        let ends = [axis.low, axis.high].map(|end| self.expressions.graph().as_constant(end));
        if let [Some(low), Some(high)] = ends {
            return Some([low, high]);
        }
        self.refuse_at(
            words("the ends of axes never change"),
            axis.span,
            Some(words("write numbers with a unit: `-2..2 [m]`")),
        );
        None
    }

    /// `box="20 20 360 200"`: left, top, width and height in units of the drawing; by default the whole view box.
    fn frame_box(&mut self, place: Option<Range<usize>>, name: Range<usize>) -> Option<[f64; 4]> {
        let (numbers, place) = match place {
            Some(place) => (four_numbers(self.source(&place)), place),
            None => (self.view_box(), name),
        };
        if numbers.is_none() {
            self.refuse(
                words("a frame is fitted into a box, and there is none"),
                place,
                Some(words(
                    "give the `svg` element a `viewBox`, or write `box=\"20 20 360 200\"`: left, top, width and height",
                )),
            );
        }
        numbers
    }

    /// Moves and rotates the coordinate system for a group in a frame. Returns the group's `transform` and its position.
    pub fn group_space(&mut self, at: Option<Range<usize>>, turn: Option<Range<usize>>) -> Option<(Attribute, Spot)> {
        let zero = self.graph().constant(0.0);
        let place = match at {
            Some(at) => self.point(at)?,
            None => self.space().origin,
        };
        let angle = match turn {
            Some(turn) => self.angle(turn)?,
            None => zero,
        };
        let angle = self.graph().negate(angle);
        let degrees = self.degrees(angle);
        let mut value = vec![Piece::Literal("translate(".to_owned())];
        self.write_spot(place, &mut value);
        value.push(Piece::Literal(") rotate(".to_owned()));
        value.push(self.drawn(degrees)?);
        value.push(Piece::Literal(")".to_owned()));
        let inside = self.space().turned(place, angle, Spot { x: zero, y: zero });
        self.enter_space(inside);
        Some((Attribute { name: "transform".to_owned(), value: super::shapes::merged(value) }, place))
    }

    /// Converts radians to degrees.
    pub fn degrees(&mut self, angle: NodeId) -> NodeId {
        let graph = self.graph();
        let factor = graph.constant(180.0 / PI);
        graph.multiply(factor, angle)
    }
}

/// Parses four numbers, `0 0 400 300`: left, top, and positive width and height.
pub fn four_numbers(text: &str) -> Option<[f64; 4]> {
    let numbers = text.split([' ', ',']).filter(|part| !part.is_empty()).map(|part| part.parse::<f64>().ok());
    let numbers: [f64; 4] = numbers.collect::<Option<Vec<f64>>>()?.try_into().ok()?;
    let [_, _, width, height] = numbers;
    (numbers.iter().all(|number| number.is_finite()) && width > 0.0 && height > 0.0).then_some(numbers)
}
