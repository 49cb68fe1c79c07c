//! What was removed or overwritten last.

use crate::plots::kept::{Ghost, Kept};
use engine::Setup;

/// What the last removal took away, with its place in its list.
#[derive(Debug)]
pub(crate) enum Removed {
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

impl Undo {
    /// Goes on numbering after so many removals, none of which can be undone here.
    pub fn after(count: u32) -> Self {
        Self { count, last: None }
    }

    /// How many removals there have been.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// The number of the last removal, if it can be undone.
    pub fn number(&self) -> Option<u32> {
        self.last.as_ref().map(|_| self.count)
    }

    /// Remembers a removal, in place of the one before.
    pub fn remember(&mut self, removed: Removed) {
        self.count += 1;
        self.last = Some(removed);
    }

    /// What the removal of this number took away, if it is the last one.
    pub fn take(&mut self, number: u32) -> Option<Removed> {
        self.last.take_if(|_| self.count == number)
    }

    /// The last removal can no longer be undone.
    pub fn forget(&mut self) {
        self.last = None;
    }
}
