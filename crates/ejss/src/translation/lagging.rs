//! Fixed relations that read what later ones write.

use super::facts::Facts;
use super::motion::Motion;
use super::needs::reached;
use super::value::Value;
use crate::place::{Reason, Section};
use crate::refusal::Obstacle;
use crate::report::{EntryKind, Report};
use std::collections::{BTreeMap, BTreeSet};
use units::words;

impl Motion {
    /// Fixed relations that read what a later one writes: the original shows them one step late. In a circle they need the past;
    /// `past`: the places where they read it.
    pub(super) fn lag(&mut self, facts: &Facts, past: &BTreeMap<String, Reason>, report: &mut Report) {
        let order: Vec<String> = self.definitions.iter().map(|(key, _)| key.clone()).collect();
        for index in 0..order.len() {
            let Some((key, Ok(value))) = self.definitions.get(index) else { continue };
            let mut earlier = BTreeSet::new();
            value.walk(&mut |part| {
                let is_later =
                    |name: &str| order.iter().position(|own| own == name).is_some_and(|other| other >= index);
                match part {
                    Value::Past(name) => _ = earlier.insert(name.clone()),
                    Value::Name(name) if is_later(name) => _ = earlier.insert(name.clone()),
                    _ => {}
                }
            });
            let depends = |name: &&String| reached(facts, self, &Value::Name((*name).clone())).contains(key);
            let place = facts.place_of(key, Section::FixedRelations);
            let known = if let Some(name) = earlier.iter().find(depends) {
                let unknown = || Reason { place, obstacle: Obstacle::Past(name.clone()) };
                Err(past.get(name).cloned().unwrap_or_else(unknown))
            } else {
                for name in earlier.iter().filter(|_| facts.variable(key).is_some()) {
                    report.add(EntryKind::Differs, place.clone(), words!("`{key}` is computed from `{name}` of the step before in the original. Here both are of the same moment."));
                }
                Ok(value.of_one_moment())
            };
            if let Some((_, own)) = self.definitions.get_mut(index) {
                *own = known;
            }
        }
    }
}
