//! State set by hand, typed while the run is paused. It starts a new run from there and remains the start of the run
//! until another one is set or the defaults are restored.

use crate::values::Members;
use crate::values::lines::Line;
use crate::values::readout::MOVING_DIGITS;
use crate::{Announcement, Play, Refusal, number};
use engine::Setup;
use program::{Node, Role, State};
use units::number::Layout;

/// A state, for its field.
#[derive(Clone, Debug, PartialEq)]
pub struct StateView {
    /// Index into [`program::Model::states`].
    pub index: usize,
    /// Name, such as `y'`.
    pub name: String,
    /// Label in the chosen language; the name if there is none.
    pub label: String,
    /// Unit as displayed; empty for a pure number.
    pub unit: String,
    /// Value at the time shown, SI.
    pub value: f64,
    /// Value in the unit.
    pub text: String,
    /// Value with unit, for `aria-valuetext`.
    pub spoken: String,
    /// True if it can be set now: only while the run is paused.
    pub editable: bool,
    /// Family of the displayed member. Name and label are then those of the family. `None` for a state that stands
    /// alone.
    pub members: Option<Members>,
}

impl Play {
    /// All states defined by the author, in the order of the model.
    pub fn states(&self) -> Vec<StateView> {
        let states = self.model().states.iter().enumerate().filter(|(_, state)| state.role == Role::Own);
        states.filter_map(|(index, _)| self.state(index)).collect()
    }

    /// One state; `None` for an unknown index.
    pub fn state(&self, index: usize) -> Option<StateView> {
        let state = self.model().states.get(index)?;
        let &value = self.course().state().get(index)?;
        let text = self.state_number(index, state, value);
        Some(StateView {
            index,
            name: state.name(),
            label: self.basis.state_label(index),
            unit: number::unit_text(&state.unit.text),
            value,
            spoken: number::with_unit(&text.clone(), &state.unit),
            text,
            editable: !self.line.is_playing(),
            members: None,
        })
    }

    /// States in lines; for a family, the member selected with [`Play::choose_member`].
    pub fn state_lines(&self) -> Vec<StateView> {
        let line = |line: &Line<usize>| {
            let &index = line.member(self.lines.chosen_of(line))?.parts.first()?;
            let view = self.state(index)?;
            let Some(members) = self.lines.family(line) else { return Some(view) };
            let labelled = |index: &&usize| self.model().states.get(**index).is_some_and(|state| state.label.is_some());
            let all = || line.members.iter().flat_map(|member| &member.parts);
            let told = std::iter::once(&index).chain(all()).find(labelled);
            let label = told.map_or_else(|| line.name(), |&index| self.basis.state_label(index));
            Some(StateView { name: line.name(), label, members: Some(members), ..view })
        };
        self.lines.states.iter().filter_map(line).collect()
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
        let (view, state) = self.state(index).zip(self.model().states.get(index)).ok_or_else(unknown)?;
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

    /// Value of a state in its own unit, for its field. Its resolution follows from the largest magnitude in this run.
    pub(crate) fn state_number(&self, index: usize, state: &State, value: f64) -> String {
        let node = self.model().graph.find(Node::State(index as u32));
        if node.is_some_and(|node| self.basis.is_count(node, &state.unit)) {
            return self.basis.count(value);
        }
        let scale = self.line.greatest(index);
        let scale = state.unit.from_si(scale.max(value.abs()));
        Layout::of_scale(scale, MOVING_DIGITS).number(state.unit.from_si(value), self.basis.style())
    }
}
