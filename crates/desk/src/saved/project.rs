//! What a project holds of a desk besides its document.

use super::Item;
use crate::Desk;

impl Desk {
    /// Records, works on films, fits and answers with their names, as texts; `now` in milliseconds.
    pub fn project_items(&self, now: u64) -> Vec<(String, String)> {
        let groups = [self.saved_records(), self.saved_films(), self.saved_fits(), self.saved_answers()];
        groups.into_iter().flatten().zip(now..).map(|((name, item), since)| (name, item.write(since))).collect()
    }

    /// Takes what a project holds, in the order in which it was written: fits come after their records. What is here already stays
    /// as it is. How many items could not be taken.
    pub fn take_project_items(&mut self, items: &[(String, String)]) -> usize {
        let mut refused = 0;
        for (name, text) in items {
            let Some((_, items)) = Item::read(text) else {
                refused += 1;
                continue;
            };
            let is_here = self.record_names().iter().any(|(_, own)| own == name)
                || self.saved_fits().iter().any(|(own, _)| own == name)
                || self.saved_films().iter().any(|(own, _)| own == name);
            for item in items.iter().filter(|_| !is_here) {
                let taken = self.restore_record(item).is_some()
                    || self.restore_film(item).is_some()
                    || self.restore_fit(item).is_some()
                    || self.restore_answer(name, item);
                refused += usize::from(!taken);
            }
        }
        refused
    }
}
