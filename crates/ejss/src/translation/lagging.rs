//! Fixed relations that read what later ones write.

use super::facts::Facts;
use super::motion::Motion;
use super::needs::Search;
use super::value::Value;
use crate::place::{Reason, Section};
use crate::refusal::Obstacle;
use crate::report::{EntryKind, Report};
use units::words;

impl Motion {
    /// Fixed relations that read what a later one writes: the original shows them one step late. In a circle they need the past.
    pub(super) fn lag(&mut self, facts: &Facts, report: &mut Report) {
        let order: Vec<String> = self.definitions.iter().map(|(key, _)| key.clone()).collect();
        for index in 0..order.len() {
            let Some((key, Ok(value))) = self.definitions.get(index) else { continue };
            let mut later = None;
            value.walk(&mut |part| {
                if let Value::Name(name) = part
                    && order.iter().position(|own| own == name).is_some_and(|other| other >= index)
                {
                    later = Some(name.clone());
                }
            });
            let Some(later) = later else { continue };
            let mut search = Search::new(facts, self);
            search.key(&later);
            let place = facts.place_of(key, Section::FixedRelations);
            if search.found.contains(key) {
                let reason = Reason { place, obstacle: Obstacle::Past(later) };
                if let Some((_, known)) = self.definitions.get_mut(index) {
                    *known = Err(reason);
                }
            } else if facts.variable(key).is_some() {
                report.add(EntryKind::Differs, place, words!("`{key}` is computed from `{later}` of the step before in the original. Here both are of the same moment."));
            }
        }
    }
}
