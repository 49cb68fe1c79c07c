//! Undo: puts back what was removed or overwritten last.

use crate::removed::{Removed, Undo};
use crate::{Announcement, Play};

impl Play {
    /// Names what [`Play::undo`] would put back; `None` if there is nothing to undo.
    pub fn undo_number(&self) -> Option<u32> {
        self.undo.number()
    }

    /// Puts back what the removal of this number took away. Only the last removal can be undone; returns whether it was
    /// the one asked for.
    ///
    /// Parameters get their former values. Where one of them determines the initial state, the run starts again.
    pub fn undo(&mut self, number: u32) -> bool {
        let Some(removed) = self.undo.take(number) else { return false };
        match removed {
            Removed::Run(place, kept) => {
                let place = place.min(self.kept.len());
                self.kept.insert(place, kept);
                self.revision.runs += 1;
            }
            Removed::Ghost(ghost) => {
                self.ghost = Some(ghost);
                self.revision.runs += 1;
            }
            Removed::Parameters(parameters) => self.change_parameters(parameters),
            Removed::Start(setup) => self.restart(setup),
        }
        self.announce(Announcement::Undone);
        true
    }

    /// The number of a removal that somebody else can undo; the last one here no longer can be. Numbers ascend over all of
    /// them, so that only the last removal of all is undone.
    pub fn number_removal(&mut self) -> u32 {
        self.undo = Undo::after(self.undo.count() + 1);
        self.undo.count()
    }

    /// How many removals there have been.
    pub fn removals(&self) -> u32 {
        self.undo.count()
    }

    /// Goes on numbering where another simulation has left off; what that one removed stays removed.
    pub fn number_removals_from(&mut self, count: u32) {
        self.undo = Undo::after(count);
    }

    /// Remembers a removal, in place of the one before.
    pub(crate) fn can_undo(&mut self, removed: Removed) {
        self.undo.remember(removed);
    }

    /// Changes several parameters at once such that the former values can be put back.
    pub(crate) fn overwrite_parameters(&mut self, parameters: Vec<f64>) {
        let before = self.course.parameters().to_vec();
        if before == parameters {
            // Nothing is overwritten, and an older removal is not what a person would undo here.
            self.undo.forget();
            return;
        }
        self.change_parameters(parameters);
        self.can_undo(Removed::Parameters(before));
    }
}
