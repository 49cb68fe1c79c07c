//! Axes: two crossing lines with marks, and with numbers in the unit of the step.

use super::super::builder::Builder;
use super::super::space::Spot;
use super::drawing::{Ink, TEXT, fixed};
use super::marks::{Step, number_of_mark};
use super::{Drawn, Given};
use program::Element;
use units::words;

/// Maximum number of marks per axis.
const MARKS: f64 = 100.0;
/// Maximum distance of marks from 0, in steps; farther marks would coincide.
const FARTHEST: f64 = 1e6;
/// Maximum number of marks with a number at each; with more marks, every fifth has a number.
const NUMBERED: i32 = 12;

/// One of the two axes.
struct Axis<'a> {
    /// Both ends (SI).
    range: [f64; 2],
    /// Position on the other axis (SI).
    across: f64,
    upright: bool,
    /// Distance of its marks: SI, and in the unit as written.
    step: f64,
    size: f64,
    unit: &'a str,
}

impl Builder<'_, '_> {
    /// Draws both axes. They cross at 0; if 0 is outside a range, at the nearest end of that range.
    pub fn axes(&mut self, given: &Given) -> Option<Drawn> {
        let (x, y) = (self.fixed_range(given.get("x")?.clone()), self.fixed_range(given.get("y")?.clone()));
        let (x, y) = x.zip(y)?;
        let Step { written, node, span } = self.step_of(given)?;
        let step = self.graph().as_constant(node);
        let few = |[low, high]: [f64; 2], step: f64| {
            (high - low) / step <= MARKS && [low, high].iter().all(|end| (end / step).abs() < FARTHEST)
        };
        let fits = |step: &f64| *step > 0.0 && few(x, *step) && few(y, *step);
        let Some((step, (size, unit))) = step.filter(fits).zip(written) else {
            self.refuse_at(
                words!("each axis has {MARKS} marks at most"),
                span,
                Some(words("give their distance as a number with a unit: `step=\"10 [cm]\"`")),
            );
            return None;
        };
        let crossing = [x, y].map(|[low, high]| 0.0_f64.clamp(low, high));
        let axis = |range, across, upright| Axis { range, across, upright, step, size, unit: &unit };
        let mut children = self.axis_lines(&axis(x, crossing[1], false));
        children.extend(self.axis_lines(&axis(y, crossing[0], true)));
        let anchor = self.fixed_spot(crossing);
        let defaults = vec![("fill", "none"), ("stroke", TEXT), ("stroke-width", "1.5")];
        Some(Drawn { defaults, children, anchor })
    }

    /// An axis with an arrowhead, marks and numbers. There is no number at the crossing.
    fn axis_lines(&mut self, axis: &Axis) -> Vec<Element> {
        let &Axis { range: [low, high], across, upright, step, size, unit } = axis;
        let place = |at: f64| if upright { [across, at] } else { [at, across] };
        let (begin, end) = (self.fixed_spot(place(low)), self.fixed_spot(place(high)));
        let line = fixed("line", &[]);
        let line = self.numbered(line, &[("x1", begin.x), ("y1", begin.y), ("x2", end.x), ("y2", end.y)]);
        let mut head = fixed("path", &[("fill", TEXT), ("stroke", "none")]);
        let shape = match (upright, self.space().framed) {
            (false, _) => "l-9 -4v8z",
            (true, true) => "l-4 9h8z",
            (true, false) => "l-4 -9h8z",
        };
        self.set(
            &mut head,
            "d",
            &[Ink::Text("M"), Ink::Node(end.x), Ink::Text(" "), Ink::Node(end.y), Ink::Text(shape)],
        );
        let mut children = vec![line, head];
        let [first, last] = [(low / step - 1e-9).ceil() as i32, (high / step + 1e-9).floor() as i32];
        let apart = if last - first > NUMBERED { 5 } else { 1 };
        for number in first..=last {
            let spot = self.fixed_spot(place(f64::from(number) * step));
            let (x, y) = if upright { (self.plus(spot.x, -6.0), spot.y) } else { (spot.x, self.plus(spot.y, 6.0)) };
            let mark = fixed("line", &[]);
            children.push(self.numbered(mark, &[("x1", spot.x), ("y1", spot.y), ("x2", x), ("y2", y)]));
            if number % apart != 0 || number == 0 {
                continue;
            }
            let text = number_of_mark(size * f64::from(number), (number + apart > last).then_some(unit));
            let (x, y) = if upright {
                (self.plus(spot.x, -10.0), self.plus(spot.y, 4.0))
            } else {
                (spot.x, self.plus(spot.y, 19.0))
            };
            let label = self.mark_text(text, &[("text-anchor", if upright { "end" } else { "middle" })]);
            children.push(self.numbered(label, &[("x", x), ("y", y)]));
        }
        children
    }

    /// Position of a constant point in the drawing.
    fn fixed_spot(&mut self, [x, y]: [f64; 2]) -> Spot {
        let (x, y) = (self.constant(x), self.constant(y));
        let space = self.space().clone();
        space.spot(self.graph(), x, y)
    }
}
