//! Presses of buttons: a step ends at each press, and its event acts there.

use crate::Press;
use program::Model;

/// The presses of a run.
#[derive(Clone, Debug)]
pub(super) struct Presses {
    /// Index of the event of each button.
    events: Vec<usize>,
    /// Ascending in time.
    list: Vec<Press>,
    /// Number of presses that have acted.
    acted: usize,
}

impl Presses {
    pub fn new(model: &Model, list: &[Press]) -> Self {
        let events = model.buttons.iter().map(|button| button.event as usize).collect();
        Self { events, list: list.to_vec(), acted: 0 }
    }

    /// Number of presses that have acted.
    pub fn acted(&self) -> usize {
        self.acted
    }

    /// Moves to a moment at which `acted` presses have acted; `None`: all presses before `time`.
    pub fn stand_at(&mut self, time: f64, acted: Option<usize>) {
        let before = || self.list.partition_point(|press| press.time < time);
        self.acted = acted.unwrap_or_else(before).min(self.list.len());
    }

    /// Time of the next press, SI units.
    pub fn next(&self) -> Option<f64> {
        self.list.get(self.acted).map(|press| press.time)
    }

    /// Replaces the list; presses that have acted must be its first ones.
    pub fn replace(&mut self, list: &[Press]) {
        self.list.clear();
        self.list.extend_from_slice(list);
        self.acted = self.acted.min(list.len());
    }

    /// Marks the next press as acted and returns the index of its event.
    pub fn take(&mut self) -> Option<usize> {
        let press = self.list.get(self.acted)?;
        self.acted += 1;
        self.events.get(press.button).copied()
    }
}
