//! Events as statements of the document.

use super::facts::{Facts, Role};
use super::motion::{Motion, SolvedEvent, Trigger};
use super::value::{Kind, Value};
use crate::report::{EntryKind, Report};
use crate::script::Operator;
use units::words;

/// Event of the document.
#[derive(Clone, Debug)]
pub(super) struct EventText {
    pub name: String,
    /// Condition as the document writes it; `None` for the end of each step.
    pub condition: Option<Value>,
    pub actions: Vec<(String, Value)>,
    pub stops: bool,
}

/// Time at which an event ends the run, if one does nothing else, and the other events.
pub(super) fn until(facts: &Facts, motion: &Motion, report: &mut Report) -> (Option<f64>, Vec<EventText>) {
    let mut until: Option<f64> = None;
    let mut events = Vec::new();
    for event in &motion.events {
        if let Some(end) = end_of_run(facts, motion, event) {
            until = Some(until.map_or(end, |other| other.min(end)));
        } else {
            let begins_below = |condition: &Value| at_start(facts, motion, condition).is_some_and(|value| value <= 0.0);
            if event.trigger == Trigger::Negative && event.condition.as_ref().is_ok_and(begins_below) {
                report.add(
                    EntryKind::Differs,
                    event.place.clone(),
                    words!("The event begins at or below its threshold, where the original may fire at once. Here it fires when its quantity becomes negative."),
                );
            }
            events.extend(texts(facts, event, report));
        }
    }
    (until, events)
}

/// Time at which an event only pauses the run: `t - T`.
fn end_of_run(facts: &Facts, motion: &Motion, event: &SolvedEvent) -> Option<f64> {
    let Ok(Value::Binary(Operator::Minus, left, right)) = &event.condition else { return None };
    let is_time = |value: &Value| matches!(value, Value::Name(name) if facts.role(name) == Some(Role::Time));
    let end = match (is_time(left), is_time(right)) {
        (true, false) => at_start(facts, motion, right)?,
        (false, true) => at_start(facts, motion, left)?,
        _ => return None,
    };
    (event.actions.is_empty() && event.pauses == [Value::Truth(true)] && end > 0.0).then_some(end)
}

/// Number of a value at the start of the run.
fn at_start(facts: &Facts, motion: &Motion, value: &Value) -> Option<f64> {
    value.constant(&|name| match facts.role(name) {
        Some(Role::Time) => Some(0.0),
        Some(Role::Computed) | None => None,
        // The values of a table are constants of their own.
        Some(Role::Constant | Role::State | Role::Discrete) => motion
            .start
            .get(name)?
            .as_ref()
            .ok()?
            .constant(&|inner| motion.start.get(inner)?.as_ref().ok()?.constant(&|_| None)),
    })
}

/// An event, and a second one for what it does only under a condition on discrete quantities.
fn texts(facts: &Facts, event: &SolvedEvent, report: &mut Report) -> Vec<EventText> {
    let condition = match &event.condition {
        Ok(condition) => when(condition, event.trigger),
        Err(reason) => {
            let why = reason.obstacle.words();
            report.add(EntryKind::Left, reason.place.clone(), words!("The event is not carried over: {why}."));
            return Vec::new();
        }
    };
    let mut actions = Vec::new();
    for (name, action) in &event.actions {
        match (action, facts.role(name)) {
            (Ok(value), Some(Role::State | Role::Discrete)) if !matches!(value, Value::Join(_) | Value::Nothing) => {
                actions.push((name.clone(), value.clone()));
            }
            (Err(reason), _) => report.quantity_left(name, reason),
            (Ok(_), _) => {
                report.add(
                    EntryKind::Left,
                    event.place.clone(),
                    words!("The event sets `{name}`, which is computed after each step: this is not carried over."),
                );
            }
        }
    }
    let behind = |value: &Value| {
        value.map(&mut |part| {
            let named = actions.iter().find(|(_, value)| value == part && !part.is_plain());
            named.map(|(name, _)| Value::Name(name.clone()))
        })
    };
    // A text that keeps its value otherwise, and a pause, go into an event of their own.
    let mut later: Vec<EventText> = Vec::new();
    let mut add_later = |condition: &Value, action: Option<(String, Value)>, stops: bool| {
        let condition = behind(condition);
        if !is_discrete(facts, &condition) {
            return false;
        }
        let condition = Some(condition);
        let index = later.iter().position(|event| event.condition == condition).unwrap_or_else(|| {
            later.push(EventText { name: event.name.clone(), condition, actions: Vec::new(), stops: false });
            later.len() - 1
        });
        if let Some(event) = later.get_mut(index) {
            event.actions.extend(action);
            event.stops |= stops;
        }
        true
    };
    let mut stops = false;
    for pause in &event.pauses {
        if *pause == Value::Truth(true) {
            stops = true;
        } else if !add_later(pause, None, true) {
            report.add(EntryKind::Left, event.place.clone(), words!("The event pauses the run only under a condition that moves with the states: the pause is not carried over."));
        }
    }
    let mut own = Vec::new();
    for (name, value) in &actions {
        let is_text = facts.variable(name).is_some_and(|fact| fact.kind == Kind::Text);
        match value {
            Value::If(condition, yes, no) if is_text && **no == Value::Name(name.clone()) => {
                if !add_later(condition, Some((name.clone(), (**yes).clone())), false) {
                    report.add(
                        EntryKind::Left,
                        event.place.clone(),
                        words!("The event sets the text `{name}` under a condition: this is not carried over."),
                    );
                }
            }
            _ if is_text && mentions(value, name) => {
                report.add(
                    EntryKind::Left,
                    event.place.clone(),
                    words!("The event sets the text `{name}` under a condition: this is not carried over."),
                );
            }
            _ if *value == Value::Name(name.clone()) => {}
            _ => own.push((name.clone(), value.clone())),
        }
    }
    let mut all = Vec::new();
    if !own.is_empty() || stops {
        all.push(EventText { name: event.name.clone(), condition, actions: own, stops });
    }
    all.append(&mut later);
    all
}

/// Condition of an event: the quantity passes through zero, or becomes negative. `None` for the end of each step.
fn when(quantity: &Value, trigger: Trigger) -> Option<Value> {
    let operator = match trigger {
        Trigger::Crossing => Operator::Equal,
        Trigger::Negative => Operator::Less,
        Trigger::EachStep => return None,
    };
    let condition = match quantity {
        Value::Binary(Operator::Minus, left, right) => Value::Binary(operator, left.clone(), right.clone()),
        Value::Negative(inner) if trigger == Trigger::Negative => {
            Value::binary(Operator::Greater, (**inner).clone(), Value::number(0.0))
        }
        Value::Negative(inner) => Value::binary(operator, (**inner).clone(), Value::number(0.0)),
        other => Value::binary(operator, other.clone(), Value::number(0.0)),
    };
    Some(condition)
}

/// True if a condition depends on discrete quantities and constants alone, and on at least one of the former.
fn is_discrete(facts: &Facts, condition: &Value) -> bool {
    let (mut all, mut any) = (true, false);
    condition.walk(&mut |part| match part {
        Value::Name(name) => {
            any |= facts.role(name) == Some(Role::Discrete);
            all &= matches!(facts.role(name), Some(Role::Discrete | Role::Constant));
        }
        Value::Own(..) | Value::Start(_) => all = false,
        _ => {}
    });
    all && any
}

fn mentions(value: &Value, name: &str) -> bool {
    let mut found = false;
    value.walk(&mut |part| found |= matches!(part, Value::Name(own) if own == name));
    found
}
