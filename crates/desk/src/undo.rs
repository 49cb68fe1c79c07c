//! Undo: restores the last item that was removed or overwritten, here or in the simulation.

use crate::removed::Removed;
use crate::{Announcement, Desk};

impl Desk {
    /// Number of the removal that [`Desk::undo`] would undo; `None` if there is nothing to undo.
    pub fn undo_number(&self) -> Option<u32> {
        let own = self.removed.as_ref().map(|(number, _)| *number);
        self.play.undo_number().or(own.filter(|number| *number == self.play.removals()))
    }

    /// Undoes the removal of this number. Only the last removal can be undone; returns true if it was this one.
    pub fn undo(&mut self, number: u32) -> bool {
        if self.undo_number() != Some(number) {
            return false;
        }
        if self.play.undo_number() == Some(number) {
            return self.play.undo(number);
        }
        let Some((_, removed)) = self.removed.take() else { return false };
        match removed {
            Removed::Record(place, record) => {
                let place = place.min(self.data.records.len());
                self.data.records.insert(place, *record);
                self.records_changed();
            }
            Removed::Fit(place, fit) => {
                let place = place.min(self.fits.finished.len());
                self.fits.finished.insert(place, *fit);
                self.revision.fits += 1;
            }
        }
        self.announce(Announcement::Play(play::Announcement::Undone));
        true
    }

    /// Records a removal for undo. Replaces the previous one.
    pub(crate) fn can_undo(&mut self, removed: Removed) {
        self.removed = Some((self.play.number_removal(), removed));
    }
}
