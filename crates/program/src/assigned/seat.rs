//! Seats of a class.

use super::hash::hash;
use serde::{Deserialize, Serialize};
use std::num::NonZeroU32;
use std::str::FromStr;

/// Number of seats in a block.
pub(crate) const BLOCK: u32 = 8;

/// Seat of a student, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Seat(NonZeroU32);

impl Seat {
    /// Greatest seat that a teacher assigns. Greater ones are hashes of names, whose values are not compared.
    pub const MOST: u32 = 9999;

    /// The seat with this number; `None` for 0.
    pub fn new(number: u32) -> Option<Self> {
        NonZeroU32::new(number).map(Self)
    }

    /// Seat of a learner whom a course names by a text, for an assignment: a hash above [`Self::MOST`].
    pub fn of_learner(assignment: &str, learner: &str) -> Self {
        let above = u32::MAX - Self::MOST;
        let place = (u128::from(hash(&[assignment, learner])) * u128::from(above)) >> 64;
        Self(NonZeroU32::MIN.saturating_add(Self::MOST + place as u32))
    }

    /// Its number, from 1.
    pub fn number(self) -> u32 {
        self.0.get()
    }

    /// Block and place in the block, both from 0.
    pub(super) fn place(self) -> (u32, usize) {
        let index = self.number() - 1;
        (index / BLOCK, (index % BLOCK) as usize)
    }
}

/// Digits of a number from 1.
impl FromStr for Seat {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        text.parse().ok().filter(|_| digits).and_then(Self::new).ok_or(())
    }
}
