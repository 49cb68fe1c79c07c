//! Parts between two points: spring, damper, rod, ground; and the arrow.

use super::super::builder::Builder;
use super::super::space::Spot;
use super::drawing::{ACCENT, Ink, TEXT, Way, fixed};
use super::{Drawn, Given};
use program::{Binary, Unary};
use units::words;

/// Maximum number of turns of a spring.
const TURNS: f64 = 60.0;

impl Builder<'_, '_> {
    /// A zigzag with straight ends, each as long as one turn.
    pub fn spring(&mut self, given: &Given) -> Option<Drawn> {
        let way = self.way_of(given)?;
        let turns = match given.get("turns") {
            Some(range) => self.whole_number(range.clone(), TURNS)?,
            None => 8,
        };
        let width = self.extent_or(given, "width", 16.0)?;
        let parts = self.constant(f64::from(turns) + 2.0);
        let turn = self.graph().divide(way.length, parts);
        let (half, quarter) = (self.times(0.5, turn), self.times(0.25, turn));
        let (down, side) = (width, self.times(0.5, width));
        let (up, to_top) = (self.graph().negate(down), self.graph().negate(side));
        let text = Ink::Text;
        let mut path =
            vec![text("M0 0h"), Ink::Node(turn), text("l"), Ink::Node(quarter), text(" "), Ink::Node(to_top)];
        for number in 0..2 * turns - 1 {
            let across = if number % 2 == 0 { down } else { up };
            path.extend([text("l"), Ink::Node(half), text(" "), Ink::Node(across)]);
        }
        path.extend([text("l"), Ink::Node(quarter), text(" "), Ink::Node(to_top), text("h"), Ink::Node(turn)]);
        let mut line = fixed("path", &[]);
        self.set(&mut line, "d", &path);
        Some(self.along_way(
            way,
            &[("fill", "none"), ("stroke", TEXT), ("stroke-width", "2"), ("stroke-linejoin", "round")],
            vec![line],
        ))
    }

    /// A cylinder fixed at the start, and a piston whose rod is fixed at the end.
    pub fn damper(&mut self, given: &Given) -> Option<Drawn> {
        const FOOT: f64 = 10.0;
        let way = self.way_of(given)?;
        let (width, length) = (self.extent_or(given, "width", 18.0)?, self.extent_or(given, "length", 48.0)?);
        let side = self.times(0.5, width);
        let mouth = self.plus(length, FOOT);
        let (least, greatest) = (self.constant(FOOT + 4.0), self.plus(mouth, -4.0));
        let piston = self.graph().subtract(way.length, length);
        let piston = self.between(least, piston, greatest);
        let opposite = self.graph().negate(side);
        let text = Ink::Text;
        let (inner, outer) = (self.times(0.8, side), self.times(-0.8, side));
        let mut line = fixed("path", &[]);
        self.set(
            &mut line,
            "d",
            &[
                text("M0 0H10M"),
                Ink::Node(mouth),
                text(" "),
                Ink::Node(opposite),
                text("H10V"),
                Ink::Node(side),
                text("H"),
                Ink::Node(mouth),
                text("M"),
                Ink::Node(piston),
                text(" "),
                Ink::Node(outer),
                text("V"),
                Ink::Node(inner),
                text("M"),
                Ink::Node(piston),
                text(" 0H"),
                Ink::Node(way.length),
            ],
        );
        Some(self.along_way(way, &[("fill", "none"), ("stroke", TEXT), ("stroke-width", "2")], vec![line]))
    }

    /// A thick line.
    pub fn rod(&mut self, given: &Given) -> Option<Drawn> {
        let way = self.way_of(given)?;
        let line = self.numbered(
            fixed("line", &[]),
            &[("x1", way.from.x), ("y1", way.from.y), ("x2", way.to.x), ("y2", way.to.y)],
        );
        let defaults = vec![("stroke", TEXT), ("stroke-width", "4"), ("stroke-linecap", "round")];
        Some(Drawn { defaults, children: vec![line], anchor: way.to })
    }

    /// A line with hatching to the right of its direction.
    pub fn ground(&mut self, given: &Given) -> Option<Drawn> {
        let way = self.way_of(given)?;
        let depth = self.extent_or(given, "depth", 10.0)?;
        let middle = self.times(0.5, depth);
        let surface = self.numbered(fixed("line", &[]), &[("x2", way.length)]);
        let slanted = [("stroke-dasharray", "1.2 7"), ("transform", "skewX(-40)"), ("stroke-opacity", "0.6")];
        let hatch = fixed("line", &slanted);
        let hatch =
            self.numbered(hatch, &[("x2", way.length), ("y1", middle), ("y2", middle), ("stroke-width", depth)]);
        Some(self.along_way(way, &[("stroke", TEXT), ("stroke-width", "2")], vec![hatch, surface]))
    }

    /// An arrow. A short arrow gets a small head.
    pub fn arrow(&mut self, given: &Given) -> Option<Drawn> {
        let (at, vector) = (self.point_of(given, "at"), self.vector(given.get("vector")?.clone()));
        let (at, vector) = at.zip(vector)?;
        let graph = self.graph();
        let tip = Spot { x: graph.add(at.x, vector.x), y: graph.add(at.y, vector.y) };
        let way = self.way(at, tip);
        let part = self.times(1.0 / 14.0, way.length);
        let one = self.constant(1.0);
        let size = self.graph().binary(Binary::Minimum, one, part);
        let head = self.times(-10.0, size);
        let shaft = self.graph().add(way.length, head);
        let line = self.numbered(fixed("line", &[]), &[("x2", shaft)]);
        let mut head = fixed("path", &[("d", "M0 0L-13-5.5L-13 5.5Z"), ("stroke", "none")]);
        self.set(
            &mut head,
            "transform",
            &[Ink::Text("translate("), Ink::Node(way.length), Ink::Text(" 0) scale("), Ink::Node(size), Ink::Text(")")],
        );
        Some(self.along_way(way, &[("fill", ACCENT), ("stroke", ACCENT), ("stroke-width", "3")], vec![line, head]))
    }

    /// Elements drawn along the x axis from the origin, placed on the line `way`.
    pub fn along_way(
        &mut self,
        way: Way,
        defaults: &[(&'static str, &'static str)],
        children: Vec<program::Element>,
    ) -> Drawn {
        let group = self.standing(way.from, Some(way.degrees), children);
        Drawn { defaults: defaults.to_vec(), children: vec![group], anchor: way.to }
    }

    /// A constant integer from 1 to `greatest`.
    pub fn whole_number(&mut self, range: std::ops::Range<usize>, greatest: f64) -> Option<u32> {
        let range = self.inside_braces(range);
        let placed = self.expressions.number(range)?;
        let value = self
            .graph()
            .as_constant(placed.value.node)
            .filter(|value| placed.value.dimension().is_none() && *value == value.floor());
        let value = value.filter(|value| (1.0..=greatest).contains(value));
        if value.is_none() {
            self.refuse_at(words!("this must be a whole number from 1 to {greatest}"), placed.span, None);
        }
        value.map(|value| value as u32)
    }

    /// Cosine and sine of an angle.
    pub fn direction(&mut self, angle: program::NodeId) -> (program::NodeId, program::NodeId) {
        let graph = self.graph();
        (graph.unary(Unary::Cos, angle), graph.unary(Unary::Sin, angle))
    }
}
