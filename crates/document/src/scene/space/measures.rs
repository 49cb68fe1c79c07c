//! Lengths, angles and points in attributes, in units of the problem or of the drawing.

use super::Spot;
use super::points;
use crate::expressions::{Placed, dimension_error};
use crate::scene::builder::Builder;
use model::{Diagnostic, Span};
use program::NodeId;
use std::ops::Range;
use units::{Dimension, words};

impl Builder<'_, '_> {
    /// Range of an attribute value without optional braces.
    pub fn inside_braces(&self, range: Range<usize>) -> Range<usize> {
        let range = crate::text::source::trim(self.expressions.source, range);
        let text = self.source(&range);
        let is_one = text.starts_with('{') && text.find('}') == Some(text.len() - 1);
        if is_one { range.start + 1..range.end - 1 } else { range }
    }

    /// A length or coordinate of the current coordinate system (SI).
    pub fn coordinate(&mut self, range: Range<usize>) -> Option<NodeId> {
        let range = self.inside_braces(range);
        let placed = self.expressions.number(range)?;
        self.of_space(placed)
    }

    /// A length in units of the drawing: `5px`, or a length of the current coordinate system.
    pub fn extent(&mut self, range: Range<usize>) -> Option<NodeId> {
        let inner = self.inside_braces(range.clone());
        let pixels = self.source(&inner).strip_suffix("px").and_then(|number| number.trim().parse::<f64>().ok());
        if let Some(pixels) = pixels.filter(|pixels| pixels.is_finite()) {
            let length = self.graph().constant(pixels);
            self.note_number(range.start, length);
            return Some(length);
        }
        let length = self.coordinate(range.clone())?;
        let space = self.space().clone();
        let length = space.length(self.graph(), length);
        self.note_number(range.start, length);
        Some(length)
    }

    /// An angle in radians.
    pub fn angle(&mut self, range: Range<usize>) -> Option<NodeId> {
        let inner = self.inside_braces(range.clone());
        let placed = self.expressions.number(inner)?;
        if placed.value.dimension() == Dimension::NONE {
            self.note_number(range.start, placed.value.node);
            return Some(placed.value.node);
        }
        let message = words("an angle is a pure number, such as `30 [deg]`");
        let expected = (placed.span, Dimension::NONE);
        self.expressions.diagnostics.push(dimension_error(message, (placed.span, placed.value.dimension()), expected));
        None
    }

    /// A point, in units of the drawing.
    pub fn point(&mut self, range: Range<usize>) -> Option<Spot> {
        let place = range.start;
        let (x, y) = self.components(range)?;
        let (x, y) = (self.of_space(x), self.of_space(y));
        let (x, y) = x.zip(y)?;
        let space = self.space().clone();
        let spot = space.spot(self.graph(), x, y);
        self.note_spot(place, spot);
        Some(spot)
    }

    /// A displacement, in units of the drawing.
    pub fn vector(&mut self, range: Range<usize>) -> Option<Spot> {
        let (x, y) = self.components(range)?;
        let (x, y) = (self.of_space(x), self.of_space(y));
        let (x, y) = x.zip(y)?;
        let space = self.space().clone();
        Some(space.way(self.graph(), x, y))
    }

    /// A point of a list, in units of the drawing.
    pub fn pair(&mut self, pair: &points::Pair) -> Option<Spot> {
        let (x, y) = (self.coordinate(pair.first.clone()), self.coordinate(pair.second.clone()));
        let (x, y) = x.zip(y)?;
        let space = self.space().clone();
        Some(space.spot(self.graph(), x, y))
    }

    /// Both components of a point.
    fn components(&mut self, range: Range<usize>) -> Option<(Placed, Placed)> {
        let range = self.inside_braces(range);
        let Some(pairs) = points::pairs(self.expressions.source, range.clone()) else {
            if let Some(components) = self.expressions.vector(range.clone()) {
                return components;
            }
            self.expressions.diagnostics.push(
                Diagnostic::error(
                    "scene-point",
                    words("a point is two numbers in parentheses, or a vector"),
                    Span::new(range.start, range.end),
                )
                .with_hint(words("write `(x, 0)`; it may be multiplied, `2*(x, y)`, and points may be added")),
            );
            return None;
        };
        if let [pair] = &pairs[..]
            && pair.whole == range
        {
            let (x, y) = (self.expressions.number(pair.first.clone()), self.expressions.number(pair.second.clone()));
            return x.zip(y);
        }
        // Each component is the expression without the other component and the comma.
        let second: Vec<_> = pairs.iter().map(|pair| pair.first.end..pair.second.end).collect();
        let first: Vec<_> = pairs.iter().map(|pair| pair.first.start..pair.second.start).collect();
        let x = self.expressions.component(range.clone(), &second);
        let y = self.expressions.component(range, &first);
        x.zip(y)
    }

    /// Requires the dimension of lengths in the current coordinate system; 0 fits every dimension.
    pub fn of_space(&mut self, Placed { value, span }: Placed) -> Option<NodeId> {
        let expected = self.space().dimension;
        if value.dimension() == expected || self.graph().as_constant(value.node) == Some(0.0) {
            return Some(value.node);
        }
        let diagnostic = if self.space().framed {
            let message = words("a length in a frame must have the dimension of its axes");
            dimension_error(message, (span, value.dimension()), (self.space().declared, expected))
        } else {
            let message = words("a length in the drawing is a pure number, in units of the `viewBox`");
            dimension_error(message, (span, value.dimension()), (span, expected))
                .with_hint(words("inside a `<frame x=\"-2..2 [m]\" y=\"-1..2 [m]\">` lengths are those of the problem"))
        };
        self.expressions.diagnostics.push(diagnostic);
        None
    }
}
