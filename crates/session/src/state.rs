//! The state by hand: typed while paused, or dragged in the scene. Either starts a new run from there until reset.

use crate::{Refusal, Session};

/// A state as its field shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct StateView {
    /// Which of [`model::Model::states`].
    pub index: usize,
    /// `y'`; typeset it with [`model::typeset_name`].
    pub name: String,
    /// The label in the session's language; the name where there is none.
    pub label: String,
    /// The unit for people; empty for a pure number.
    pub unit: String,
    /// The value at the time shown, SI.
    pub value: f64,
    /// The value in the unit.
    pub text: String,
    /// Whether it can be set now: only while the run stands still.
    pub editable: bool,
}

impl Session {
    /// All states, in the order of the model.
    pub fn states(&self) -> Vec<StateView> {
        Vec::new()
    }

    /// Starts a new run from the state shown with one value replaced (SI). Refused while the run is playing.
    pub fn set_state(&mut self, index: usize, value: f64) -> Result<(), Refusal> {
        let _ = (index, value);
        Ok(())
    }

    /// The same from what was typed, in the state's unit or with a unit of the same dimension.
    pub fn set_state_text(&mut self, index: usize, text: &str) -> Result<(), Refusal> {
        let _ = (index, text);
        Ok(())
    }

    /// Takes hold of a part of the scene; the run stands still meanwhile.
    pub fn drag_begin(&mut self, drag: &document::Drag) {
        let _ = drag;
    }

    /// The pointer is now `right` and `up` scene units from where it took hold (up is positive).
    pub fn drag_move(&mut self, right: f64, up: f64) {
        let _ = (right, up);
    }

    /// Lets go: the run begins from there, and goes on if it was going on before.
    pub fn drag_end(&mut self) {}

    /// Whether a part of the scene is held.
    pub fn is_dragging(&self) -> bool {
        false
    }
}
