//! Settings by the visitor: parameters, presets, states, method and step, drawn curves; presses of buttons.

use super::removed::Removed;
use crate::controls::button::MOST_PRESSES;
use crate::controls::slider::Mapping;
use crate::{Announcement, Changes, Play, Refusal};
use engine::{Method, Press, Setup};
use program::Parameter;

impl Play {
    /// Sets a parameter to an SI value. If an initial value depends on it, the run restarts; otherwise it takes effect
    /// from the next step.
    pub fn set_parameter(&mut self, index: usize, value: f64) -> Result<(), Refusal> {
        let value = self.basis.admit(index, value)?;
        let mut parameters = self.course().parameters().to_vec();
        let Some(old) = parameters.get_mut(index) else {
            return Ok(());
        };
        if old.to_bits() == value.to_bits() {
            return Ok(());
        }
        *old = value;
        self.change_parameters(parameters);
        self.announce(Announcement::ParameterSet(index, value));
        Ok(())
    }

    /// Sets a parameter from typed text: a number in the parameter's unit, a number with a unit of the same dimension,
    /// or an expression for its present value. The text shown in the field leaves the value unchanged.
    pub fn set_parameter_text(&mut self, index: usize, text: &str) -> Result<(), Refusal> {
        let unknown = || Refusal::Unknown { name: index.to_string() };
        let (view, parameter) =
            self.basis.parameter(self.course(), index).zip(self.model().parameters.get(index)).ok_or_else(unknown)?;
        match self.basis.read_field(self.course(), text, &view.text, &parameter.unit)? {
            Some(value) => self.set_parameter(index, value),
            None => Ok(()),
        }
    }

    /// Sets a parameter to the value at a slider position.
    pub fn slide(&mut self, index: usize, position: u32) {
        let Some(mapping) = self.model().parameters.get(index).and_then(Mapping::of) else {
            return;
        };
        // Slider values lie within the range, so this cannot be refused.
        let _ = self.set_parameter(index, mapping.value(position));
    }

    /// Resets one parameter to its default.
    pub fn restore_default(&mut self, index: usize) {
        if let Some(value) = self.model().parameters.get(index).map(|parameter| parameter.value) {
            let _ = self.set_parameter(index, value);
        }
    }

    /// Resets all parameters to their defaults. If the run started from a state set by hand or with drawn curves, it
    /// restarts with the document's initial values and curves.
    pub fn restore_defaults(&mut self) {
        let parameters = self.basis.defaults().parameters.clone();
        if !self.starts_as_written() {
            let before = self.setup();
            let drawings = self.basis.defaults().drawings.clone();
            self.restart(Setup { parameters, start: None, drawings, ..before.clone() });
            self.can_undo(Removed::Start(before));
        } else {
            self.overwrite_parameters(parameters);
        }
        self.announce(Announcement::DefaultsRestored);
    }

    /// Sets the parameters of a preset; each value may depend on those assigned before it. If one is refused, none is
    /// changed.
    pub fn apply_preset(&mut self, index: usize) -> Result<(), Refusal> {
        let parameters = self.controls.preset_parameters(&self.basis, self.line.course(), index);
        let preset =
            self.basis.program().presets.get(index).ok_or_else(|| Refusal::Unknown { name: index.to_string() })?;
        let parameters = self.basis.admit_assignments(&preset.values, parameters)?;
        self.overwrite_parameters(parameters);
        self.announce(Announcement::Preset(index));
        Ok(())
    }

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

    /// True if all sizes and parameters have the values of the document, and the run starts with its initial values and curves.
    pub fn is_as_written(&self) -> bool {
        self.starts_as_written()
            && self.basis.sizes().iter().all(|size| size.is_default)
            && self.basis.parameters(self.course()).iter().all(|parameter| parameter.is_default)
    }

    /// True if the run starts with the document's initial values and curves.
    fn starts_as_written(&self) -> bool {
        !self.is_started_by_hand() && self.course().begun().drawings == self.basis.defaults().drawings
    }

    /// True if the run started from a state set by hand instead of the model's initial values.
    pub fn is_started_by_hand(&self) -> bool {
        self.course().begun().start.is_some()
    }

    /// Starts a run from a state (SI) with the parameters shown.
    fn start_from(&mut self, state: Vec<f64>) {
        let parameters = self.course().parameters().to_vec();
        let setup = Setup { parameters, start: Some(state), ..self.course().begun().clone() };
        self.restart(setup);
    }

    /// Selects a method by its name; the run restarts from its start.
    pub fn set_method(&mut self, name: &str) -> Result<(), Refusal> {
        let method: Method = name.parse().map_err(|_| Refusal::Unknown { name: name.to_owned() })?;
        if let Some(refusal) = self.basis.method_refusal(method) {
            return Err(refusal);
        }
        if method != self.course().begun().method || self.course().history().is_none() {
            let parameters = self.course().parameters().to_vec();
            self.restart(Setup { method, parameters, ..self.course().begun().clone() });
            self.announce(Announcement::Method(method));
        }
        Ok(())
    }

    /// Sets the step from typed text; the run restarts from its start.
    pub fn set_step_text(&mut self, text: &str) -> Result<(), Refusal> {
        if text.trim() == self.basis.step_text(self.course()).0 {
            return Ok(());
        }
        let step = self.basis.read_value(text, &self.model().independent.unit)?;
        self.set_step(step)
    }

    /// Sets the step (SI); the run restarts from its start.
    pub fn set_step(&mut self, step: f64) -> Result<(), Refusal> {
        if !(step.is_finite() && step > 0.0) {
            return Err(Refusal::NotPositive);
        }
        if step != self.course().begun().step {
            let parameters = self.course().parameters().to_vec();
            self.restart(Setup { step, parameters, ..self.course().begun().clone() });
            self.announce(Announcement::Step(step));
        }
        Ok(())
    }

    /// Replaces a curve by one through points at these heights (0 to 1); the run restarts.
    pub fn draw(&mut self, index: usize, heights: &[f64]) -> Result<(), Refusal> {
        let values = self.basis.drawn_values(index, heights)?;
        if self.course().begun().drawings.get(index) != Some(&values) {
            self.redraw(index, values);
            self.announce(Announcement::Drawn(index));
        }
        Ok(())
    }

    /// Restores the document's own curve; the run restarts.
    pub fn clear_drawing(&mut self, index: usize) {
        let Some(values) = self.basis.defaults().drawings.get(index).cloned() else { return };
        if self.course().begun().drawings.get(index) != Some(&values) {
            let before = self.setup();
            self.redraw(index, values);
            self.can_undo(Removed::Start(before));
            self.announce(Announcement::DrawingCleared(index));
        }
    }

    fn redraw(&mut self, index: usize, values: Vec<f64>) {
        let parameters = self.course().parameters().to_vec();
        let mut setup = Setup { parameters, ..self.course().begun().clone() };
        if let Some(own) = setup.drawings.get_mut(index) {
            *own = values;
        }
        self.restart(setup);
    }

    /// Replaces the drawn curves of the model. Does nothing if they are unchanged.
    pub(super) fn adopt_drawings(&mut self, drawings: &[Vec<f64>]) {
        if !self.basis.set_drawings(drawings) {
            return;
        }
        self.line.model_changed(&self.basis);
        self.controls.model_changed(self.basis.program());
        self.values.basis_changed(&self.basis);
        self.answers.model_changed(self.basis.program());
        self.plots.model_changed(self.basis.program(), self.line.columns());
        self.note(Changes::PARAMETERS);
    }

    /// Presses a button at the moment shown. If an earlier moment is shown, the run continues from there and the later
    /// rows become the ghost.
    pub fn press(&mut self, index: usize) -> Result<(), Refusal> {
        if index >= self.model().buttons.len() {
            return Err(Refusal::Unknown { name: index.to_string() });
        }
        if !self.line.can_press() {
            return Err(Refusal::RunEnded);
        }
        let time = self.course().time();
        let before = |press: &&Press| press.time <= time;
        if self.course().begun().presses.iter().filter(before).count() >= MOST_PRESSES {
            return Err(Refusal::TooManyPresses { most: MOST_PRESSES });
        }
        self.controls.hold(None);
        self.branch();
        let changes = self.line.press(index);
        self.note(changes);
        self.announce(Announcement::Pressed(index, time));
        if self.course().error().is_some() && self.line.is_playing() {
            self.stop();
            self.announce(Announcement::Failed);
        }
        Ok(())
    }

    /// Sets all parameters (SI). Restarts the run if an initial value depends on a changed one.
    pub(super) fn change_parameters(&mut self, parameters: Vec<f64>) {
        let old = self.course().parameters();
        if old == parameters {
            return;
        }
        let deciding = |(index, parameter): (usize, &Parameter)| {
            (parameter.restarts && old.get(index) != parameters.get(index)).then_some(index)
        };
        let decides = self.model().parameters.iter().enumerate().find_map(deciding);
        self.note(Changes::PARAMETERS);
        if decides.is_some() || self.course().history().is_none() {
            let setup = Setup { parameters, start: None, ..self.course().begun().clone() };
            let begun = self.course().front() > 0.0 || self.is_started_by_hand();
            self.restart(setup);
            if let (Some(index), true) = (decides, begun) {
                self.announce(Announcement::Restarted(index));
            }
        } else {
            self.branch();
            let changes = self.line.set_parameters(self.basis.model(), parameters);
            self.note(changes);
        }
    }

    /// Changes several parameters (SI) at once; can be undone.
    pub(super) fn overwrite_parameters(&mut self, parameters: Vec<f64>) {
        let before = self.course().parameters().to_vec();
        if before == parameters {
            // Nothing is overwritten, and the user would not expect an older removal to be undone here.
            self.undo.forget();
            return;
        }
        self.change_parameters(parameters);
        self.can_undo(Removed::Parameters(before));
    }
}
