//! Undo: restores what was removed or overwritten last.

use super::Play;
use crate::Announcement;
use crate::time::kept::{Ghost, Kept};
use engine::Setup;

/// Content of the last removal. A kept run comes with its position in the list.
#[derive(Debug)]
pub(super) enum Removed {
    Run(usize, Kept),
    Ghost(Ghost),
    /// Former values of the parameters, SI.
    Parameters(Vec<f64>),
    /// Former start of the run: the parameters and a state set by hand.
    Start(Setup),
}

/// The last removal.
#[derive(Debug, Default)]
pub(super) struct Undo {
    /// Number of removals so far; identifies the last one.
    count: u32,
    last: Option<Removed>,
}

impl Undo {
    /// State after `count` removals, none of which can be undone here.
    pub fn after(count: u32) -> Self {
        Self { count, last: None }
    }

    /// Number of removals so far.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Number of the last removal, if it can be undone.
    pub fn number(&self) -> Option<u32> {
        self.last.as_ref().map(|_| self.count)
    }

    /// Stores a removal, replacing the previous one.
    pub fn remember(&mut self, removed: Removed) {
        self.count += 1;
        self.last = Some(removed);
    }

    /// Removes and returns the removal with this number, if it is the last one.
    pub fn take(&mut self, number: u32) -> Option<Removed> {
        self.last.take_if(|_| self.count == number)
    }

    /// Discards the last removal, so that it cannot be undone.
    pub fn forget(&mut self) {
        self.last = None;
    }
}

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
