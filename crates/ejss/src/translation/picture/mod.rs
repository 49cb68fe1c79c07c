//! The drawing of a simulation with one drawing panel: shapes, segments, arrows, springs, texts, pictures and trails.

mod elements;
mod item;
mod text;

use super::controls::constant;
use super::facts::Facts;
use super::plots::inside;
use super::value::Value;
use super::writing::written;
use crate::place::{Place, Section};
use crate::reading::Files;
use crate::report::{EntryKind, Report};
use crate::script::Operator;
use crate::simulation::Simulation;
pub(crate) use elements::is_drawn;
use item::{Item, in_text};
use std::fmt::Write as _;
use units::number::shortest;
use units::words;

/// Width of the drawing, in its units.
const WIDTH: f64 = 400.0;

/// Drawing.
#[derive(Clone, Debug)]
pub(super) struct Picture {
    /// Ranges of the axes.
    x: (f64, f64),
    y: (f64, f64),
    height: f64,
    items: Vec<Item>,
}

/// The drawing of the first drawing panel; what it lacks is reported.
pub(super) fn picture(simulation: &Simulation, facts: &Facts, files: &Files, report: &mut Report) -> Option<Picture> {
    let mut panels = simulation.view.iter().enumerate().filter(|(_, element)| element.kind == "DrawingPanel");
    let (index, panel) = panels.next()?;
    for (_, other) in panels {
        let place = Place::new(Section::View, &other.name);
        report.add(EntryKind::Left, place, words!("The drawing panel is not carried over: only the first one is."));
    }
    let place = Place::new(Section::View, &panel.name);
    let mut bound = |property: &str, default: f64| match panel.property(property) {
        None => default,
        Some(text) => {
            if !text.trim_start_matches('-').starts_with(|first: char| first.is_ascii_digit() || first == '.') {
                report.add(
                    EntryKind::Changed,
                    place.clone(),
                    words!("The range of the panel depends on quantities. Here it is the one at the start."),
                );
            }
            constant(facts, text).unwrap_or(default)
        }
    };
    let (x, y) = ((bound("MinimumX", -1.0), bound("MaximumX", 1.0)), (bound("MinimumY", -1.0), bound("MaximumY", 1.0)));
    let (width, height) = (x.1 - x.0, y.1 - y.0);
    if !(width > 0.0 && height > 0.0 && (width / height).is_finite()) {
        report.add(EntryKind::Left, place, words!("The drawing is not carried over: its panel has no range."));
        return None;
    }
    if panel.property("SquareAspect") != Some("true") && !(0.6..1.7).contains(&(width / height)) {
        report.add(
            EntryKind::Changed,
            place,
            words!("The panel has different scales on its axes. Here the scale is the same on both."),
        );
    }
    let items = elements::items(simulation, index, facts, files, report);
    // Elements inside groups that are no elements of the drawing are listed with the view.
    let is_empty = items.is_empty() || inside(simulation, index).is_empty();
    (!is_empty).then_some(Picture { x, y, height: (WIDTH * height / width).clamp(80.0, 800.0).round(), items })
}

impl Picture {
    /// Removes the elements that need a quantity without a value.
    pub fn keep(&mut self, is_known: &dyn Fn(&Value) -> bool, report: &mut Report) {
        keep(&mut self.items, is_known, report);
    }

    /// All values of the drawing.
    pub fn values(&self) -> Vec<&Value> {
        self.items.iter().flat_map(Item::values).collect()
    }

    /// Name of a quantity that is a coordinate by itself: its unit is that of the axes.
    pub fn quantity(&self) -> Option<&str> {
        self.items.iter().find_map(Item::quantity)
    }

    /// Lines of the drawing. `unit`: of the axes.
    pub fn lines(&self, title: &str, unit: Option<&str>, spelling: &dyn Fn(&str) -> String) -> Vec<String> {
        let range = |(low, high): (f64, f64)| {
            let unit = unit.map(|unit| format!(" [{unit}]")).unwrap_or_default();
            format!("{}..{}{unit}", shortest(low), shortest(high))
        };
        let mut lines = vec![format!("<svg viewBox=\"0 0 {} {}\">", shortest(WIDTH), shortest(self.height))];
        lines.push(format!("  <title>{}</title>", in_text(&title.chars().take(40).collect::<String>())));
        lines.push(format!("  <frame x=\"{}\" y=\"{}\">", range(self.x), range(self.y)));
        let writer = Writer { unit, spelling };
        self.items.iter().for_each(|item| writer.item(item, 2, &mut lines));
        lines.push("  </frame>".to_owned());
        lines.push("</svg>".to_owned());
        lines
    }
}

fn keep(items: &mut Vec<Item>, is_known: &dyn Fn(&Value) -> bool, report: &mut Report) {
    items.retain_mut(|item| {
        keep(&mut item.children, is_known, report);
        if let Some(visible) = item.visible.clone().filter(|visible| !is_known(visible)) {
            let _ = visible;
            item.visible = None;
            report.add(
                EntryKind::Changed,
                Place::new(Section::View, &item.name),
                words!("The element is always visible here."),
            );
        }
        let mut own = Item { children: Vec::new(), ..item.clone() };
        own.visible = None;
        let known = own.values().into_iter().all(is_known);
        if !known {
            report.add(
                EntryKind::Left,
                Place::new(Section::View, &item.name),
                words!("The element is not carried over: it needs a quantity that is not carried over."),
            );
        }
        known && (item.tag != "g" || !item.children.is_empty())
    });
}

/// Writes elements.
struct Writer<'a> {
    unit: Option<&'a str>,
    spelling: &'a dyn Fn(&str) -> String,
}

impl Writer<'_> {
    fn item(&self, item: &Item, depth: usize, lines: &mut Vec<String>) {
        let mut line = format!("{}<{}", "  ".repeat(depth), item.tag);
        for (name, [x, y]) in &item.points {
            let _ = write!(line, " {name}=\"({}, {})\"", self.length(x), self.length(y));
        }
        for (name, length) in &item.lengths {
            let _ = write!(line, " {name}=\"{}\"", self.length(length));
        }
        for (name, angle) in &item.angles {
            let _ = write!(line, " {name}=\"{}\"", in_attribute(&written(angle, self.spelling)));
        }
        for (name, text) in &item.plain {
            let _ = write!(line, " {name}=\"{}\"", in_attribute(text));
        }
        if let Some(drag) = &item.drag {
            let _ = write!(line, " drag=\"{}\"", (self.spelling)(drag));
        }
        if let Some(visible) = &item.visible {
            let _ = write!(line, " visible=\"{}\"", in_attribute(&written(visible, self.spelling)));
        }
        if !item.children.is_empty() {
            lines.push(line + ">");
            item.children.iter().for_each(|child| self.item(child, depth + 1, lines));
            lines.push(format!("{}</{}>", "  ".repeat(depth), item.tag));
        } else if !item.text.is_empty() {
            lines.push(format!("{line}>{}</{}>", text::content(&item.text, self.spelling), item.tag));
        } else if item.drag.is_some() {
            lines.push(format!("{line}><title>{}</title></{}>", in_text(&item.name), item.tag));
        } else {
            lines.push(line + "/>");
        }
    }

    fn length(&self, value: &Value) -> String {
        let value = match self.unit {
            Some(unit) => with_unit(value, unit),
            None => value.clone(),
        };
        in_attribute(&written(&value, self.spelling))
    }
}

/// A value whose numbers that are lengths by themselves have the unit.
fn with_unit(value: &Value, unit: &str) -> Value {
    let inner = |value: &Value| Box::new(with_unit(value, unit));
    match value {
        Value::Number(text, number) if *number != 0.0 => Value::Number(format!("{text} [{unit}]"), *number),
        Value::Negative(value) => Value::Negative(inner(value)),
        Value::Binary(operator @ (Operator::Plus | Operator::Minus), left, right) => {
            Value::Binary(*operator, inner(left), inner(right))
        }
        other => other.clone(),
    }
}

fn in_attribute(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "'")
}
