//! Controls of the view: which variables a reader sets or sees, with their ranges and labels.

use super::facts::Facts;
use super::run::{Phase, Run};
use crate::place::{Place, Section};
use crate::prose::plain_text;
use crate::script::{Node, parse_expression};
use crate::simulation::{Element, Simulation};
use units::Unit;

/// Greatest number of names that lead to a constant.
const MOST_STEPS: usize = 6;

/// Control of a variable.
#[derive(Clone, Debug)]
pub(super) struct Control {
    /// Name of the variable.
    pub variable: String,
    /// Smallest and greatest value.
    pub range: Option<(f64, f64)>,
    pub step: Option<f64>,
    pub label: Label,
    /// False for a field that only shows its value.
    pub is_editable: bool,
    pub place: Place,
}

/// Label with the unit that stands in it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Label {
    pub text: String,
    pub unit: Option<String>,
}

/// Kinds of elements that set or show a number or truth value, with the properties that may name it.
const KINDS: [(&str, &[&str]); 9] = [
    ("Slider", &["Value", "Variable"]),
    ("ParsedField", &["Value", "Variable"]),
    ("NumberField", &["Value", "Variable"]),
    ("Field", &["Value", "Variable"]),
    ("FunctionField", &["Value", "Variable"]),
    ("CheckBox", &["Checked", "Selected", "Variable"]),
    ("RadioButton", &["Checked", "Selected", "Variable"]),
    ("Label", &["Text"]),
    ("ProgressBar", &["Value"]),
];

/// Controls in the order of the view.
pub(super) fn controls(simulation: &Simulation, facts: &Facts) -> Vec<Control> {
    let mut controls = Vec::new();
    for (index, element) in simulation.view.iter().enumerate() {
        let Some((kind, properties)) = KINDS.into_iter().find(|(kind, _)| *kind == element.kind) else { continue };
        let name = properties.iter().find_map(|property| element.property(property));
        let Some(variable) = name.filter(|name| facts.variable(name).is_some()) else { continue };
        let number = |property: &str| element.property(property).and_then(|text| constant(facts, text));
        let range = number("Minimum").zip(number("Maximum")).filter(|(low, high)| low < high);
        controls.push(Control {
            variable: variable.to_owned(),
            range: if kind == "Slider" { range.or(Some((0.0, 1.0))) } else { range },
            step: number("Step").or_else(|| number("Increment")).filter(|step| *step > 0.0),
            label: label_of(simulation, index),
            is_editable: kind != "Label" && kind != "ProgressBar" && element.property("Editable") != Some("false"),
            place: Place::new(Section::View, &element.name),
        });
    }
    controls
}

/// Number of a constant expression, with the values of the tables.
pub(super) fn constant(facts: &Facts, text: &str) -> Option<f64> {
    constant_within(facts, text, MOST_STEPS)
}

fn constant_within(facts: &Facts, text: &str, steps: usize) -> Option<f64> {
    let steps = steps.checked_sub(1)?;
    let expression = parse_expression(text).ok()?;
    let mut run = Run::new(facts, Phase::Function, Place::new(Section::View, ""));
    run.value(&expression).ok()?.constant(&|name| constant_within(facts, &facts.variable(name)?.value, steps))
}

/// Constant text of a property.
pub(super) fn text(element: &Element, property: &str) -> Option<String> {
    match parse_expression(element.property(property)?).ok()?.node {
        Node::Text(text) => Some(plain_text(&text)),
        _ => None,
    }
}

/// Text of the label before an element in the same container, or of the element itself.
fn label_of(simulation: &Simulation, index: usize) -> Label {
    let Some(element) = simulation.view.get(index) else { return Label::default() };
    if let Some(own) = text(element, "Text").filter(|text| !text.is_empty() && element.kind != "Label") {
        return label(&own);
    }
    let before =
        simulation.view.get(..index).unwrap_or_default().iter().rev().find(|other| other.parent == element.parent);
    let text = before.filter(|before| before.kind == "Label").and_then(|before| text(before, "Text"));
    if let Some(text) = text {
        return label(&text);
    }
    // Sliders may show a format such as "k = 0.00 N/m".
    let format = element.property("Format").and_then(|_| self::text(element, "Format"));
    format
        .filter(|format| format.contains('='))
        .map(|format| label(format.split('=').next().unwrap_or_default()))
        .unwrap_or_default()
}

/// Text and unit of a label such as `k [N/m] = ` or `mass (kg)`.
pub(super) fn label(text: &str) -> Label {
    let text = text.trim().trim_end_matches(['=', ':', ' ', '\u{a0}']).trim_end();
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some(inner) = text.strip_suffix(close)
            && let Some((before, unit)) = inner.rsplit_once(open)
            && let Some(unit) = unit_of(unit)
        {
            return Label { text: tidy(before), unit: Some(unit) };
        }
    }
    Label { text: tidy(text), unit: None }
}

/// A unit of the language, as it writes it.
fn unit_of(text: &str) -> Option<String> {
    let text = text.trim().replace('·', " ").replace("²", "^2").replace("³", "^3").replace('\u{ba}', "°");
    let unit = match text.as_str() {
        "seg" | "sec" => "s",
        "grados" | "degrees" => "deg",
        _ => &text,
    };
    (!unit.is_empty() && Unit::parse(unit).is_ok()).then(|| unit.to_owned())
}

fn tidy(text: &str) -> String {
    let text = text.trim().trim_end_matches(['=', ':', ',']).trim();
    let text: String = text.chars().filter(|letter| !matches!(letter, '"' | '`' | '{' | '}' | '\\')).take(60).collect();
    text.trim().to_owned()
}
