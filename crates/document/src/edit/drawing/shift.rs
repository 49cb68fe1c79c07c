//! Moves, resizes and turns elements.

use super::attribute::{attribute_edit, expect_attributes};
use super::distance::Measure;
use super::expect::{drawing, item};
use crate::drawing::{Grip, Item, components};
use crate::edit::{Edit, EditError, apply};
use crate::scene::{Step, steps};
use crate::text::outline::Outline;
use model::Span;
use std::f64::consts::PI;

/// Moves a grip of an element by `by` in the lengths of its place (SI, or units of the drawing): to the right and upwards
/// in a frame, to the right and downwards outside. The corner and the edge of a turned element move along its own sides. An
/// expression keeps its quantities and gets a distance added. [`Grip::Turn`] is moved by `by[0]`, an angle in radians,
/// counterclockwise in a frame and clockwise outside; `measure.step` is then an angle.
///
/// # Errors
///
/// The errors of [`set_attribute`](super::set_attribute), and [`EditError::NotAPoint`] if a place is written in a form that
/// cannot be moved.
pub fn shift(
    outline: &Outline,
    number: usize,
    grip: Grip,
    by: [f64; 2],
    measure: &Measure,
) -> Result<Vec<Edit>, EditError> {
    let drawing = drawing(outline)?;
    let item = item(&drawing, number)?;
    let changed = Changes { source: outline.source(), item, measure }.of(grip, by)?;
    let edits = changed.iter().map(|(name, text)| attribute_edit(outline.source(), item, name, text)).collect();
    let changed: Vec<(&str, &str)> = changed.iter().map(|(name, text)| (*name, text.as_str())).collect();
    expect_attributes(outline, &drawing, edits, number, &changed)
}

struct Changes<'a> {
    source: &'a str,
    item: &'a Item,
    measure: &'a Measure,
}

type Changed = Vec<(&'static str, String)>;

impl Changes<'_> {
    fn of(&self, grip: Grip, by: [f64; 2]) -> Result<Changed, EditError> {
        match grip {
            Grip::Whole => self.whole(by),
            Grip::Beginning => self.end(("from", ["x1", "y1"]), by),
            Grip::End => self.end(("to", ["x2", "y2"]), by),
            Grip::Corner => self.corner(by),
            Grip::Edge => self.edge(by),
            Grip::Turn => Ok(vec![("turn", self.turned(by[0]))]),
        }
    }

    fn text(&self, name: &str) -> Option<&str> {
        self.item.value(self.source, name)
    }

    fn has(&self, name: &str) -> bool {
        self.item.attribute(name).is_some()
    }

    fn whole(&self, by: [f64; 2]) -> Result<Changed, EditError> {
        let mut changed = Vec::new();
        let is_arc = self.item.kind.name == "angle";
        for name in ["at", "from", "to"] {
            if self.has(name) && !(is_arc && name != "at") {
                changed.push((name, self.point(name, by)?));
            }
        }
        if changed.is_empty() {
            for (names, by) in [(["x", "cx", "x1", "x2"], by[0]), (["y", "cy", "y1", "y2"], by[1])] {
                for name in names.into_iter().filter(|name| self.has(name)) {
                    changed.push((name, self.number(name, by)?));
                }
            }
        }
        if changed.is_empty() && self.item.framed {
            let name = match self.item.kind.name {
                "polyline" | "polygon" => "points",
                "path" => "d",
                // A group without `at` is at the origin of the frame.
                "g" => return Ok(vec![("at", self.measure.point(by))]),
                _ => return Err(EditError::NotAPoint),
            };
            changed.push((name, self.points(name, by)?));
        }
        if changed.is_empty() {
            changed.push(("transform", self.translated(by)?));
        }
        Ok(changed)
    }

    fn end(&self, (name, [x, y]): (&'static str, [&'static str; 2]), by: [f64; 2]) -> Result<Changed, EditError> {
        if self.has(name) {
            return Ok(vec![(name, self.point(name, by)?)]);
        }
        Ok(vec![(x, self.number(x, by[0])?), (y, self.number(y, by[1])?)])
    }

    /// Changes of the lower right corner. The element keeps its centre with `at`, and its left lower or upper corner with
    /// `x` and `y`.
    fn corner(&self, by: [f64; 2]) -> Result<Changed, EditError> {
        let down = if self.item.framed { -by[1] } else { by[1] };
        let both = if self.has("at") { 2.0 } else { 1.0 };
        if let Some(size) = self.item.attribute("size") {
            let grow = |_: usize, text: &str, by: f64| self.measure.grown(text, by);
            return Ok(vec![("size", self.pair(size.value, [both * by[0], both * down], grow)?)]);
        }
        let length = |name: &'static str, by: f64| -> Result<(&'static str, String), EditError> {
            Ok((name, self.grown(name, by)?))
        };
        // In a frame, `y` is the lower edge, which stays; the upper corner is moved.
        let down = if self.item.framed && !self.has("at") { by[1] } else { down };
        Ok(vec![length("width", both * by[0])?, length("height", both * down)?])
    }

    fn edge(&self, by: [f64; 2]) -> Result<Changed, EditError> {
        let radius = if self.has("r") {
            self.grown("r", by[0])?
        } else {
            self.measure.grown(&format!("{}px", self.item.usual_radius()), by[0])
        };
        Ok(vec![("r", radius)])
    }

    fn turned(&self, by: f64) -> String {
        let degrees = Measure { unit: "deg".to_owned(), step: self.measure.step, scale: 1.0 };
        let (brace, text) = unbraced(self.text("turn").unwrap_or("0"));
        braced(brace, degrees.moved(text, by))
    }

    /// Text of a point, with its pair moved.
    fn point(&self, name: &str, by: [f64; 2]) -> Result<String, EditError> {
        let value = self.item.attribute(name).ok_or(EditError::NotAPoint)?.value;
        let moved = self.pair(value, by, |_, text, by| self.measure.moved(text, by));
        // All pairs have factors, or the point is the name of a vector.
        moved.or_else(|_| Ok(format!("{} + {}", self.source[value.range()].trim(), self.measure.point(by))))
    }

    /// Text of a value, with its pair changed.
    fn pair(
        &self,
        value: Span,
        by: [f64; 2],
        change: impl Fn(usize, &str, f64) -> String,
    ) -> Result<String, EditError> {
        let (first, second) = components(self.source, value).ok_or(EditError::NotAPoint)?;
        let one = |number: usize, range: &std::ops::Range<usize>| {
            let place = crate::text::source::trim(self.source, range.clone());
            Edit {
                text: change(number, &self.source[place.clone()], by[number]),
                span: Span::new(place.start, place.end),
            }
        };
        self.edited(value, vec![one(0, &first), one(1, &second)])
    }

    /// Text of a numeric attribute, with or without braces.
    fn number(&self, name: &str, by: f64) -> Result<String, EditError> {
        let (brace, text) = unbraced(self.text(name).ok_or(EditError::NotAPoint)?);
        self.changed_number(brace, self.measure.moved(text, by))
    }

    fn grown(&self, name: &str, by: f64) -> Result<String, EditError> {
        let (brace, text) = unbraced(self.text(name).ok_or(EditError::NotAPoint)?);
        self.changed_number(brace, self.measure.grown(text, by))
    }

    /// Outside frames, expressions are allowed only in braces.
    fn changed_number(&self, brace: bool, text: String) -> Result<String, EditError> {
        let is_number = text.parse::<f64>().is_ok();
        if self.item.framed || brace || is_number { Ok(braced(brace, text)) } else { Err(EditError::NotAPoint) }
    }

    /// Text of a list of points, with each point moved.
    fn points(&self, name: &str, by: [f64; 2]) -> Result<String, EditError> {
        let value = self.item.attribute(name).ok_or(EditError::NotAPoint)?.value;
        let text = &self.source[value.range()];
        // For computed points, the point stands before `for`.
        let end = text.find(" for ").map_or(value.end, |length| value.start + length);
        let steps = steps(self.source, value.start..end, "MLQCTSZ").map_err(|_| EditError::NotAPoint)?;
        let mut edits = Vec::new();
        for step in steps {
            let Step::Point(pair) = step else { continue };
            for (range, by) in [(pair.first, by[0]), (pair.second, by[1])] {
                let place = crate::text::source::trim(self.source, range);
                let text = self.measure.moved(&self.source[place.clone()], by);
                edits.push(Edit { span: Span::new(place.start, place.end), text });
            }
        }
        self.edited(value, edits)
    }

    /// Text of a value after edits of its parts.
    fn edited(&self, value: Span, edits: Vec<Edit>) -> Result<String, EditError> {
        let within = |edit: Edit| Edit {
            span: Span::new(edit.span.start - value.start, edit.span.end - value.start),
            text: edit.text,
        };
        let edits: Vec<Edit> = edits.into_iter().map(within).collect();
        apply(&self.source[value.range()], &edits)
    }

    /// `transform` for an element without a position of its own.
    fn translated(&self, by: [f64; 2]) -> Result<String, EditError> {
        let before = self.text("transform").unwrap_or_default();
        let (old, rest) = match before.strip_prefix("translate(").and_then(|rest| rest.split_once(')')) {
            Some((numbers, rest)) => (numbers, rest),
            None => ("0 0", before),
        };
        let numbers: Option<Vec<f64>> =
            old.split([' ', ',']).filter(|text| !text.is_empty()).map(|text| text.parse().ok()).collect();
        let numbers = numbers.filter(|numbers| !numbers.is_empty()).ok_or(EditError::NotAPoint)?;
        let at = |place: usize| numbers.get(place).copied().unwrap_or(0.0).to_string();
        let (x, y) = (self.measure.moved(&at(0), by[0]), self.measure.moved(&at(1), by[1]));
        let separator = if rest.is_empty() || rest.starts_with(' ') { "" } else { " " };
        Ok(format!("translate({x} {y}){separator}{rest}"))
    }
}

impl Measure {
    /// Text of a point in the units in which the element states its points.
    pub(super) fn point(&self, [x, y]: [f64; 2]) -> String {
        format!("({}, {})", self.moved("0", x), self.moved("0", y))
    }

    /// Measure for angles, with a step in degrees.
    pub fn degrees(step: f64) -> Self {
        Self { unit: "deg".to_owned(), step: step * PI / 180.0, scale: 1.0 }
    }
}

/// Removes braces around a value. The flag is true if there were braces.
fn unbraced(text: &str) -> (bool, &str) {
    let text = text.trim();
    match text.strip_prefix('{').and_then(|text| text.strip_suffix('}')) {
        Some(inner) if !inner.contains(['{', '}']) => (true, inner.trim()),
        _ => (false, text),
    }
}

fn braced(brace: bool, text: String) -> String {
    if brace { format!("{{{text}}}") } else { text }
}
