//! Fixed relations that need their own values of the step before: discrete quantities that change after each step.

use super::facts::{Facts, Role};
use super::motion::{Motion, SolvedEvent, Trigger};
use super::needs::reached;
use super::value::{Kind, Value};
use crate::place::{Place, Section};
use std::collections::BTreeSet;

/// Greatest number of nodes of a value in an action, and greatest number of relations that lead to it one after the other.
const LARGEST: usize = 400;
const DEEPEST: usize = 12;

/// Definitions of the motion in their order, and which of them keep their values from step to step.
struct Relations<'a> {
    facts: &'a Facts,
    motion: &'a Motion,
    kept: BTreeSet<String>,
}

impl Relations<'_> {
    fn value(&self, key: &str) -> Option<&Value> {
        self.motion.definitions.iter().find(|(own, _)| own == key)?.1.as_ref().ok()
    }

    /// True if a value depends on one of some keys.
    fn depends(&self, value: &Value, keys: &BTreeSet<String>) -> bool {
        !reached(self.facts, self.motion, value).is_disjoint(keys)
    }

    /// Keys of relations that read a value of the step before which depends on them, and the keys of these values.
    fn circles(&self) -> BTreeSet<String> {
        let mut found = BTreeSet::new();
        for (key, known) in &self.motion.definitions {
            let Ok(value) = known else { continue };
            let itself = BTreeSet::from([key.clone()]);
            found.extend(
                past(value)
                    .into_iter()
                    .filter(|name| self.depends(&Value::Name(name.clone()), &itself))
                    .flat_map(|name| [key.clone(), name]),
            );
        }
        found
    }

    /// True for a number or a truth value of the table that has a value at the start.
    fn can_keep(&self, key: &str) -> bool {
        let is_suitable = |fact: &super::facts::VariableFact| {
            fact.role == Role::Computed && fact.kind != Kind::Text && !fact.is_array
        };
        self.facts.variable(key).is_some_and(is_suitable)
            && matches!(self.motion.start.get(key), Some(Ok(value)) if *value != Value::Nothing)
    }

    /// Value of a key in terms of what holds before the relations are computed: names that change with the kept keys are replaced by
    /// their values. `at_start`: kept keys are replaced by their values before the first step. `None` for a value that is too large
    /// or missing.
    fn fresh(&self, key: &str, at_start: bool, depth: usize) -> Option<Value> {
        let mut is_whole = depth < DEEPEST;
        let value = self.value(key)?.map(&mut |part| match part {
            Value::Past(name) => {
                is_whole &= self.kept.contains(name) || !self.depends(part, &self.kept);
                let start = || self.motion.start.get(name).and_then(|known| known.clone().ok());
                start().filter(|_| at_start && self.kept.contains(name))
            }
            Value::Name(name) => match self.facts.role(name) {
                Some(Role::State) => at_start.then(|| Value::Start(name.clone())),
                Some(Role::Time) => at_start.then(|| Value::number(0.0)),
                _ if is_whole && self.depends(part, &self.kept) => {
                    let fresh = self.fresh(name, at_start, depth + 1);
                    is_whole &= fresh.is_some();
                    fresh
                }
                _ => None,
            },
            // Functions read kept keys by their names, as they are now.
            Value::Own(name, _) => {
                is_whole &= !self.depends(&Value::Own(name.clone(), Vec::new()), &self.kept);
                None
            }
            _ => None,
        });
        (is_whole && value.size() <= LARGEST).then(|| value.of_one_moment().simplified())
    }
}

impl Motion {
    /// Makes relations discrete that need their own values of the step before, such as the largest value so far. In EJS fixed
    /// relations are computed before the first step, too.
    pub(super) fn remember(&mut self, facts: &mut Facts) {
        let mut relations = Relations { facts, motion: self, kept: BTreeSet::new() };
        relations.kept = relations.circles();
        if relations.kept.is_empty() || !relations.kept.iter().all(|key| relations.can_keep(key)) {
            return;
        }
        let of = |at_start: bool| -> Option<Vec<(String, Value)>> {
            relations.kept.iter().map(|key| Some((key.clone(), relations.fresh(key, at_start, 0)?))).collect()
        };
        let Some((starts, actions)) = of(true).zip(of(false)) else { return };
        let place = actions.first().map(|(key, _)| facts.place_of(key, Section::FixedRelations));
        self.definitions.retain(|(key, _)| !actions.iter().any(|(own, _)| own == key));
        for (key, start) in starts {
            facts.keep(&key);
            let number = start.constant(&|_| None);
            self.start.insert(key, Ok(number.map_or(start, Value::number)));
        }
        self.events.push(SolvedEvent {
            name: "each_step".to_owned(),
            place: place.unwrap_or_else(|| Place::new(Section::FixedRelations, "")),
            trigger: Trigger::EachStep,
            condition: Ok(Value::Nothing),
            actions: actions.into_iter().map(|(key, value)| (key, Ok(value))).collect(),
            pauses: Vec::new(),
        });
    }
}

/// Names in a value that mean the step before.
fn past(value: &Value) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    value.walk(&mut |part| {
        if let Value::Past(name) = part {
            found.insert(name.clone());
        }
    });
    found
}
