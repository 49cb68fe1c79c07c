//! The model block of a translated document.

use super::choices::sets;
use super::controls::{Control, label};
use super::facts::Role;
use super::names::{ARGUMENT, Names};
use super::plots;
use super::solved::{Document, Solved};
use super::value::{Kind, Value};
use super::writing::{quoted, statement, written};
use crate::place::{Place, Section};
use crate::prose::plain_text;
use crate::report::{EntryKind, Report};
use std::collections::BTreeSet;
use units::number::shortest;
use units::words;

/// Writer of the statements.
struct Writer<'a> {
    solved: &'a Solved,
    names: Names,
    has_units: bool,
    lines: Vec<String>,
}

impl Solved {
    /// Blocks of the document, with the stated units or without any, and with the drawing or without it.
    pub fn document(&self, title: &str, [has_units, has_scene]: [bool; 2], report: &mut Report) -> Document {
        let mut writer = Writer { solved: self, names: Names::default(), has_units, lines: Vec::new() };
        writer.name_all(report);
        writer.independent();
        writer.constants(report);
        writer.choices();
        writer.functions();
        writer.definitions();
        writer.equations(report);
        writer.discrete();
        writer.events();
        let Writer { names, lines, .. } = writer;
        let spelling = |key: &str| names.spelling(key);
        let plots = plots::lines(&self.plots, &spelling);
        let names = self
            .facts
            .order
            .iter()
            .filter(|name| self.is_written(name))
            .map(|name| (name.clone(), names.spelling(name)))
            .collect();
        if !has_scene && self.has_picture() {
            let place = Place::new(Section::View, "");
            report.add(
                EntryKind::Left,
                place,
                words!("The drawing is not carried over: the checker does not accept it."),
            );
        }
        let scene = self.picture.as_ref().filter(|_| has_scene).map(|picture| {
            let unit = if has_units { self.units.get(picture.quantity().unwrap_or_default()).cloned() } else { None };
            picture.lines(title, unit.as_deref(), &spelling)
        });
        Document { model: lines, scene: scene.unwrap_or_default(), plots, names }
    }

    /// True if there is a drawing.
    pub fn has_picture(&self) -> bool {
        self.picture.is_some()
    }

    /// True if labels state units.
    pub fn has_units(&self) -> bool {
        !self.units.is_empty() && self.facts.equations.independent == "t"
    }
}

impl Writer<'_> {
    fn name_all(&mut self, report: &mut Report) {
        let solved = self.solved;
        let time = &solved.facts.equations.independent;
        let mut keys: Vec<&String> = vec![time];
        keys.extend(solved.facts.order.iter().filter(|name| solved.is_written(name)));
        keys.extend(solved.functions.order.iter());
        keys.extend(solved.motion.definitions.iter().map(|(key, _)| key).filter(|key| solved.used.contains(*key)));
        for key in keys {
            if let Some(name) = self.names.declare(key) {
                let original = super::names::original(key);
                let place = solved.facts.place_of(key, Section::Variables);
                report.add(EntryKind::Changed, place, words!("`{original}` is called `{name}` here."));
            }
        }
        for name in &solved.functions.order {
            let Some(fact) = solved.facts.function(name) else { continue };
            let mut used = BTreeSet::new();
            if let Some(value) = solved.functions.value(name) {
                value.walk(&mut |part| match part {
                    Value::Name(key) | Value::Own(key, _) if !key.contains(ARGUMENT) => {
                        _ = used.insert(self.names.spelling(key))
                    }
                    _ => {}
                });
            }
            for argument in &fact.function.arguments {
                let key = super::calls::argument_key(name, argument);
                self.names.declare_argument(&key, &used);
                used.insert(self.names.spelling(&key));
            }
        }
    }

    fn written(&self, value: &Value) -> String {
        written(value, &|key| self.names.spelling(key))
    }

    fn push(&mut self, left: &str, right: &str, behind: &str) {
        self.lines.extend(statement(left, right, behind).lines().map(str::to_owned));
    }

    fn independent(&mut self) {
        let time = &self.solved.facts.equations.independent;
        if !self.has_units {
            let name = self.names.spelling(time);
            self.lines.push(format!("independent {name}"));
        }
    }

    /// Unit in brackets behind a number.
    fn unit(&self, key: &str) -> String {
        let unit = self.has_units.then(|| self.solved.units.get(key)).flatten();
        unit.map(|unit| format!(" [{unit}]")).unwrap_or_default()
    }

    /// Label of a quantity: of its control, else its comment.
    fn label(&self, key: &str) -> String {
        let of_control =
            self.solved.controls.iter().find(|control| control.variable == key && !control.label.text.is_empty());
        let text = match (of_control, self.solved.facts.variable(key)) {
            (Some(control), _) => control.label.text.clone(),
            (None, Some(fact)) => label(&plain_text(&fact.comment)).text,
            (None, None) => String::new(),
        };
        if text.is_empty() { String::new() } else { format!(" {}", quoted(&text)) }
    }

    fn constants(&mut self, report: &mut Report) {
        let solved = self.solved;
        for name in &solved.facts.order {
            let is_chosen = solved.choices.iter().any(|choice| sets(choice).contains(&name));
            if solved.facts.role(name) != Some(Role::Constant) || !solved.used.contains(name) || is_chosen {
                continue;
            }
            let Some(Ok(value)) = solved.motion.start.get(name) else { continue };
            let (spelling, label, unit) = (self.names.spelling(name), self.label(name), self.unit(name));
            match (solved.kind(name), solved.control(name), value) {
                (Kind::Truth, _, Value::Truth(truth)) => {
                    self.lines.push(format!("switch {spelling} = {}{label}", if *truth { "on" } else { "off" }));
                }
                (Kind::Number, Some(control), value) => match number(solved, value) {
                    Some(number) => {
                        let range = range(control, number, report);
                        self.lines.push(format!("parameter {spelling} = {}{unit}{range}{label}", exact(value, number)));
                    }
                    None => {
                        let place = control.place.clone();
                        report.add(EntryKind::Left, place, words!("The control of `{name}` is not carried over: its value at the start is computed from others."));
                        let right = self.written(value);
                        self.push(&spelling, &right, &label);
                    }
                },
                (_, _, value) => {
                    let right = self.written(value);
                    let unit = self.unit_of(value, name);
                    self.push(&spelling, &right, &format!("{unit}{label}"));
                }
            }
        }
    }

    /// Unit behind a literal number, or stated for an expression.
    fn unit_of(&self, value: &Value, key: &str) -> String {
        let unit = self.unit(key);
        let is_number = match value {
            Value::Number(..) => true,
            Value::Negative(inner) => matches!(**inner, Value::Number(..)),
            _ => false,
        };
        if unit.is_empty() || is_number { unit } else { format!(" in{unit}") }
    }

    fn choices(&mut self) {
        for choice in &self.solved.choices {
            let name = self.names.invent(&choice.name);
            self.lines.push(format!("choice {name} {} {{", quoted(&choice.label)));
            for (option, values) in &choice.alternatives {
                let values: Vec<String> = values
                    .iter()
                    .map(|(key, value)| {
                        let unit = self.unit_of(value, key);
                        format!("{} = {}{unit}", self.names.spelling(key), self.written(value))
                    })
                    .collect();
                self.lines.push(format!("    {}: {}", quoted(option), values.join(", ")));
            }
            self.lines.push("}".to_owned());
        }
    }

    fn functions(&mut self) {
        for name in &self.solved.functions.order {
            let (Some(fact), Some(value)) = (self.solved.facts.function(name), self.solved.functions.value(name))
            else {
                continue;
            };
            let arguments: Vec<String> = fact
                .function
                .arguments
                .iter()
                .map(|argument| self.names.spelling(&super::calls::argument_key(name, argument)))
                .collect();
            let left = format!("function {}({})", self.names.spelling(name), arguments.join(", "));
            let right = self.written(value);
            self.push(&left, &right, "");
        }
    }

    fn definitions(&mut self) {
        for (key, known) in &self.solved.motion.definitions {
            let (true, Ok(value)) = (self.solved.used.contains(key), known) else { continue };
            let label = self.label(key);
            let unit = self.unit_of(value, key);
            let right = match value {
                // A definition that is always true or false compares two numbers.
                Value::Truth(truth) => format!("0 {} 0", if *truth { "==" } else { "!=" }),
                value => self.written(value),
            };
            let left = self.names.spelling(key);
            self.push(&left, &right, &format!("{unit}{label}"));
        }
    }

    fn equations(&mut self, report: &mut Report) {
        let solved = self.solved;
        for (state, rate) in &solved.motion.rates {
            let Ok(rate) = rate else { continue };
            let left = format!("{}'", self.names.spelling(state));
            let right = self.written(rate);
            self.push(&left, &right, "");
        }
        let mut starts = Vec::new();
        for (state, _) in &solved.motion.rates {
            let Some(Ok(value)) = solved.motion.start.get(state) else { continue };
            let (name, label, unit) = (self.names.spelling(state), self.label(state), self.unit(state));
            if let Some((control, number)) = solved.start_parameter(state) {
                let parameter = self.names.invent(&format!("{name}_0"));
                let range = range(control, number, report);
                self.lines.push(format!("parameter {parameter} = {}{unit}{range}{label}", exact(value, number)));
                starts.push((name, parameter, String::new(), label));
            } else {
                starts.push((name, self.written(value), self.unit_of(value, state), label));
            }
        }
        for (name, value, unit, label) in starts {
            self.push(&format!("{name}(0)"), &value, &format!("{unit}{label}"));
        }
    }

    fn discrete(&mut self) {
        for name in &self.solved.facts.order {
            if self.solved.facts.role(name) != Some(Role::Discrete) || !self.solved.used.contains(name) {
                continue;
            }
            if let Some(Ok(value)) = self.solved.motion.start.get(name) {
                let right = self.written(value);
                let (left, label) = (format!("discrete {}", self.names.spelling(name)), self.label(name));
                let unit = self.unit_of(value, name);
                self.push(&left, &right, &format!("{unit}{label}"));
            }
        }
    }

    fn events(&mut self) {
        for event in &self.solved.events {
            let actions: Vec<String> = event
                .actions
                .iter()
                .filter(|(name, _)| self.solved.used.contains(name))
                .map(|(name, value)| statement(&self.names.spelling(name), &self.written(value), ""))
                .chain(event.stops.then(|| "stop".to_owned()))
                .collect();
            if actions.is_empty() {
                continue;
            }
            let condition = match &event.condition {
                Some(condition) => format!("when {}", self.written(condition)),
                None => format!(
                    "every {}{}",
                    shortest(self.solved.increment),
                    self.unit(&self.solved.facts.equations.independent)
                ),
            };
            let name = self.names.invent_event(&event.name);
            let label = if event.stops { format!(" {}", quoted(&event.name)) } else { String::new() };
            let line = format!("{condition} as {name} {{ {} }}{label}", actions.join(", "));
            if line.len() < 110 && actions.len() < 3 {
                self.lines.push(line);
                continue;
            }
            self.lines.push(format!("{condition} as {name} {{"));
            for action in actions {
                self.lines.extend(action.lines().map(|line| format!("    {line}")));
            }
            self.lines.push(format!("}}{label}"));
        }
    }
}

/// Range and step of a control, wide enough for the value.
fn range(control: &Control, value: f64, report: &mut Report) -> String {
    let Some((low, high)) = control.range else { return String::new() };
    if !(low..=high).contains(&value) {
        let (name, shown) = (&control.variable, shortest(value));
        report.add(EntryKind::Changed, control.place.clone(), words!("The value of `{name}` at the start, {shown}, lies outside of the range of its control: the range is wider here."));
    }
    let (low, high) = (low.min(value), high.max(value));
    let step = control.step.filter(|step| *step < high - low);
    let step = step.map(|step| format!(" step {}", shortest(step))).unwrap_or_default();
    format!(" in {}..{}{step}", shortest(low), shortest(high))
}

/// Number of a constant value, with the constants at the start of the run.
fn number(solved: &Solved, value: &Value) -> Option<f64> {
    value.constant(&|name| match (solved.facts.role(name), solved.motion.start.get(name)) {
        (Some(Role::Constant), Some(Ok(value))) => value.constant(&|_| None),
        _ => None,
    })
}

/// A number as it is written, or the shortest text of the value of an expression.
fn exact(value: &Value, number: f64) -> String {
    match value {
        Value::Number(text, _) => text.clone(),
        _ => shortest(number),
    }
}
