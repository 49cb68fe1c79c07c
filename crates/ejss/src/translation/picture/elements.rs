//! Elements of a drawing panel and their counterparts.

use super::super::controls::text as constant_text;
use super::super::facts::Facts;
use super::super::plots::quantity;
use super::super::run::{Phase, Run};
use super::super::value::Value;
use super::item::{Item, is_state};
use super::text;
use crate::place::{Place, Section};
use crate::reading::Files;
use crate::refusal::Obstacle;
use crate::report::{EntryKind, Report};
use crate::script::{Node, Operator, parse_expression};
use crate::simulation::{Element, Simulation};
use units::words;

/// Greatest depth of groups.
const DEEPEST: usize = 8;
/// Colours of CSS that pass from the view into the drawing.
const COLOURS: [&str; 28] = [
    "red",
    "green",
    "blue",
    "yellow",
    "orange",
    "black",
    "white",
    "gray",
    "grey",
    "cyan",
    "magenta",
    "pink",
    "purple",
    "brown",
    "darkgreen",
    "darkblue",
    "darkred",
    "lightblue",
    "lightgreen",
    "lightgray",
    "darkgray",
    "gold",
    "silver",
    "navy",
    "olive",
    "teal",
    "maroon",
    "none",
];

/// Kinds of elements with a counterpart.
const DRAWN: [&str; 9] =
    ["Shape2D", "Segment2D", "Arrow2D", "Spring2D", "Text2D", "Image2D", "Trail2D", "Trace", "Group2D"];

/// True for an element that the drawing carries over.
pub(crate) fn is_drawn(kind: &str) -> bool {
    DRAWN.contains(&kind)
}

/// Items for the elements directly inside a container.
pub(super) fn items(
    simulation: &Simulation,
    container: usize,
    facts: &Facts,
    files: &Files,
    report: &mut Report,
) -> Vec<Item> {
    let scene = Scene { simulation, facts, files };
    scene.inside(container, 0, report)
}

struct Scene<'a> {
    simulation: &'a Simulation,
    facts: &'a Facts,
    files: &'a Files,
}

impl Scene<'_> {
    fn inside(&self, container: usize, depth: usize, report: &mut Report) -> Vec<Item> {
        let mut items = Vec::new();
        for (index, element) in
            self.simulation.view.iter().enumerate().filter(|(_, element)| element.parent == Some(container))
        {
            if !is_drawn(&element.kind) {
                continue;
            }
            let place = Place::new(Section::View, &element.name);
            match self.item(index, element, depth, report) {
                Ok(Some(item)) => items.push(item),
                Ok(None) => {}
                Err(obstacle) => {
                    let why = obstacle.words();
                    report.add(EntryKind::Left, place, words!("The element is not carried over: {why}."));
                }
            }
        }
        items
    }

    /// Counterpart of an element; `None` for one that is never visible.
    fn item(
        &self,
        index: usize,
        element: &Element,
        depth: usize,
        report: &mut Report,
    ) -> Result<Option<Item>, Obstacle> {
        let visible = match element.property("Visibility").or_else(|| element.property("Visible")) {
            None => None,
            Some(text) => match self.condition(text)? {
                Value::Truth(true) => None,
                Value::Truth(false) => return Ok(None),
                condition => Some(condition),
            },
        };
        let mut item = match element.kind.as_str() {
            "Group2D" => self.group(index, element, depth, report)?,
            "Shape2D" => self.shape(element)?,
            "Segment2D" => self.between(element, "line")?,
            "Spring2D" => self.between(element, "spring")?,
            "Arrow2D" => self.arrow(element)?,
            "Text2D" => self.text(element)?,
            "Image2D" => self.image(element)?,
            _ => self.trail(element)?,
        };
        item.name.clone_from(&element.name);
        item.visible = visible;
        if element.kind != "Group2D" {
            self.drag(element, &mut item, report);
        }
        Ok(Some(item))
    }

    fn number(&self, element: &Element, property: &str, default: f64) -> Result<Value, Obstacle> {
        element.property(property).map_or_else(|| Ok(Value::number(default)), |text| quantity(self.facts, text))
    }

    fn condition(&self, text: &str) -> Result<Value, Obstacle> {
        let expression = parse_expression(text).map_err(|unreadable| unreadable.obstacle)?;
        let mut run = Run::new(self.facts, Phase::Function, Place::new(Section::View, ""));
        run.truth(&expression).map_err(|reason| reason.obstacle)
    }

    /// A pair of properties, or one with an array of two.
    fn pair(&self, element: &Element, names: [&str; 3], default: f64) -> Result<[Value; 2], Obstacle> {
        if let Some(text) = element.property(names[2]) {
            let parts = match parse_expression(text).map_err(|unreadable| unreadable.obstacle)?.node {
                Node::Array(parts) => parts,
                _ => return Err(Obstacle::Array(text.chars().take(20).collect())),
            };
            let mut run = Run::new(self.facts, Phase::Function, Place::new(Section::View, ""));
            let mut part = |at: usize| match parts.get(at) {
                Some(part) => run.numeric(part).map_err(|reason| reason.obstacle),
                None => Err(Obstacle::NoValue(names[2].to_owned())),
            };
            return Ok([part(0)?, part(1)?]);
        }
        Ok([self.number(element, names[0], default)?, self.number(element, names[1], default)?])
    }

    fn position(&self, element: &Element) -> Result<[Value; 2], Obstacle> {
        self.pair(element, ["X", "Y", "Position"], 0.0)
    }

    fn size(&self, element: &Element) -> Result<[Value; 2], Obstacle> {
        self.pair(element, ["SizeX", "SizeY", "Size"], 0.1)
    }

    fn group(&self, index: usize, element: &Element, depth: usize, report: &mut Report) -> Result<Item, Obstacle> {
        if depth >= DEEPEST {
            return Err(Obstacle::TooLong);
        }
        for property in ["SizeX", "SizeY", "Size"] {
            if element.property(property).is_some_and(|size| size != "1") {
                return Err(Obstacle::Statement(property.to_owned()));
            }
        }
        let mut item = Item { tag: "g", points: vec![("at", self.position(element)?)], ..Item::default() };
        if let Some(text) = element.property("Transformation").or_else(|| element.property("Angle")) {
            item.angles.push(("turn", quantity(self.facts, text)?));
        }
        item.children = self.inside(index, depth + 1, report);
        Ok(item)
    }

    fn shape(&self, element: &Element) -> Result<Item, Obstacle> {
        let [width, height] = self.size(element)?;
        let kind = constant_text(element, "ShapeType").unwrap_or_else(|| "ELLIPSE".to_owned());
        let is_pixels = element.property("PixelSize") == Some("true");
        let mut item = Item { points: vec![("at", self.position(element)?)], ..Item::default() };
        if kind == "NONE" {
            return Err(Obstacle::Statement("ShapeType".to_owned()));
        }
        let is_round = !kind.contains("RECTANGLE");
        if is_pixels {
            item.tag = "circle";
            let pixels = |value: &Value| value.constant(&|_| None);
            let radius = pixels(&width).zip(pixels(&height)).map(|(width, height)| (width + height) / 4.0);
            let radius = radius.ok_or_else(|| Obstacle::Statement("PixelSize".to_owned()))?;
            item.plain.push(("r", format!("{}px", units::number::shortest(radius))));
        } else if is_round && width == height {
            item.tag = "circle";
            item.lengths.push(("r", half(width)));
        } else if is_round {
            item.tag = "ellipse";
            item.lengths.extend([("rx", half(width)), ("ry", half(height))]);
        } else {
            item.tag = "rect";
            item.points.push(("size", [width, height]));
        }
        if element.property("Transformation").is_some() {
            return Err(Obstacle::Statement("Transformation".to_owned()));
        }
        item.plain.push(("fill", colour(element, "FillColor").unwrap_or_else(|| "accent".to_owned())));
        if let Some(line) = colour(element, "LineColor") {
            item.plain.push(("stroke", line));
        }
        Ok(item)
    }

    /// Element from a point along a size.
    fn between(&self, element: &Element, tag: &'static str) -> Result<Item, Obstacle> {
        let from = self.position(element)?;
        let [width, height] = self.size(element)?;
        let [x, y] = from.clone();
        let points = vec![("from", from), ("to", [sum(x, width), sum(y, height)])];
        let mut item = Item { tag, points, ..Item::default() };
        if tag == "line" {
            item.plain.push(("stroke", colour(element, "LineColor").unwrap_or_else(|| "text".to_owned())));
            item.plain.push(("stroke-width", "2".to_owned()));
        }
        Ok(item)
    }

    fn arrow(&self, element: &Element) -> Result<Item, Obstacle> {
        let points = vec![("at", self.position(element)?), ("vector", self.size(element)?)];
        let mut item = Item { tag: "arrow", points, ..Item::default() };
        if let Some(line) = colour(element, "LineColor").or_else(|| colour(element, "FillColor")) {
            item.plain.push(("stroke", line));
        }
        Ok(item)
    }

    fn text(&self, element: &Element) -> Result<Item, Obstacle> {
        let source = element.property("Text").ok_or_else(|| Obstacle::NoValue("Text".to_owned()))?;
        let text = text::parts(self.facts, source)?;
        Ok(Item { tag: "label", points: vec![("at", self.position(element)?)], text, ..Item::default() })
    }

    fn image(&self, element: &Element) -> Result<Item, Obstacle> {
        let path = constant_text(element, "ImageUrl").ok_or_else(|| Obstacle::NoValue("ImageUrl".to_owned()))?;
        let address = self.files.picture(&path).ok_or_else(|| Obstacle::View(path.chars().take(40).collect()))?;
        let points = vec![("at", self.position(element)?), ("size", self.size(element)?)];
        Ok(Item { tag: "image", points, plain: vec![("href", address)], ..Item::default() })
    }

    fn trail(&self, element: &Element) -> Result<Item, Obstacle> {
        let at = self.pair(element, ["InputX", "InputY", "Input"], 0.0)?;
        let mut item = Item { tag: "trail", points: vec![("at", at)], ..Item::default() };
        if let Some(line) = colour(element, "LineColor") {
            item.plain.push(("stroke", line));
        }
        Ok(item)
    }

    /// A position that can be dragged along a state is carried over; any other drag is reported.
    fn drag(&self, element: &Element, item: &mut Item, report: &mut Report) {
        let enabled = element.property("EnabledPosition").unwrap_or_default().trim_matches('"').to_owned();
        if enabled.is_empty() || enabled == "false" || enabled == "ENABLED_NONE" {
            return;
        }
        let state = item.points.first().and_then(|(_, [x, y])| {
            let (may_x, may_y) = (enabled != "ENABLED_Y", enabled != "ENABLED_X");
            let along = [(may_x, x), (may_y, y)].into_iter().filter(|(may, value)| *may && is_state(self.facts, value));
            along.map(|(_, value)| value).next()
        });
        let place = Place::new(Section::View, &element.name);
        match state {
            Some(Value::Name(name)) => item.drag = Some(name.clone()),
            _ => report.add(
                EntryKind::Left,
                place,
                words!("Dragging this element is not carried over: its place is no state."),
            ),
        }
    }
}

fn half(value: Value) -> Value {
    match value.constant(&|_| None) {
        Some(number) => Value::number(number / 2.0),
        None => Value::binary(Operator::Over, value, Value::number(2.0)),
    }
}

/// Sum of two values, with its numbers added up: `-0.3 + (x + 0.27)` is `x - 0.03`.
fn sum(left: Value, right: Value) -> Value {
    let mut number = 0.0;
    let mut terms: Vec<(bool, Value)> = Vec::new();
    collect(left, false, &mut number, &mut terms);
    collect(right, false, &mut number, &mut terms);
    // A sum of decimal numbers has further digits from rounding.
    let number = (number * 1e12).round() / 1e12;
    let mut result: Option<Value> = None;
    for (is_negative, term) in terms {
        result = Some(match (result, is_negative) {
            (None, false) => term,
            (None, true) => term.negative(),
            (Some(sum), false) => Value::binary(Operator::Plus, sum, term),
            (Some(sum), true) => Value::binary(Operator::Minus, sum, term),
        });
    }
    match result {
        None => Value::number(number),
        Some(sum) if number == 0.0 => sum,
        Some(sum) if number < 0.0 => Value::binary(Operator::Minus, sum, Value::number(-number)),
        Some(sum) => Value::binary(Operator::Plus, sum, Value::number(number)),
    }
}

fn collect(value: Value, is_negative: bool, number: &mut f64, terms: &mut Vec<(bool, Value)>) {
    match value {
        Value::Number(_, own) => *number += if is_negative { -own } else { own },
        Value::Negative(inner) => collect(*inner, !is_negative, number, terms),
        Value::Binary(Operator::Plus, left, right) => {
            collect(*left, is_negative, number, terms);
            collect(*right, is_negative, number, terms);
        }
        Value::Binary(Operator::Minus, left, right) => {
            collect(*left, is_negative, number, terms);
            collect(*right, !is_negative, number, terms);
        }
        other => terms.push((is_negative, other)),
    }
}

/// Colour of a property, if it is a constant that a drawing may have.
fn colour(element: &Element, property: &str) -> Option<String> {
    let name = constant_text(element, property)?.to_ascii_lowercase();
    if let Some(parts) = name.strip_prefix("rgb").map(|parts| parts.trim_start_matches('a').trim_matches(['(', ')'])) {
        let parts: Vec<u8> = parts.split(',').filter_map(|part| part.trim().parse().ok()).collect();
        let [red, green, blue, ..] = parts.as_slice() else { return None };
        return Some(format!("#{red:02x}{green:02x}{blue:02x}"));
    }
    let is_hexadecimal = name
        .strip_prefix('#')
        .is_some_and(|digits| digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit()));
    (COLOURS.contains(&name.as_str()) || is_hexadecimal).then_some(name)
}
