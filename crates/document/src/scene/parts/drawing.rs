//! Building blocks of parts: lines and paths from one point to another, in units of the drawing.

use super::super::builder::Builder;
use super::super::space::Spot;
use super::Given;
use crate::scene::space::shapes::merged;
use program::{Attribute, Binary, Child, Element, NodeId, Piece, Unary};

/// Colour of lines.
pub const TEXT: &str = "currentColor";
/// Colour of moving things.
pub const MARK: &str = "var(--mark, #c4551d)";
/// Colour of glass.
pub const GLASS: &str = "var(--glass, #6d7d86)";
/// Colour of liquids.
pub const LIQUID: &str = "var(--liquid, #3f9fc0)";
/// Accent colour of the page.
pub const ACCENT: &str = "var(--accent, #0a6076)";
/// Background colour of the drawing.
pub const PAPER: &str = "var(--paper, #ffffff)";

/// A straight line between two points, with local x axis along it.
#[derive(Clone, Copy)]
pub struct Way {
    /// Start.
    pub from: Spot,
    /// End.
    pub to: Spot,
    /// Length, in units of the drawing.
    pub length: NodeId,
    /// Direction in the drawing, clockwise, in degrees.
    pub degrees: NodeId,
}

/// A piece of an attribute value.
#[derive(Clone, Copy)]
pub enum Ink<'t> {
    /// A text.
    Text(&'t str),
    /// A number.
    Node(NodeId),
}

/// An element with constant attributes.
pub fn fixed(name: &str, attributes: &[(&str, &str)]) -> Element {
    let attribute = |(name, value): &(&str, &str)| Attribute {
        name: (*name).to_owned(),
        value: vec![Piece::Literal((*value).to_owned())],
    };
    Element {
        name: name.to_owned(),
        attributes: attributes.iter().map(attribute).collect(),
        children: Vec::new(),
        drag: None,
    }
}

/// An element with children.
pub fn holding(mut element: Element, children: Vec<Element>) -> Element {
    element.children = children.into_iter().map(Child::Element).collect();
    element
}

impl Builder<'_, '_> {
    /// Node of a constant, in units of the drawing.
    pub fn constant(&mut self, value: f64) -> NodeId {
        self.graph().constant(value)
    }

    /// `factor*node`
    pub fn times(&mut self, factor: f64, node: NodeId) -> NodeId {
        let factor = self.constant(factor);
        self.graph().multiply(factor, node)
    }

    /// `node + summand`
    pub fn plus(&mut self, node: NodeId, summand: f64) -> NodeId {
        let summand = self.constant(summand);
        self.graph().add(node, summand)
    }

    /// `node` clamped to the range from `least` to `greatest`.
    pub fn between(&mut self, least: NodeId, node: NodeId, greatest: NodeId) -> NodeId {
        let graph = self.graph();
        let node = graph.binary(Binary::Maximum, least, node);
        graph.binary(Binary::Minimum, node, greatest)
    }

    /// Length of a part in units of the drawing; `otherwise` if it is not given.
    pub fn extent_or(&mut self, given: &Given, name: &str, otherwise: f64) -> Option<NodeId> {
        match given.get(name) {
            Some(range) => self.extent(range.clone()),
            None => Some(self.constant(otherwise)),
        }
    }

    /// A point of a part, in units of the drawing.
    pub fn point_of(&mut self, given: &Given, name: &str) -> Option<Spot> {
        self.point(given.get(name)?.clone())
    }

    /// The line from `from` to `to` of a part.
    pub fn way_of(&mut self, given: &Given) -> Option<Way> {
        let (from, to) = (self.point_of(given, "from"), self.point_of(given, "to"));
        let (from, to) = from.zip(to)?;
        Some(self.way(from, to))
    }

    /// The line between two points.
    pub fn way(&mut self, from: Spot, to: Spot) -> Way {
        let graph = self.graph();
        let (x, y) = (graph.subtract(to.x, from.x), graph.subtract(to.y, from.y));
        let (xx, yy) = (graph.multiply(x, x), graph.multiply(y, y));
        let square = graph.add(xx, yy);
        let length = graph.unary(Unary::SquareRoot, square);
        let angle = graph.binary(Binary::Atan2, y, x);
        let degrees = self.degrees(angle);
        Way { from, to, length, degrees }
    }

    /// Appends an attribute.
    pub fn set(&mut self, element: &mut Element, name: &str, value: &[Ink]) {
        let pieces = value.iter().filter_map(|ink| match ink {
            Ink::Text(text) => Some(Piece::Literal((*text).to_owned())),
            Ink::Node(node) => self.drawn(*node),
        });
        let value = merged(pieces.collect());
        element.attributes.push(Attribute { name: name.to_owned(), value });
    }

    /// Appends attributes with one number each.
    pub fn numbered(&mut self, mut element: Element, numbers: &[(&str, NodeId)]) -> Element {
        for (name, node) in numbers {
            self.set(&mut element, name, &[Ink::Node(*node)]);
        }
        element
    }

    /// A group with its origin at `at`, rotated clockwise by an angle in degrees.
    pub fn standing(&mut self, at: Spot, degrees: Option<NodeId>, children: Vec<Element>) -> Element {
        let mut group = fixed("g", &[]);
        let move_to = [Ink::Text("translate("), Ink::Node(at.x), Ink::Text(" "), Ink::Node(at.y), Ink::Text(")")];
        match degrees {
            Some(degrees) => {
                let turn = [Ink::Text(" rotate("), Ink::Node(degrees), Ink::Text(")")];
                self.set(&mut group, "transform", &[&move_to[..], &turn].concat());
            }
            None => self.set(&mut group, "transform", &move_to),
        }
        holding(group, children)
    }

    /// Rotation of a part in degrees, clockwise in the drawing; `Some(None)` without `turn`, `None` after an error.
    pub fn turn_of(&mut self, given: &Given) -> Option<Option<NodeId>> {
        let Some(turn) = given.get("turn") else { return Some(None) };
        let angle = self.angle(turn.clone())?;
        // Angles are counterclockwise in a frame, and clockwise in SVG.
        let angle = if self.space().framed { self.graph().negate(angle) } else { angle };
        Some(Some(self.degrees(angle)))
    }
}
