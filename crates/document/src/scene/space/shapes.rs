//! SVG elements in a frame, with coordinates and lengths of the problem.

use super::Spot;
use super::points::{Step, steps};
use crate::scene::builder::Builder;
use program::{Attribute, NodeId, Piece};
use std::collections::BTreeMap;
use std::ops::Range;
use units::words;

/// Places of attribute values with lengths or points, by name.
pub type Geometry = BTreeMap<String, Range<usize>>;

/// True if an attribute of an element is a length or a position.
pub fn is_geometry(element: &str, attribute: &str) -> bool {
    match element {
        "rect" => matches!(attribute, "x" | "y" | "width" | "height" | "rx" | "ry" | "at" | "size"),
        "circle" => matches!(attribute, "cx" | "cy" | "r" | "at"),
        "ellipse" => matches!(attribute, "cx" | "cy" | "rx" | "ry" | "at"),
        "line" => matches!(attribute, "x1" | "y1" | "x2" | "y2" | "from" | "to"),
        "polyline" | "polygon" => attribute == "points",
        "path" => attribute == "d",
        "text" | "tspan" => matches!(attribute, "x" | "y" | "at"),
        "g" => matches!(attribute, "at" | "turn"),
        _ => false,
    }
}

impl Builder<'_, '_> {
    /// Attributes that place an element in a frame, and its point that follows the pointer when it is dragged.
    pub fn shape(&mut self, element: &str, geometry: &Geometry) -> (Vec<Attribute>, Option<Spot>) {
        let mut attributes = Vec::new();
        let at = geometry.get("at").and_then(|at| self.point(at.clone()));
        let mut anchor = at;
        match element {
            "rect" => anchor = self.rectangle(geometry, at, &mut attributes),
            "circle" | "ellipse" => {
                anchor = at.or_else(|| self.spot_of(geometry, "cx", "cy"));
                self.place(anchor, ["cx", "cy"], &mut attributes);
                self.lengths(geometry, &["r", "rx", "ry"], &mut attributes);
            }
            "line" => {
                let from = match geometry.get("from") {
                    Some(from) => self.point(from.clone()),
                    None => self.spot_of(geometry, "x1", "y1"),
                };
                let to = match geometry.get("to") {
                    Some(to) => self.point(to.clone()),
                    None => self.spot_of(geometry, "x2", "y2"),
                };
                self.place(from, ["x1", "y1"], &mut attributes);
                self.place(to, ["x2", "y2"], &mut attributes);
                anchor = to;
            }
            "text" | "tspan" => {
                if geometry.contains_key("x") || geometry.contains_key("y") {
                    anchor = self.spot_of(geometry, "x", "y");
                }
                self.place(anchor, ["x", "y"], &mut attributes);
            }
            _ => {
                for (name, commands) in [("points", ""), ("d", "MLQCTSZ")] {
                    if let Some(range) = geometry.get(name) {
                        let value = self.outline(range.clone(), commands);
                        attributes.extend(value.map(|value| Attribute { name: name.to_owned(), value }));
                    }
                }
            }
        }
        (attributes, anchor)
    }

    /// Upper left corner of a rectangle, which is given by its lower left corner or by its centre.
    fn rectangle(&mut self, geometry: &Geometry, at: Option<Spot>, attributes: &mut Vec<Attribute>) -> Option<Spot> {
        let zero = self.graph().constant(0.0);
        let (width, height) = match geometry.get("size") {
            Some(size) => {
                let size = self.size(size.clone())?;
                (size.x, size.y)
            }
            None => {
                let mut length = |name: &str| geometry.get(name).map_or(Some(zero), |range| self.extent(range.clone()));
                (length("width")?, length("height")?)
            }
        };
        let corner = match at {
            Some(middle) => self.corner(middle, width, height),
            None => {
                let lower = self.spot_of(geometry, "x", "y")?;
                Spot { x: lower.x, y: self.graph().subtract(lower.y, height) }
            }
        };
        self.place(Some(corner), ["x", "y"], attributes);
        for (name, length) in [("width", width), ("height", height)] {
            attributes.extend(self.number_attribute(name, length));
        }
        self.lengths(geometry, &["rx", "ry"], attributes);
        Some(at.unwrap_or(corner))
    }

    /// Upper left corner of a rectangle, from its centre and size.
    pub fn corner(&mut self, middle: Spot, width: NodeId, height: NodeId) -> Spot {
        let graph = self.graph();
        let half = graph.constant(0.5);
        let (right, down) = (graph.multiply(half, width), graph.multiply(half, height));
        Spot { x: graph.subtract(middle.x, right), y: graph.subtract(middle.y, down) }
    }

    /// Parses `(30 [cm], 20px)`: width and height in units of the drawing.
    pub fn size(&mut self, range: Range<usize>) -> Option<Spot> {
        let inner = self.inside_braces(range.clone());
        let found = steps(self.expressions.source, inner.clone(), "");
        let Ok([Step::Point(pair)]) = found.as_deref() else {
            self.refuse(
                words("a size is two lengths in parentheses"),
                inner,
                Some(words("write `(30 [cm], 20 [cm])` or `(30px, 20px)`")),
            );
            return None;
        };
        let pair = pair.clone();
        let (x, y) = (self.extent(pair.first), self.extent(pair.second));
        let size = Spot { x: x?, y: y? };
        self.note_spot(range.start, size);
        Some(size)
    }

    /// Position whose coordinates are in two attributes; a missing one is 0.
    fn spot_of(&mut self, geometry: &Geometry, x: &str, y: &str) -> Option<Spot> {
        let zero = self.graph().constant(0.0);
        let mut number = |name: &str| geometry.get(name).map_or(Some(zero), |range| self.coordinate(range.clone()));
        let (right, up) = (number(x), number(y));
        let (right, up) = right.zip(up)?;
        let space = self.space().clone();
        let spot = space.spot(self.graph(), right, up);
        for (name, node) in [(x, spot.x), (y, spot.y)] {
            if let Some(range) = geometry.get(name) {
                self.note_number(range.start, node);
            }
        }
        Some(spot)
    }

    /// A list of points, or a path of points.
    fn outline(&mut self, range: Range<usize>, commands: &str) -> Option<Vec<Piece>> {
        if let Some(computed) = self.computed_points(range.clone()).filter(|_| commands.is_empty()) {
            return computed;
        }
        let steps = match steps(self.expressions.source, range, commands) {
            Ok(steps) => steps,
            Err(place) => {
                let hint = if commands.is_empty() {
                    words("write `(0, 0) (x, y)`")
                } else {
                    words("write `M (0, 0) L (x, y) Z`")
                };
                let message = words("in a frame this consists of points");
                self.refuse(message, place, Some(hint));
                return None;
            }
        };
        let mut pieces = Vec::new();
        for step in steps {
            match step {
                Step::Command(letter) => pieces.push(Piece::Literal(letter.to_string())),
                Step::Point(pair) => {
                    let spot = self.pair(&pair)?;
                    self.write_spot(spot, &mut pieces);
                }
            }
        }
        Some(merged(pieces))
    }

    fn lengths(&mut self, geometry: &Geometry, names: &[&str], attributes: &mut Vec<Attribute>) {
        for name in names {
            if let Some(length) = geometry.get(*name).and_then(|range| self.extent(range.clone())) {
                attributes.extend(self.number_attribute(name, length));
            }
        }
    }

    /// Both attributes of a position.
    pub fn place(&mut self, spot: Option<Spot>, names: [&str; 2], attributes: &mut Vec<Attribute>) {
        if let Some(spot) = spot {
            for (name, node) in names.into_iter().zip([spot.x, spot.y]) {
                attributes.extend(self.number_attribute(name, node));
            }
        }
    }

    /// An attribute with a number in units of the drawing.
    pub fn number_attribute(&mut self, name: &str, node: NodeId) -> Option<Attribute> {
        Some(Attribute { name: name.to_owned(), value: vec![self.drawn(node)?] })
    }

    /// Appends ` x y`.
    pub fn write_spot(&mut self, spot: Spot, pieces: &mut Vec<Piece>) {
        for node in [spot.x, spot.y] {
            pieces.push(Piece::Literal(" ".to_owned()));
            pieces.extend(self.drawn(node));
        }
    }
}

/// Joins adjacent texts.
pub fn merged(pieces: Vec<Piece>) -> Vec<Piece> {
    let mut merged: Vec<Piece> = Vec::new();
    for piece in pieces {
        match (merged.last_mut(), piece) {
            (Some(Piece::Literal(before)), Piece::Literal(text)) => before.push_str(&text),
            (_, piece) => merged.push(piece),
        }
    }
    merged
}
