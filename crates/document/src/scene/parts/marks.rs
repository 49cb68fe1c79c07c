//! Marks: label, ruler, angle, protractor.

use super::super::builder::Builder;
use super::super::space::Spot;
use super::drawing::{GLASS, Ink, TEXT, fixed};
use super::{Drawn, Given};
use model::Span;
use program::{Binary, Child, Element, NodeId, Piece, Unary};
use std::f64::consts::PI;
use units::words;

/// Maximum number of marks of a ruler.
const MARKS: f64 = 200.0;
/// Every fifth mark of a ruler has a number.
const NUMBERED: u32 = 5;

/// Distance of marks.
pub struct Step {
    /// Number and unit as written; `None` for an expression.
    pub written: Option<(f64, String)>,
    /// Value (SI), in the current coordinate system.
    pub node: NodeId,
    /// Place in the source.
    pub span: Span,
}

/// Number at a mark, rounded to hide the error of repeated steps; with a unit at the last mark.
pub fn number_of_mark(value: f64, unit: Option<&str>) -> String {
    let shown = units::number::shortest((value * 1e9).round() / 1e9);
    match unit {
        Some(unit) => format!("{shown} {unit}").trim_end().to_owned(),
        None => shown,
    }
}

impl Builder<'_, '_> {
    /// A text at a point. Its content is added afterwards.
    pub fn label(&mut self, given: &Given) -> Option<Drawn> {
        let at = self.point_of(given, "at")?;
        let text = self.numbered(fixed("text", &[]), &[("x", at.x), ("y", at.y)]);
        let defaults = vec![("fill", TEXT), ("font-size", "16"), ("text-anchor", "middle")];
        Some(Drawn { defaults, children: vec![text], anchor: at })
    }

    /// A line with a mark at each `step` and a number at every fifth mark, starting with `first`.
    pub fn ruler(&mut self, given: &Given) -> Option<Drawn> {
        let way = self.way_of(given)?;
        let Step { written, node: step, span } = self.step_of(given)?;
        let space = self.space().clone();
        let graph = self.graph();
        let (drawn, whole) = (space.length(graph, step), graph.divide(way.length, space.scale));
        let count = graph.as_constant(step).zip(graph.as_constant(whole));
        let count = count.map(|(step, whole)| (whole / step + 1e-9).floor());
        let Some(((size, unit), count)) = written.zip(count.filter(|count| (1.0..=MARKS).contains(count))) else {
            self.refuse_at(
                words!("a ruler has from 1 to {MARKS} marks, and their number never changes"),
                span,
                Some(words("give its ends and its step as numbers with units: `step=\"10 [cm]\"`")),
            );
            return None;
        };
        let first = match given.get("first") {
            Some(range) => self.steps_to(range.clone(), step)?,
            None => 0.0,
        };
        let line = self.numbered(fixed("line", &[]), &[("x2", way.length)]);
        let mut children = vec![line];
        for number in 0..=count as u32 {
            let at = self.times(f64::from(number), drawn);
            let long = number % NUMBERED == 0;
            let mark = fixed("line", &[("y2", if long { "10" } else { "6" })]);
            children.push(self.numbered(mark, &[("x1", at), ("x2", at)]));
            if long {
                let unit = (number + NUMBERED > count as u32).then_some(unit.as_str());
                let text = number_of_mark(size * (first + f64::from(number)), unit);
                let label = self.mark_text(text, &[("y", "23"), ("text-anchor", "middle")]);
                children.push(self.numbered(label, &[("x", at)]));
            }
        }
        Some(self.along_way(way, &[("stroke", TEXT), ("stroke-width", "1.5")], children))
    }

    /// Distance of the marks of a ruler or of axes.
    pub fn step_of(&mut self, given: &Given) -> Option<Step> {
        let inner = self.inside_braces(given.get("step")?.clone());
        let written = self.expressions.written(inner.clone());
        let step = self.expressions.number(inner)?;
        let span = step.span;
        Some(Step { written, node: self.of_space(step)?, span })
    }

    /// Text element for the number at a mark.
    pub fn mark_text(&mut self, text: String, attributes: &[(&str, &str)]) -> Element {
        let mut label =
            fixed("text", &[&[("fill", TEXT), ("stroke", "none"), ("font-size", "12")], attributes].concat());
        label.children.push(Child::Text(vec![Piece::Literal(text)]));
        self.unsaid();
        label
    }

    /// Number at the beginning of a ruler, in steps.
    fn steps_to(&mut self, range: std::ops::Range<usize>, step: NodeId) -> Option<f64> {
        let range = self.inside_braces(range);
        let placed = self.expressions.number(range)?;
        let span = placed.span;
        let first = self.of_space(placed)?;
        let graph = self.graph();
        let steps = graph.divide(first, step);
        let steps = graph.as_constant(steps).filter(|steps| steps.is_finite());
        if steps.is_none() {
            self.refuse_at(
                words("the numbers of a ruler never change"),
                span,
                Some(words("write a number with a unit: `first=\"-2 [m]\"`")),
            );
        }
        steps
    }

    /// An arc between two angles, measured from the x direction as in the problem.
    pub fn angle_arc(&mut self, given: &Given) -> Option<Drawn> {
        let at = self.point_of(given, "at")?;
        let (from, to) = (self.angle(given.get("from")?.clone()), self.angle(given.get("to")?.clone()));
        let (from, to) = from.zip(to)?;
        let radius = self.extent_or(given, "r", super::ARC_RADIUS)?;
        let (start, end) = (self.around(at, radius, from), self.around(at, radius, to));
        let graph = self.expressions.graph();
        let difference = graph.subtract(to, from);
        let amount = graph.unary(Unary::Absolute, difference);
        let (half_turn, zero) = (graph.constant(PI), graph.constant(0.0));
        let large = graph.binary(Binary::Less, half_turn, amount);
        let clockwise = if self.space().framed { (difference, zero) } else { (zero, difference) };
        let sweep = self.graph().binary(Binary::Less, clockwise.0, clockwise.1);
        let text = Ink::Text;
        let mut arc = fixed("path", &[]);
        self.set(
            &mut arc,
            "d",
            &[
                text("M"),
                Ink::Node(start.x),
                text(" "),
                Ink::Node(start.y),
                text("A"),
                Ink::Node(radius),
                text(" "),
                Ink::Node(radius),
                text(" 0 "),
                Ink::Node(large),
                text(" "),
                Ink::Node(sweep),
                text(" "),
                Ink::Node(end.x),
                text(" "),
                Ink::Node(end.y),
            ],
        );
        let defaults = vec![("fill", "none"), ("stroke", TEXT), ("stroke-width", "1.5")];
        Some(Drawn { defaults, children: vec![arc], anchor: end })
    }

    /// Point on a circle.
    fn around(&mut self, at: Spot, radius: NodeId, angle: NodeId) -> Spot {
        let (cosine, sine) = self.direction(angle);
        let framed = self.space().framed;
        let graph = self.graph();
        let (x, y) = (graph.multiply(radius, cosine), graph.multiply(radius, sine));
        let y = if framed { graph.negate(y) } else { y };
        Spot { x: graph.add(at.x, x), y: graph.add(at.y, y) }
    }

    /// A half circle with a mark at every 10 degrees.
    pub fn protractor(&mut self, given: &Given) -> Option<Drawn> {
        /// Radius of the drawing before scaling.
        const RADIUS: f64 = 100.0;
        let at = self.point_of(given, "at")?;
        let radius = self.extent(given.get("r")?.clone())?;
        let turn = self.turn_of(given)?;
        let size = self.times(1.0 / RADIUS, radius);
        let mut marks = String::from("M-100 0A100 100 0 0 1 100 0Z");
        let mut children: Vec<Element> = Vec::new();
        for tens in 0..=18_u32 {
            let angle = f64::from(tens) * PI / 18.0;
            let (x, y) = (Unary::Cos.evaluate(angle), -Unary::Sin.evaluate(angle));
            let inner = if tens % 3 == 0 { 86.0 } else { 93.0 };
            marks += &format!("M{:.2} {:.2}L{:.2} {:.2}", inner * x, inner * y, RADIUS * x, RADIUS * y);
            if tens % 3 == 0 && tens > 0 && tens < 18 {
                let (across, down) = (format!("{:.2}", 74.0 * x), format!("{:.2}", 74.0 * y + 5.0));
                let words = [
                    ("x", across.as_str()),
                    ("y", &down),
                    ("fill", TEXT),
                    ("stroke", "none"),
                    ("font-size", "13"),
                    ("text-anchor", "middle"),
                ];
                let mut label = fixed("text", &words);
                label.children.push(Child::Text(vec![Piece::Literal(format!("{}°", 10 * tens))]));
                self.unsaid();
                children.push(label);
            }
        }
        children.insert(
            0,
            fixed("path", &[("d", &marks), ("fill-opacity", "0.12"), ("vector-effect", "non-scaling-stroke")]),
        );
        let mut scaled = fixed("g", &[]);
        self.set(&mut scaled, "transform", &[Ink::Text("scale("), Ink::Node(size), Ink::Text(")")]);
        let scaled = super::drawing::holding(scaled, children);
        let child = self.standing(at, turn, vec![scaled]);
        Some(Drawn {
            defaults: vec![("fill", GLASS), ("stroke", TEXT), ("stroke-width", "1.2")],
            children: vec![child],
            anchor: at,
        })
    }
}
