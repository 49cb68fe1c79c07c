//! Combo boxes whose code sets constants by the chosen option: they become choices.

use super::facts::{Facts, Role};
use super::run::{Phase, Run};
use super::value::Value;
use crate::place::{Place, Section};
use crate::refusal::Obstacle;
use crate::report::{EntryKind, Report};
use crate::script::{Expression, Node, Operator, Statement, StatementKind, parse_expression, parse_program};
use crate::simulation::{Element, Simulation};
use std::collections::BTreeMap;
use units::words;

/// Choice of the document.
#[derive(Clone, Debug)]
pub(super) struct Choice {
    /// Name of the element or of the variable with the chosen option.
    pub name: String,
    pub label: String,
    /// Option and values of the variables, the same ones for each.
    pub alternatives: Vec<(String, Vec<(String, Value)>)>,
}

/// Choices of the view. `start`: values at the start by the names of the variables. Combo boxes without a counterpart are reported.
pub(super) fn choices(
    simulation: &Simulation,
    facts: &Facts,
    start: &dyn Fn(&str) -> Option<Value>,
    report: &mut Report,
) -> Vec<Choice> {
    let mut found: Vec<Choice> = Vec::new();
    for element in simulation.view.iter().filter(|element| element.kind == "ComboBox") {
        let place = Place::new(Section::View, &element.name);
        match choice(element, facts, start) {
            Ok(choice) => {
                let is_taken = |name: &String| found.iter().any(|other| sets(other).contains(&name));
                if sets(&choice).into_iter().any(is_taken) {
                    report.add(
                        EntryKind::Left,
                        place,
                        words!("Another combo box sets the same variables. This one is not carried over."),
                    );
                } else {
                    found.push(choice);
                }
            }
            Err(obstacle) => {
                let why = obstacle.words();
                report.add(EntryKind::Left, place, words!("The combo box is not carried over: {why}."));
            }
        }
    }
    found
}

/// Names of the variables that a choice sets.
pub(super) fn sets(choice: &Choice) -> Vec<&String> {
    choice.alternatives.first().map(|(_, values)| values.iter().map(|(name, _)| name).collect()).unwrap_or_default()
}

fn choice(element: &Element, facts: &Facts, start: &dyn Fn(&str) -> Option<Value>) -> Result<Choice, Obstacle> {
    let options = options(element)?;
    let code = element.property("OnChange").unwrap_or_default();
    let statements = parse_program(code).map_err(|unreadable| unreadable.obstacle)?;
    let mut by_option: BTreeMap<String, BTreeMap<String, Value>> = BTreeMap::new();
    branches(&statements, facts, &options, &mut by_option)?;
    let names: Vec<String> =
        by_option.values().next().map(|values| values.keys().cloned().collect()).unwrap_or_default();
    let mut alternatives = Vec::new();
    for option in &options {
        let values = by_option.get(option).ok_or_else(|| Obstacle::NoValue(option.clone()))?;
        if !values.keys().eq(names.iter()) {
            return Err(Obstacle::NoValue(option.clone()));
        }
        alternatives.push((option.clone(), values.clone().into_iter().collect::<Vec<_>>()));
    }
    if names.is_empty() || alternatives.len() < 2 {
        return Err(Obstacle::Statement("OnChange".to_owned()));
    }
    // The first alternative holds at the start: it must be the one whose values the variables have there.
    let number = |value: &Value| value.constant(&|_| None);
    let holds = |(_, values): &(String, Vec<(String, Value)>)| {
        values.iter().all(|(name, value)| {
            start(name).is_some_and(|own| own == *value || number(&own).is_some() && number(&own) == number(value))
        })
    };
    let Some(first) = alternatives.iter().position(holds) else {
        return Err(Obstacle::NoValue(names.join(", ")));
    };
    let first = alternatives.remove(first);
    alternatives.insert(0, first);
    let selected = element.property("SelectedOptions").filter(|name| facts.variable(name).is_some());
    Ok(Choice { name: selected.unwrap_or(&element.name).to_owned(), label: element.name.clone(), alternatives })
}

fn options(element: &Element) -> Result<Vec<String>, Obstacle> {
    let text = element.property("Options").ok_or(Obstacle::NoValue("Options".to_owned()))?;
    let expression = parse_expression(text).map_err(|unreadable| unreadable.obstacle)?;
    let Node::Array(parts) = expression.node else { return Err(Obstacle::Text) };
    let texts = parts.into_iter().map(|part| match part.node {
        Node::Text(text) => Ok(text),
        _ => Err(Obstacle::Text),
    });
    texts.collect()
}

/// Collects the assignments under `if (option == "..")`.
fn branches(
    statements: &[Statement],
    facts: &Facts,
    options: &[String],
    found: &mut BTreeMap<String, BTreeMap<String, Value>>,
) -> Result<(), Obstacle> {
    for statement in statements {
        match &statement.kind {
            StatementKind::If(condition, yes, no) => {
                if let Some(chosen) = compared(condition, options) {
                    let values = assignments(yes, facts)?;
                    chosen.into_iter().for_each(|option| _ = found.insert(option, values.clone()));
                    // A final `else` holds for the options that are not named.
                    if no.iter().all(|statement| !matches!(statement.kind, StatementKind::If(..))) && !no.is_empty() {
                        let values = assignments(no, facts)?;
                        for option in options {
                            found.entry(option.clone()).or_insert_with(|| values.clone());
                        }
                    } else {
                        branches(no, facts, options, found)?;
                    }
                } else {
                    branches(yes, facts, options, found)?;
                    branches(no, facts, options, found)?;
                }
            }
            StatementKind::Block(inner) | StatementKind::Other("for", _, inner) => {
                branches(inner, facts, options, found)?
            }
            _ => {
                if !assignments(std::slice::from_ref(statement), facts)?.is_empty() {
                    return Err(Obstacle::Statement("OnChange".to_owned()));
                }
            }
        }
    }
    Ok(())
}

/// Options that a condition compares a name with: `option == "Moon"`, several with `||`.
fn compared(condition: &Expression, options: &[String]) -> Option<Vec<String>> {
    let Node::Binary(operator, left, right) = &condition.node else { return None };
    match operator {
        Operator::Or => Some(compared(left, options)?.into_iter().chain(compared(right, options)?).collect()),
        Operator::Equal => match (&left.node, &right.node) {
            (Node::Text(text), _) | (_, Node::Text(text)) => {
                Some(vec![options.iter().find(|option| *option == text)?.clone()])
            }
            _ => None,
        },
        _ => None,
    }
}

/// Constants that statements set. States and the time restart by themselves; calls of the player are not needed.
fn assignments(statements: &[Statement], facts: &Facts) -> Result<BTreeMap<String, Value>, Obstacle> {
    let mut values = BTreeMap::new();
    for statement in statements {
        match &statement.kind {
            StatementKind::Expression(expression) => match &expression.node {
                Node::Assignment(target, None, value) => {
                    let Some(name) = target.name() else { continue };
                    match facts.role(name) {
                        Some(Role::State | Role::Time) | None => continue,
                        Some(Role::Constant) => {}
                        Some(_) => return Err(Obstacle::WritesState(name.to_owned())),
                    }
                    let mut run = Run::new(facts, Phase::Function, Place::new(Section::View, ""));
                    let value = run.value(value).map_err(|reason| reason.obstacle)?;
                    let mut names = false;
                    value.walk(&mut |part| names |= matches!(part, Value::Name(_) | Value::Join(_)));
                    if names {
                        return Err(Obstacle::Statement("OnChange".to_owned()));
                    }
                    values.insert(name.to_owned(), value);
                }
                Node::Call(callee, _) => {
                    let root = callee.root().unwrap_or_default();
                    if facts.function(root).is_some_and(|fact| !facts.written_by(&fact.function.body).is_empty()) {
                        return Err(Obstacle::Call(root.to_owned()));
                    }
                }
                Node::Assignment(..) => return Err(Obstacle::Statement("OnChange".to_owned())),
                _ => {}
            },
            StatementKind::Declaration(_) => {}
            StatementKind::Block(inner) => values.extend(assignments(inner, facts)?),
            _ => return Err(Obstacle::Statement("OnChange".to_owned())),
        }
    }
    Ok(values)
}
