//! Presses of buttons: a step ends where one is, and there its event acts.

use super::Stepper;
use crate::{Press, Record, RunError};
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

    /// The event of the next one, which acts now.
    fn take(&mut self) -> Option<usize> {
        let press = self.list.get(self.acted)?;
        self.acted += 1;
        self.events.get(press.button).copied()
    }
}

impl Stepper {
    /// Follows these presses; those that have acted are the first of them.
    pub(crate) fn set_presses(&mut self, presses: &[Press]) {
        self.presses.list.clear();
        self.presses.list.extend_from_slice(presses);
        self.presses.acted = self.presses.acted.min(presses.len());
    }

    /// The moment of the next press.
    pub(crate) fn next_press(&self) -> Option<f64> {
        self.presses.next()
    }

    /// Lets the next press act if it is of the present moment. What it changes leaves a row.
    pub(super) fn press(&mut self, record: &mut impl Record) -> Result<bool, RunError> {
        if self.presses.next().is_none_or(|next| next > self.time) {
            return Ok(false);
        }
        let Some(event) = self.presses.take() else { return Ok(false) };
        let fired = self.surfaces.events.fire_one(event, &mut self.equations, self.time, &self.state);
        self.act(fired, f64::MIN_POSITIVE, record)?;
        Ok(true)
    }
}
