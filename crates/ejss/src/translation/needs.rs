//! Which quantities the states need, and which quantities the document uses.

use super::calls::function_value;
use super::facts::{Facts, Role};
use super::motion::Motion;
use super::run::{Phase, Run};
use super::value::Value;
use crate::place::{Reason, Section};
use crate::refusal::Obstacle;
use std::collections::{BTreeMap, BTreeSet};

/// Values of the functions of a simulation that are called by their names, each with its arguments as names.
#[derive(Debug, Default)]
pub(super) struct Functions {
    values: BTreeMap<String, Value>,
    /// In the order in which they were found.
    pub order: Vec<String>,
}

impl Functions {
    pub fn value(&self, name: &str) -> Option<&Value> {
        self.values.get(name)
    }

    /// Adds a function and returns its value.
    fn load(&mut self, facts: &Facts, name: &str) -> Option<Value> {
        if let Some(value) = self.values.get(name) {
            return Some(value.clone());
        }
        let place = facts.function(name)?.place.clone();
        let value = function_value(&mut Run::new(facts, Phase::Function, place), name).ok()?;
        self.values.insert(name.to_owned(), value.clone());
        self.order.push(name.to_owned());
        Some(value)
    }
}

/// All keys on which a value depends, those on which their values at the start depend among them.
pub(super) fn reached(facts: &Facts, motion: &Motion, value: &Value) -> BTreeSet<String> {
    let mut search = Search::new(facts, motion);
    search.value(value);
    search.found
}

/// Follows values through definitions, constants, functions and events.
pub(super) struct Search<'a> {
    facts: &'a Facts,
    motion: &'a Motion,
    pub functions: Functions,
    /// Keys that have been reached.
    pub found: BTreeSet<String>,
    /// Keys without a value that have been reached, with the reason.
    pub missing: Vec<(String, Reason)>,
}

impl<'a> Search<'a> {
    pub fn new(facts: &'a Facts, motion: &'a Motion) -> Self {
        Self { facts, motion, functions: Functions::default(), found: BTreeSet::new(), missing: Vec::new() }
    }

    /// Follows the states: their rates, their values at the start, and the events that change them.
    pub fn states(&mut self) {
        let motion = self.motion;
        for (state, rate) in &motion.rates {
            rate.iter().for_each(|value| self.value(value));
            self.key(state);
            self.events_of(state);
        }
    }

    /// True if something that has been reached changes during a run.
    pub fn moves(&self) -> bool {
        let is_moving = |key: &String| matches!(self.facts.role(key), Some(Role::State | Role::Time | Role::Discrete));
        self.found.iter().any(is_moving)
    }

    /// Follows a value.
    pub fn value(&mut self, value: &Value) {
        let mut names = Vec::new();
        let mut calls = Vec::new();
        value.walk(&mut |part| match part {
            Value::Name(name) | Value::Past(name) | Value::Start(name) => names.push(name.clone()),
            Value::Own(name, _) => calls.push(name.clone()),
            _ => {}
        });
        for name in names.into_iter().filter(|name| !name.contains(super::names::ARGUMENT)) {
            self.key(&name);
        }
        for name in calls {
            if self.functions.value(&name).is_none()
                && let Some(value) = self.functions.load(self.facts, &name)
            {
                self.value(&value);
            }
        }
    }

    /// Follows a key.
    pub fn key(&mut self, key: &str) {
        if !self.found.insert(key.to_owned()) {
            return;
        }
        match self.motion.defined(self.facts, key) {
            Some(Ok(Value::Nothing)) => self.without_value(key),
            Some(Ok(value)) => {
                let value = value.clone();
                self.value(&value);
            }
            Some(Err(reason)) => self.missing.push((key.to_owned(), reason.clone())),
            None if self.facts.role(key) == Some(Role::State) => self.start(key),
            None if self.facts.role(key) == Some(Role::Time) => {}
            None => self.without_value(key),
        }
        if self.facts.role(key) == Some(Role::Discrete) {
            self.events_of(key);
        }
    }

    /// Follows the value of a state at the start.
    fn start(&mut self, state: &str) {
        match self.motion.start.get(state) {
            Some(Ok(Value::Nothing)) | None => self.without_value(state),
            Some(Ok(value)) => {
                let value = value.clone();
                self.value(&value);
            }
            Some(Err(reason)) => self.missing.push((state.to_owned(), reason.clone())),
        }
    }

    /// Follows the events that change a discrete quantity or a state.
    pub fn events_of(&mut self, key: &str) {
        let motion = self.motion;
        for event in &motion.events {
            let Some((_, action)) = event.actions.iter().find(|(own, _)| own == key) else { continue };
            match action {
                Ok(value) => self.value(value),
                Err(reason) => self.missing.push((key.to_owned(), reason.clone())),
            }
            match &event.condition {
                Ok(value) => self.value(value),
                Err(reason) => self.missing.push((key.to_owned(), reason.clone())),
            }
        }
    }

    fn without_value(&mut self, key: &str) {
        let place = self.facts.place_of(key, Section::Variables);
        let obstacle = match self.facts.variable(key) {
            Some(fact) if fact.is_array => Obstacle::Array(key.to_owned()),
            _ => Obstacle::NoValue(super::names::original(key).to_owned()),
        };
        self.missing.push((key.to_owned(), Reason { place, obstacle }));
    }
}
