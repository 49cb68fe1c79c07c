//! Selection of the displayed member of a family.

use crate::{Changes, Play};

impl Play {
    /// Displays another member of a family: sets the index at position `place` to `value`. If that member does not
    /// exist, the next one in the direction of the change.
    pub fn choose_member(&mut self, family: &str, place: usize, value: i64) {
        let lines = &self.lines;
        let readout = lines.readouts.iter().find(|line| line.is_family() && line.name() == family);
        let state = || lines.states.iter().find(|line| line.is_family() && line.name() == family);
        let found = match readout {
            Some(line) => lines.moved(line, place, value).map(|indices| (line.stem.clone(), indices)),
            None => state().and_then(|line| Some((line.stem.clone(), lines.moved(line, place, value)?))),
        };
        if let Some((stem, indices)) = found {
            self.lines.chosen.insert(stem, indices);
            self.note(Changes::FRAME);
        }
    }
}
