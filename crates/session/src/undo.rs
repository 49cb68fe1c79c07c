//! Undo: puts back what was removed or overwritten last.

use crate::fitted::Fitted;
use crate::kept::{Ghost, Kept};
use crate::record::Record;
use crate::{Announcement, Session};
use engine::Setup;

/// What the last removal took away, with its place in its list.
#[derive(Debug)]
pub(crate) enum Removed {
    Record(usize, Record),
    Fit(usize, Box<Fitted>),
    Run(usize, Kept),
    Ghost(Ghost),
    /// The values that the parameters had, SI.
    Parameters(Vec<f64>),
    /// What the run began with: the parameters, and a state set by hand.
    Start(Setup),
}

/// The last removal.
#[derive(Debug, Default)]
pub(crate) struct Undo {
    /// How many removals there have been; names the last one.
    count: u32,
    last: Option<Removed>,
}

impl Session {
    /// Names what [`Session::undo`] would put back; `None` if there is nothing to undo.
    pub fn undo_number(&self) -> Option<u32> {
        self.undo.last.as_ref().map(|_| self.undo.count)
    }

    /// Puts back what the removal of this number took away. Only the last removal can be undone; returns whether it was
    /// the one asked for.
    ///
    /// Parameters get their former values. Where one of them determines the initial state, the run starts again.
    pub fn undo(&mut self, number: u32) -> bool {
        if self.undo.count != number {
            return false;
        }
        let Some(removed) = self.undo.last.take() else { return false };
        match removed {
            Removed::Record(place, record) => {
                let place = place.min(self.data.records.len());
                self.data.records.insert(place, record);
                self.records_changed();
            }
            Removed::Fit(place, fit) => {
                let place = place.min(self.fits.finished.len());
                self.fits.finished.insert(place, *fit);
                self.revision.fits += 1;
            }
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

    /// Goes on numbering where the session of another document has left off; what that one removed stays removed.
    pub(crate) fn adopt_undo(&mut self, other: &Session) {
        self.undo = Undo { count: other.undo.count, last: None };
    }

    /// Remembers a removal, in place of the one before.
    pub(crate) fn can_undo(&mut self, removed: Removed) {
        self.undo.count += 1;
        self.undo.last = Some(removed);
    }

    /// Changes several parameters at once such that the former values can be put back.
    pub(crate) fn overwrite_parameters(&mut self, parameters: Vec<f64>) {
        let before = self.course.parameters().to_vec();
        if before == parameters {
            // Nothing is overwritten, and an older removal is not what a person would undo here.
            self.undo.last = None;
            return;
        }
        self.change_parameters(parameters);
        self.can_undo(Removed::Parameters(before));
    }
}
