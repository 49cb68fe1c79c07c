//! Settings by the visitor: parameters, presets, states, method and step, drawn curves; presses of buttons.

use super::Grips;
use super::button::MOST_PRESSES;
use super::slider::Mapping;
use crate::removed::Removed;
use crate::{Announcement, Basis, Changes, Controls, Course, Refusal, TimeLine, Values};
use engine::{Method, Press, Setup};
use program::Model;

/// The controls with what they change: the run and its settings.
#[derive(Debug)]
pub struct Settings<'a> {
    pub(super) basis: &'a Basis,
    pub(super) line: &'a mut TimeLine,
    values: &'a mut Values,
    pub(super) controls: &'a mut Controls,
}

impl Controls {
    /// The controls with what they change.
    pub(crate) fn settings<'a>(
        &'a mut self,
        basis: &'a Basis,
        line: &'a mut TimeLine,
        values: &'a mut Values,
    ) -> Settings<'a> {
        Settings { basis, line, values, controls: self }
    }
}

impl Settings<'_> {
    pub(super) fn grips(&mut self) -> Grips<'_> {
        self.controls.grips(self.basis, self.line, self.values)
    }

    fn model(&self) -> &Model {
        self.basis.model()
    }

    pub(super) fn course(&self) -> &Course {
        self.line.course()
    }

    fn restart(&mut self, setup: Setup) -> Changes {
        self.line.restart(self.basis, setup)
    }

    /// Sets a parameter to an SI value. If an initial value depends on it, the run restarts; otherwise it takes effect
    /// from the next step.
    pub fn set_parameter(&mut self, index: usize, value: f64) -> Result<Changes, Refusal> {
        let value = self.basis.admit(index, value)?;
        let mut parameters = self.course().parameters().to_vec();
        match parameters.get_mut(index) {
            Some(old) if old.to_bits() != value.to_bits() => *old = value,
            _ => return Ok(Changes::NONE),
        }
        let changes = self.line.set_parameters(self.basis, parameters);
        Ok(changes.announcing(Announcement::ParameterSet(index, value)))
    }

    /// Sets a parameter from typed text: a number in the parameter's unit, a number with a unit of the same dimension,
    /// or an expression for its present value. The text shown in the field leaves the value unchanged.
    pub fn set_parameter_text(&mut self, index: usize, text: &str) -> Result<Changes, Refusal> {
        let unknown = || Refusal::Unknown { name: index.to_string() };
        let view = self.basis.parameter(self.course(), index).ok_or_else(unknown)?;
        let parameter = self.model().parameters.get(index).ok_or_else(unknown)?;
        match self.basis.read_field(self.course(), text, &view.text, &parameter.unit)? {
            Some(value) => self.set_parameter(index, value),
            None => Ok(Changes::NONE),
        }
    }

    /// Sets a parameter to the value at a slider position.
    pub fn slide(&mut self, index: usize, position: u32) -> Changes {
        let mapping = self.model().parameters.get(index).and_then(Mapping::of);
        // Slider values lie within the range, so this cannot be refused.
        let set = mapping.map(|mapping| mapping.value(position)).map(|value| self.set_parameter(index, value));
        set.and_then(Result::ok).unwrap_or_default()
    }

    /// Resets all parameters to their defaults. If the run started from a state set by hand or with drawn curves, it
    /// restarts with the document's initial values and curves.
    pub fn restore_defaults(&mut self) -> Changes {
        let Setup { parameters, drawings, .. } = self.basis.defaults().clone();
        let changes = if self.line.starts_as_written(self.basis) {
            self.line.overwrite_parameters(self.basis, parameters)
        } else {
            let before = self.line.setup();
            let setup = Setup { parameters, start: None, drawings, ..before.clone() };
            self.restart(setup).removing(Removed::Start(before))
        };
        changes.announcing(Announcement::DefaultsRestored)
    }

    /// Sets the parameters of a preset; each value may depend on those assigned before it. If one is refused, none is
    /// changed.
    pub fn apply_preset(&mut self, index: usize) -> Result<Changes, Refusal> {
        let unknown = || Refusal::Unknown { name: index.to_string() };
        let preset = self.basis.program().presets.get(index).ok_or_else(unknown)?;
        let parameters = self.controls.preset_parameters(self.basis, self.course(), index);
        let parameters = self.basis.admit_assignments(&preset.values, parameters)?;
        Ok(self.line.overwrite_parameters(self.basis, parameters).announcing(Announcement::Preset(index)))
    }

    /// Starts a new run from the state shown with one value (SI) replaced. Refused while the run is playing.
    pub fn set_state(&mut self, index: usize, value: f64) -> Result<Changes, Refusal> {
        if self.line.is_playing() {
            return Err(Refusal::NotPaused);
        }
        if !value.is_finite() {
            return Err(Refusal::NoValue { name: self.basis.state_label(index) });
        }
        let mut state = self.course().state().to_vec();
        *state.get_mut(index).ok_or_else(|| Refusal::Unknown { name: index.to_string() })? = value;
        if let Some(missing) = state.iter().position(|value| !value.is_finite()) {
            return Err(Refusal::NoValue { name: self.basis.state_label(missing) });
        }
        let setup = Setup { start: Some(state), ..self.line.setup() };
        Ok(self.restart(setup).announcing(Announcement::StateSet(index, value)))
    }

    /// Sets a state from typed text, as [`Settings::set_parameter_text`] does for a parameter.
    pub fn set_state_text(&mut self, index: usize, text: &str) -> Result<Changes, Refusal> {
        let unknown = || Refusal::Unknown { name: index.to_string() };
        let state = self.model().states.get(index).ok_or_else(unknown)?;
        let &value = self.course().state().get(index).ok_or_else(unknown)?;
        let shown = self.line.state_number(self.basis, index, value);
        match self.basis.read_field(self.course(), text, &shown, &state.unit)? {
            Some(value) => self.set_state(index, value),
            None => Ok(Changes::NONE),
        }
    }

    /// Selects a method by its name; the run restarts from its start.
    pub fn set_method(&mut self, name: &str) -> Result<Changes, Refusal> {
        let method: Method = name.parse().map_err(|_| Refusal::Unknown { name: name.to_owned() })?;
        if let Some(refusal) = self.basis.method_refusal(method) {
            return Err(refusal);
        }
        if method == self.course().begun().method && self.course().history().is_some() {
            return Ok(Changes::NONE);
        }
        let setup = Setup { method, ..self.line.setup() };
        Ok(self.restart(setup).announcing(Announcement::Method(method)))
    }

    /// Sets the step from typed text; the run restarts from its start.
    pub fn set_step_text(&mut self, text: &str) -> Result<Changes, Refusal> {
        if text.trim() == self.basis.step_text(self.course()).0 {
            return Ok(Changes::NONE);
        }
        let step = self.basis.read_value(text, &self.model().independent.unit)?;
        self.set_step(step)
    }

    /// Sets the step (SI); the run restarts from its start.
    pub fn set_step(&mut self, step: f64) -> Result<Changes, Refusal> {
        if !(step.is_finite() && step > 0.0) {
            return Err(Refusal::NotPositive);
        }
        if step == self.course().begun().step {
            return Ok(Changes::NONE);
        }
        let setup = Setup { step, ..self.line.setup() };
        Ok(self.restart(setup).announcing(Announcement::Step(step)))
    }

    /// Replaces a curve by one through points at these heights (0 to 1); the run restarts.
    pub fn draw(&mut self, index: usize, heights: &[f64]) -> Result<Changes, Refusal> {
        let values = self.basis.drawn_values(index, heights)?;
        let drawn = self.redraw(index, values).map(|changes| changes.announcing(Announcement::Drawn(index)));
        Ok(drawn.unwrap_or_default())
    }

    /// Restores the document's own curve; the run restarts.
    pub fn clear_drawing(&mut self, index: usize) -> Changes {
        let Some(values) = self.basis.defaults().drawings.get(index).cloned() else { return Changes::NONE };
        let before = self.line.setup();
        let Some(changes) = self.redraw(index, values) else { return Changes::NONE };
        changes.removing(Removed::Start(before)).announcing(Announcement::DrawingCleared(index))
    }

    /// Restarts with other values (SI) of a drawn curve; `None` if the curve has these values.
    fn redraw(&mut self, index: usize, values: Vec<f64>) -> Option<Changes> {
        let mut setup = self.line.setup();
        match setup.drawings.get_mut(index) {
            Some(own) if *own == values => return None,
            Some(own) => *own = values,
            None => {}
        }
        Some(self.restart(setup))
    }

    /// Presses a button at the moment shown. If an earlier moment is shown, the run continues from there and the later
    /// rows become the ghost.
    pub fn press(&mut self, index: usize) -> Result<Changes, Refusal> {
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
        Ok(self.line.press(index))
    }
}
