//! Parts of the view without a counterpart.

use crate::place::{Place, Section};
use crate::report::{EntryKind, Report, shown};
use crate::script::{Node, StatementKind, parse_program};
use crate::simulation::{Element, Simulation};
use crate::translation::{is_drawn, is_trail};
use units::words;

/// Containers, and elements outside of drawings that a document has by itself or that other parts of the import report.
const EXPECTED: [&str; 18] = [
    "Panel",
    "TabbedPanel",
    "Frame",
    "Window",
    "Dialog",
    "Separator",
    "Label",
    "DrawingPanel",
    "PlottingPanel",
    "Slider",
    "ParsedField",
    "NumberField",
    "Field",
    "CheckBox",
    "RadioButton",
    "ComboBox",
    "TwoStateButton",
    "Button",
];
/// Calls of the player, which the page has by itself.
const PLAYER: [&str; 9] =
    ["_play", "_pause", "_reset", "_initialize", "_step", "_update", "_resetView", "_playpause", "_togglePlay"];

/// Reports elements, code of elements and parts of the model that a document has no form for. `follows`: true for a variable
/// that follows the others by itself, so that code which sets it again is not needed.
pub(crate) fn report_view(simulation: &Simulation, follows: &dyn Fn(&str) -> bool, report: &mut Report) {
    for element in &simulation.view {
        let place = Place::new(Section::View, &element.name);
        if !EXPECTED.contains(&element.kind.as_str()) && !is_drawn(&element.kind) {
            let kind = shown(&element.kind);
            report.add(
                EntryKind::Left,
                Place::new(Section::View, ""),
                words!("Elements of the kind {kind} are not carried over."),
            );
        } else if is_drawn(&element.kind) && !is_trail(element) && is_in_plot(simulation, element) {
            report.add(EntryKind::Left, place.clone(), words!("The element is not carried over: it stands in a plot."));
        }
        // The code of combo boxes is read for choices.
        if element.kind == "ComboBox" {
            continue;
        }
        for (property, code) in element.properties.iter().filter(|(property, _)| is_action(property)) {
            if does_something(code, follows) {
                let property = shown(property);
                report.add(EntryKind::Left, place.clone(), words!("The code of {property} is not carried over."));
            }
        }
    }
    for class in &simulation.model_elements {
        let class = shown(class.rsplit('.').next().unwrap_or_default());
        report.add(
            EntryKind::Left,
            Place::new(Section::Elements, ""),
            words!("The element {class} of the model is not carried over."),
        );
    }
    if simulation.further_views > 0 {
        report.add(
            EntryKind::Left,
            Place::new(Section::View, ""),
            words!("Further views are not carried over: only the first one is."),
        );
    }
}

fn is_in_plot(simulation: &Simulation, element: &Element) -> bool {
    let mut parent = element.parent;
    for _ in 0..simulation.view.len() {
        match parent.and_then(|parent| simulation.view.get(parent)) {
            Some(container) if container.kind == "PlottingPanel" => return true,
            Some(container) => parent = container.parent,
            None => return false,
        }
    }
    false
}

fn is_action(property: &str) -> bool {
    property.starts_with("On") || property.ends_with("Click") || property.ends_with("Action")
}

/// True for code that does more than play, pause, step, restart, and set what follows by itself.
fn does_something(code: &str, follows: &dyn Fn(&str) -> bool) -> bool {
    let code = code.trim();
    if code.is_empty() || code.starts_with('%') && code.ends_with('%') {
        return false;
    }
    let Ok(statements) = parse_program(code) else { return true };
    statements.iter().any(|statement| match &statement.kind {
        StatementKind::Expression(expression) => match &expression.node {
            Node::Call(callee, _) => !callee.root().is_some_and(|root| PLAYER.contains(&root)),
            Node::Assignment(target, ..) => !target.name().is_some_and(follows),
            _ => true,
        },
        _ => true,
    })
}
