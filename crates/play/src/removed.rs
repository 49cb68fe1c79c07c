//! Storage of the last removal for undo, and the numbers of all.

use crate::time::kept::{Ghost, Kept};
use engine::Setup;

/// Content of the last removal. A kept run comes with its position in the list.
#[derive(Debug)]
pub(crate) enum Removed {
    Run(usize, Kept),
    Ghost(Ghost),
    /// Former values of the parameters, SI.
    Parameters(Vec<f64>),
    /// Former start of the run: the parameters and a state set by hand.
    Start(Setup),
}

/// Numbers of the removals here and in other components, and the last one if it was here.
#[derive(Debug, Default)]
pub struct Removals {
    /// Number of removals so far; identifies the last one.
    count: u32,
    last: Option<Removed>,
}

impl Removals {
    /// State after `count` removals, none of which can be undone here.
    pub(crate) fn after(count: u32) -> Self {
        Self { count, last: None }
    }

    /// Number of removals so far.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Number of the last removal, if it can be undone here.
    pub fn number(&self) -> Option<u32> {
        self.last.as_ref().map(|_| self.count)
    }

    /// Stores a removal, replacing the previous one.
    pub(crate) fn remember(&mut self, removed: Removed) {
        self.count += 1;
        self.last = Some(removed);
    }

    /// Removes and returns the removal with this number, if it is the last one.
    pub(crate) fn take(&mut self, number: u32) -> Option<Removed> {
        self.last.take_if(|_| self.count == number)
    }

    /// Discards the last removal, so that it cannot be undone.
    pub(crate) fn forget(&mut self) {
        self.last = None;
    }
}
