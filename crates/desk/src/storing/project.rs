//! Items of a project file besides its document.

use super::films::MOST_WORKS;
use crate::{Desk, MOST_FITS, MOST_RECORDS};
use saved::Item;
use std::collections::HashSet;

/// Maximum number of items that are tried, because a file of unknown origin may have thousands.
const MOST_TRIED: usize = MOST_RECORDS + MOST_WORKS + MOST_FITS;

impl Desk {
    /// Records, works on films, fits and answers: names and texts to store. `now` in milliseconds.
    pub fn project_items(&self, now: u64) -> Vec<(String, String)> {
        let groups = [self.saved_records(), self.saved_films(), self.saved_fits(), self.saved_answers()];
        groups.into_iter().flatten().zip(now..).map(|((name, item), since)| (name, item.write(since))).collect()
    }

    /// Restores the items of a project in the order in which they were written, because fits need their records.
    /// Existing items stay unchanged. Returns the number of items that could not be restored.
    pub fn take_project_items(&mut self, items: &[(String, String)]) -> usize {
        let records = self.record_names().into_iter().map(|(_, name)| name);
        let others = [self.saved_fits(), self.saved_films()].into_iter().flatten().map(|(name, _)| name);
        let mut here: HashSet<String> = records.chain(others).collect();
        let (mut refused, mut tried) = (0, 0);
        for (name, text) in items {
            let Some((_, item)) = Item::read(text) else {
                refused += 1;
                continue;
            };
            if here.contains(name) {
                continue;
            }
            if self.restore_answer(name, &item) {
                continue;
            }
            tried += 1;
            let taken = if tried > MOST_TRIED { None } else { self.restore_measured(&item) };
            refused += usize::from(taken.is_none());
            here.extend(taken);
        }
        refused
    }

    /// Restores a record, the work on a film, or a fit, and returns its name in the storage.
    fn restore_measured(&mut self, item: &Item) -> Option<String> {
        self.restore_record(item).or_else(|| self.restore_film(item)).or_else(|| self.restore_fit(item))
    }
}
