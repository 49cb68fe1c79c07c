//! Presses of buttons: a step ends where one is, and there its event acts.

use crate::Press;
use program::Model;

/// The presses that a stepper follows.
#[derive(Clone, Debug)]
pub(super) struct Presses {
    /// For each button its event.
    events: Vec<usize>,
    /// In the order of time.
    list: Vec<Press>,
    /// How many have acted.
    acted: usize,
}

impl Presses {
    pub fn new(model: &Model, list: &[Press]) -> Self {
        let events = model.buttons.iter().map(|button| button.event as usize).collect();
        Self { events, list: list.to_vec(), acted: 0 }
    }

    /// How many have acted.
    pub fn acted(&self) -> usize {
        self.acted
    }

    /// Goes back or on to a moment at which so many have acted; those before `time` where it is not known.
    pub fn stand_at(&mut self, time: f64, acted: Option<usize>) {
        let before = || self.list.partition_point(|press| press.time < time);
        self.acted = acted.unwrap_or_else(before).min(self.list.len());
    }

    /// The moment of the next one.
    pub fn next(&self) -> Option<f64> {
        self.list.get(self.acted).map(|press| press.time)
    }

    /// Another list, of which those that have acted are the first.
    pub fn replace(&mut self, list: &[Press]) {
        self.list.clear();
        self.list.extend_from_slice(list);
        self.acted = self.acted.min(list.len());
    }

    /// The event of the next one, which acts now.
    pub fn take(&mut self) -> Option<usize> {
        let press = self.list.get(self.acted)?;
        self.acted += 1;
        self.events.get(press.button).copied()
    }
}
