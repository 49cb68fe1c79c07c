//! Plots: the trails of plotting panels.

use super::controls::{label, text};
use super::facts::{Facts, Role};
use super::run::{Phase, Run};
use super::value::{Kind, Value};
use super::writing::{quoted, written};
use crate::place::{Place, Section};
use crate::refusal::Obstacle;
use crate::report::{EntryKind, Report};
use crate::script::parse_expression;
use crate::simulation::{Element, Simulation};
use units::words;

/// Plot with its curves.
#[derive(Clone, Debug)]
pub(super) struct Plot {
    pub title: String,
    pub curves: Vec<Value>,
    /// Quantity of the horizontal axis.
    pub against: Value,
    /// Unit in the title of the vertical axis.
    pub unit: Option<String>,
}

/// Plots of the view in its order. Curves without a counterpart are reported.
pub(super) fn plots(simulation: &Simulation, facts: &Facts, report: &mut Report) -> Vec<Plot> {
    let mut plots: Vec<Plot> = Vec::new();
    for (index, panel) in simulation.view.iter().enumerate().filter(|(_, element)| element.kind == "PlottingPanel") {
        let mut own: Vec<Plot> = Vec::new();
        for (_, trail) in inside(simulation, index).into_iter().filter(|(_, element)| is_trail(element)) {
            let place = Place::new(Section::View, &trail.name);
            match (axis(facts, trail, "InputX"), axis(facts, trail, "InputY")) {
                (Ok(x), Ok(y)) if moves(facts, &x) => match own.iter_mut().find(|plot| plot.against == x) {
                    Some(plot) if plot.curves.contains(&y) => {}
                    Some(plot) => plot.curves.push(y),
                    None => own.push(plot(panel, x, y)),
                },
                (Ok(_), Ok(_)) => {
                    report.add(
                        EntryKind::Left,
                        place,
                        words!("The curve is not carried over: its horizontal quantity does not change during a run."),
                    );
                }
                (Err(obstacle), _) | (_, Err(obstacle)) => {
                    let why = obstacle.words();
                    report.add(EntryKind::Left, place, words!("The curve is not carried over: {why}."));
                }
            }
        }
        plots.append(&mut own);
    }
    plots
}

/// Elements inside a container, at any depth.
pub(super) fn inside(simulation: &Simulation, container: usize) -> Vec<(usize, &Element)> {
    let is_inside = |mut index: usize| {
        for _ in 0..simulation.view.len() {
            match simulation.view.get(index).and_then(|element| element.parent) {
                Some(parent) if parent == container => return true,
                Some(parent) => index = parent,
                None => return false,
            }
        }
        false
    };
    simulation.view.iter().enumerate().filter(|(index, _)| is_inside(*index)).collect()
}

/// True for the way of a point.
pub(crate) fn is_trail(element: &Element) -> bool {
    matches!(element.kind.as_str(), "Trail2D" | "Trace" | "Trail")
}

fn axis(facts: &Facts, trail: &Element, property: &str) -> Result<Value, Obstacle> {
    let text = trail
        .property(property)
        .or_else(|| trail.property(&property.replace("Input", "")))
        .ok_or(Obstacle::NoValue(property.to_owned()))?;
    quantity(facts, text)
}

/// Numeric expression of the view over the quantities of the model.
pub(super) fn quantity(facts: &Facts, text: &str) -> Result<Value, Obstacle> {
    let expression = parse_expression(text).map_err(|unreadable| unreadable.obstacle)?;
    let mut run = Run::new(facts, Phase::Function, Place::new(Section::View, ""));
    let value = run.numeric(&expression).map_err(|reason| reason.obstacle)?;
    if run.kind(&value) == Some(Kind::Number) { Ok(value) } else { Err(Obstacle::Kinds) }
}

/// True if a value may change during a run.
fn moves(facts: &Facts, value: &Value) -> bool {
    let mut moves = false;
    value.walk(&mut |part| {
        if let Value::Name(name) = part {
            moves |= facts.role(name) != Some(Role::Constant);
        }
    });
    moves
}

fn plot(panel: &Element, x: Value, y: Value) -> Plot {
    let of_axis = text(panel, "TitleY").map(|title| label(&title)).unwrap_or_default();
    let title = text(panel, "Title").filter(|title| !title.is_empty());
    Plot { title: title.unwrap_or(of_axis.text), curves: vec![y], against: x, unit: of_axis.unit }
}

/// Lines of the block of plots.
pub(super) fn lines(plots: &[Plot], spelling: &dyn Fn(&str) -> String) -> Vec<String> {
    let mut lines = Vec::new();
    for plot in plots {
        let curves: Vec<String> = plot.curves.iter().map(|curve| written(curve, spelling)).collect();
        let title = if plot.title.is_empty() { curves.join(", ") } else { plot.title.clone() };
        let title = quoted(&title.chars().take(60).collect::<String>());
        let line = format!("{title}: {} against {}", curves.join(", "), written(&plot.against, spelling));
        if line.chars().count() < 160 {
            lines.push(line);
        } else {
            // A plot goes on in the next line after a comma.
            let curves = curves.join(",\n    ");
            lines.extend(
                format!("{title}: {curves} against {}", written(&plot.against, spelling)).lines().map(str::to_owned),
            );
        }
    }
    lines
}
