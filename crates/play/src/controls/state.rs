//! State set by hand, typed while the run is paused. It starts a new run from there and remains the start of the run
//! until another one is set or the defaults are restored.

use crate::{Announcement, Play, Refusal};
use engine::Setup;

impl Play {
    /// Starts a new run from the state shown with one value (SI) replaced. Refused while the run is playing.
    pub fn set_state(&mut self, index: usize, value: f64) -> Result<(), Refusal> {
        if self.line.is_playing() {
            return Err(Refusal::NotPaused);
        }
        if !value.is_finite() {
            return Err(Refusal::NoValue { name: self.basis.state_label(index) });
        }
        let mut state = self.course().state().to_vec();
        match state.get_mut(index) {
            Some(old) => *old = value,
            None => {
                return Err(Refusal::Unknown { name: index.to_string() });
            }
        }
        if let Some(missing) = state.iter().position(|value| !value.is_finite()) {
            return Err(Refusal::NoValue { name: self.basis.state_label(missing) });
        }
        self.start_from(state);
        self.announce(Announcement::StateSet(index, value));
        Ok(())
    }

    /// Sets a state from typed text, as [`Play::set_parameter_text`] does for a parameter.
    pub fn set_state_text(&mut self, index: usize, text: &str) -> Result<(), Refusal> {
        let unknown = || Refusal::Unknown { name: index.to_string() };
        let (view, state) = self.values().state(index).zip(self.model().states.get(index)).ok_or_else(unknown)?;
        match self.basis.read_field(self.course(), text, &view.text, &state.unit)? {
            Some(value) => self.set_state(index, value),
            None => Ok(()),
        }
    }

    /// True if the run started from a state set by hand instead of the model's initial values.
    pub fn is_started_by_hand(&self) -> bool {
        self.course().begun().start.is_some()
    }

    /// Starts a run from a state (SI) with the parameters shown.
    pub(crate) fn start_from(&mut self, state: Vec<f64>) {
        let parameters = self.course().parameters().to_vec();
        let setup = Setup { parameters, start: Some(state), ..self.course().begun().clone() };
        self.restart(setup);
    }
}
