//! Undo: restores what was removed or overwritten last.

use super::removed::{Removed, Undo};
use crate::{Announcement, Play};

impl Play {
    /// Number of the removal that [`Play::undo`] would restore; `None` if there is none.
    pub fn undo_number(&self) -> Option<u32> {
        self.undo.number()
    }

    /// Undoes the removal with this number. Only the last removal can be undone; returns true if this was the last one.
    ///
    /// Parameters get their former values. If one of them determines the initial state, the run restarts.
    pub fn undo(&mut self, number: u32) -> bool {
        let Some(removed) = self.undo.take(number) else { return false };
        match removed {
            Removed::Run(place, kept) => {
                let changes = self.line.insert_kept(place, kept);
                self.note(changes);
            }
            Removed::Ghost(ghost) => {
                let changes = self.line.set_ghost(ghost);
                self.note(changes);
            }
            Removed::Parameters(parameters) => self.change_parameters(parameters),
            Removed::Start(setup) => self.restart(setup),
        }
        self.announce(Announcement::Undone);
        true
    }

    /// Issues a number for a removal that another component can undo; the last removal here can no longer be undone.
    /// All removals share one ascending sequence, so that only the very last one is undone.
    pub fn number_removal(&mut self) -> u32 {
        self.undo = Undo::after(self.undo.count() + 1);
        self.undo.count()
    }

    /// Number of removals so far.
    pub fn removals(&self) -> u32 {
        self.undo.count()
    }

    /// Continues the numbering of another simulation; its removals cannot be undone here.
    pub fn number_removals_from(&mut self, count: u32) {
        self.undo = Undo::after(count);
    }

    /// Stores a removal, replacing the previous one.
    pub(super) fn can_undo(&mut self, removed: Removed) {
        self.undo.remember(removed);
    }
}
