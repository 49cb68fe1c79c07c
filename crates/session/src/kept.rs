//! Runs kept for comparison, and the ghost of the run that was given up last.

use crate::{Refusal, Session};

/// A kept run in the list.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptView {
    /// Names the run as long as it exists.
    pub id: u32,
    /// What distinguishes it: `b = 200 kg/s`.
    pub name: String,
    /// Whether it is drawn.
    pub shown: bool,
    /// Which ink it is drawn with: `Ink` of the figure by this number.
    pub ink: u8,
}

impl Session {
    /// Keeps the run as it is now, to be drawn behind later ones.
    pub fn keep(&mut self) -> Result<(), Refusal> {
        Ok(())
    }

    /// The kept runs, oldest first.
    pub fn kept(&self) -> Vec<KeptView> {
        Vec::new()
    }

    /// Draws a kept run or not.
    pub fn show_kept(&mut self, id: u32, shown: bool) {
        let _ = (id, shown);
    }

    /// Forgets a kept run.
    pub fn remove_kept(&mut self, id: u32) {
        let _ = id;
    }

    /// Whether the rows given up last are drawn.
    pub fn has_ghost(&self) -> bool {
        false
    }

    /// Forgets the ghost.
    pub fn clear_ghost(&mut self) {}
}
