//! Clips of several shapes, joined into one path. WebKit clips by a path only if the `clipPath` has a single shape. Otherwise it
//! draws a mask, which ends at the box around what is clipped without its strokes, and which paper does not have.

use super::builder::Builder;
use super::space::shapes::merged;
use model::{Diagnostic, Span};
use program::{Attribute, Binary, Child, Element, NodeId, Piece, Template};
use std::ops::Range;
use units::words;

/// Maximum number of shapes whose direction is unknown. Each doubles the path.
const MOST_UNKNOWN: usize = 4;

/// Values of the attributes of an element, by name.
type Given<'a> = dyn Fn(&str) -> Option<&'a Template> + 'a;

/// Outline of a shape.
struct Outline {
    /// Data of a path.
    data: Template,
    /// True if it is known to run clockwise.
    is_clockwise: bool,
}

impl Builder<'_, '_> {
    /// Joins the shapes of a `clipPath` into one path. Reports a clip that WebKit draws as a mask nevertheless.
    pub fn join_clip(&mut self, clip: &mut Element, place: Range<usize>) {
        let is_text =
            |child: &Child| matches!(child, Child::Element(text) if matches!(text.name.as_str(), "title" | "desc"));
        let shapes = clip.children.iter().filter(|child| !is_text(child)).filter_map(|child| match child {
            // A line has no area.
            Child::Element(shape) if shape.name != "line" => Some(shape.clone()),
            _ => None,
        });
        let shapes: Vec<Element> = shapes.collect();
        let has = |element: &Element, name: &str| element.attributes.iter().any(|attribute| attribute.name == name);
        let is_path = |shape: &Element| shape.name != "text" && !has(shape, "clip-path");
        let is_plain = !has(clip, "clip-path") && shapes.iter().all(is_path);
        if is_plain && shapes.len() < 2 {
            return;
        }
        let joins = is_plain && !has(clip, "clip-rule");
        let outlines = if joins { shapes.iter().map(|shape| self.clip_outline(shape)).collect() } else { None };
        let Some(data) = outlines.and_then(joined) else {
            let message = words("Safari cuts off strokes in this clip, and prints as if there were no clip");
            let nests = has(clip, "clip-path") || shapes.iter().any(|shape| has(shape, "clip-path"));
            let hint = if nests {
                words("clip a group by one of both, and a group around it by the other")
            } else {
                words(
                    "clip by one `<path>` whose `d` has all outlines one after the other, in the same direction, without `transform` \
                     and `class`",
                )
            };
            let place = Span::new(place.start, place.end);
            self.expressions.diagnostics.push(Diagnostic::warning("clip-shapes", message, place).with_hint(hint));
            return;
        };
        if !self.fits(data.len(), place) {
            return;
        }
        let attribute = |name: &str, value| Attribute { name: name.to_owned(), value };
        let rule = attribute("clip-rule", vec![Piece::Literal("nonzero".to_owned())]);
        let attributes = vec![attribute("d", data), rule];
        let path = Element { name: "path".to_owned(), attributes, children: Vec::new(), drag: None };
        clip.children.retain(is_text);
        clip.children.push(Child::Element(path));
    }

    /// The outline of a shape; `None` if an attribute makes it another one, or if it is none.
    fn clip_outline(&mut self, shape: &Element) -> Option<Outline> {
        let own: &[&str] = match shape.name.as_str() {
            "rect" => &["x", "y", "width", "height", "rx", "ry"],
            "circle" => &["cx", "cy", "r"],
            "ellipse" => &["cx", "cy", "rx", "ry"],
            "polygon" | "polyline" => &["points"],
            "path" => &["d"],
            _ => return None,
        };
        // Colours have no effect in a clip.
        let idle =
            |name: &str| name.starts_with("fill") || name.starts_with("stroke") || matches!(name, "id" | "opacity");
        let is_known = |name: &str| own.contains(&name) || idle(name);
        if !shape.children.is_empty() || !shape.attributes.iter().all(|attribute| is_known(&attribute.name)) {
            return None;
        }
        let given = |name: &str| {
            shape.attributes.iter().find(|attribute| attribute.name == name).map(|attribute| &attribute.value)
        };
        match shape.name.as_str() {
            "rect" => self.rectangle_outline(&given),
            "circle" | "ellipse" => self.ellipse_outline(&given),
            name => {
                let text = |text: &str| Piece::Literal(text.to_owned());
                // Relative to the origin, as the first command of a path is.
                let (before, data) = if name == "path" { ("M0 0", given("d")?) } else { ("M", given("points")?) };
                let data = [text(before)].into_iter().chain(data.iter().cloned()).chain([text("Z")]).collect();
                Some(Outline { data, is_clockwise: false })
            }
        }
    }

    /// Outline of a rectangle with square or round corners.
    fn rectangle_outline(&mut self, given: &Given) -> Option<Outline> {
        let [left, top] = [self.number(given("x"))?, self.number(given("y"))?];
        let [width, height] = [self.side(given("width"))?, self.side(given("height"))?];
        let [rx, ry] = [given("rx").or(given("ry")), given("ry").or(given("rx"))];
        let [rx, ry] = [self.side(rx)?, self.side(ry)?];
        let graph = self.graph();
        let half = graph.constant(0.5);
        let mut inside = |radius, side| {
            let most = graph.multiply(half, side);
            graph.binary(Binary::Minimum, radius, most)
        };
        let [rx, ry] = [inside(rx, width), inside(ry, height)];
        let [right, bottom] = [graph.add(left, width), graph.add(top, height)];
        let [first, last] = [graph.add(left, rx), graph.subtract(right, rx)];
        let [upper, lower] = [graph.add(top, ry), graph.subtract(bottom, ry)];
        let corners = [left, top, right, bottom];
        if [rx, ry].into_iter().any(|radius| graph.as_constant(radius) == Some(0.0)) {
            return self.clockwise("Ma bHcVdHaZ", &corners);
        }
        let pattern = "Me bHfAi j 0 0 1 c gVhAi j 0 0 1 f dHeAi j 0 0 1 a hVgAi j 0 0 1 e bZ";
        self.clockwise(pattern, &[&corners[..], &[first, last, upper, lower, rx, ry]].concat())
    }

    /// Outline of an ellipse of two semicircles.
    fn ellipse_outline(&mut self, given: &Given) -> Option<Outline> {
        let [x, y] = [self.number(given("cx"))?, self.number(given("cy"))?];
        let [rx, ry] = ["rx", "ry"].map(|own| given(own).or(given("r")));
        let [rx, ry] = [self.side(Some(rx?))?, self.side(Some(ry?))?];
        let [left, right] = [self.graph().subtract(x, rx), self.graph().add(x, rx)];
        self.clockwise("Ma bAd e 0 0 1 c bAd e 0 0 1 a bZ", &[left, y, right, rx, ry])
    }

    /// The outline that a pattern describes: `a`, `b` .. stand for the numbers.
    fn clockwise(&mut self, pattern: &str, numbers: &[NodeId]) -> Option<Outline> {
        let mut data = Vec::new();
        for letter in pattern.bytes() {
            data.push(match numbers.get(usize::from(letter.wrapping_sub(b'a'))) {
                Some(number) => self.drawn(*number)?,
                None => Piece::Literal(char::from(letter).to_string()),
            });
        }
        Some(Outline { data, is_clockwise: true })
    }

    /// The number that an attribute holds, 0 without one; `None` if it holds another thing.
    fn number(&mut self, value: Option<&Template>) -> Option<NodeId> {
        match value.map(Vec::as_slice) {
            None => Some(self.graph().constant(0.0)),
            Some([Piece::Literal(text)]) => text.trim().parse().ok().map(|number| self.graph().constant(number)),
            Some([Piece::Value { index, .. }]) => self.value_node(*index),
            Some(_) => None,
        }
    }

    /// The number that an attribute holds, at least 0: a shape whose side is negative is not drawn.
    fn side(&mut self, value: Option<&Template>) -> Option<NodeId> {
        let number = self.number(value)?;
        let zero = self.graph().constant(0.0);
        Some(self.graph().binary(Binary::Maximum, zero, number))
    }
}

/// Data of a path around the union of all outlines by the rule `nonzero`; `None` if too many have an unknown direction. An outline
/// that runs either way is repeated as often as all before it together and once more, so that turns around a point never add up to zero.
fn joined(mut outlines: Vec<Outline>) -> Option<Template> {
    outlines.sort_by_key(|outline| outline.is_clockwise);
    let unknown = outlines.iter().take_while(|outline| !outline.is_clockwise).count();
    if unknown > MOST_UNKNOWN {
        return None;
    }
    let times = |place: usize| 1 << place.min(unknown);
    let repeated =
        outlines.into_iter().enumerate().flat_map(|(place, outline)| std::iter::repeat_n(outline.data, times(place)));
    Some(merged(repeated.flatten().collect()))
}
