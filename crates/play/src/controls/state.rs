//! The state by hand: typed while the run stands still. It starts a new run from there, and stays the start of the run
//! until another one is set or the defaults are restored.

use crate::values::Members;
use crate::values::lines::Line;
use crate::values::readout::MOVING_DIGITS;
use crate::{Announcement, Play, Refusal, number};
use engine::Setup;
use program::{Node, Role, State};
use units::number::Layout;

/// A state as its field shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct StateView {
    /// Which of [`program::Model::states`].
    pub index: usize,
    /// `y'`.
    pub name: String,
    /// The label in the chosen language; the name where there is none.
    pub label: String,
    /// The unit for people; empty for a pure number.
    pub unit: String,
    /// The value at the time shown, SI.
    pub value: f64,
    /// The value in the unit.
    pub text: String,
    /// The value with its unit, for `aria-valuetext`.
    pub spoken: String,
    /// Whether it can be set now: only while the run stands still.
    pub editable: bool,
    /// The family of whose members this one is shown, where it stands for all of them; name and label are then the family's.
    pub members: Option<Members>,
}

impl Play {
    /// All states of the author, in the order of the model.
    pub fn states(&self) -> Vec<StateView> {
        let states = self.model().states.iter().enumerate().filter(|(_, state)| state.role == Role::Own);
        states.filter_map(|(index, _)| self.state(index)).collect()
    }

    /// One state.
    pub fn state(&self, index: usize) -> Option<StateView> {
        let state = self.model().states.get(index)?;
        let &value = self.course.state().get(index)?;
        let text = self.state_number(index, state, value);
        Some(StateView {
            index,
            name: state.name(),
            label: self.state_label(index),
            unit: number::unit_text(&state.unit.text),
            value,
            spoken: self.with_unit(text.clone(), &state.unit),
            text,
            editable: !self.playing,
            members: None,
        })
    }

    /// The states in lines: of a family the member that is chosen ([`Play::choose_member`]).
    pub fn state_lines(&self) -> Vec<StateView> {
        let line = |line: &Line<usize>| {
            let &index = line.member(self.lines.chosen_of(line))?.parts.first()?;
            let view = self.state(index)?;
            let Some(members) = self.lines.family(line) else { return Some(view) };
            let labelled = |index: &&usize| self.model().states.get(**index).is_some_and(|state| state.label.is_some());
            let all = || line.members.iter().flat_map(|member| &member.parts);
            let told = std::iter::once(&index).chain(all()).find(labelled);
            let label = told.map_or_else(|| line.name(), |&index| self.state_label(index));
            Some(StateView { name: line.name(), label, members: Some(members), ..view })
        };
        self.lines.states.iter().filter_map(line).collect()
    }

    /// Starts a new run from the state shown with one value replaced (SI). Refused while the run is playing.
    pub fn set_state(&mut self, index: usize, value: f64) -> Result<(), Refusal> {
        if self.playing {
            return Err(Refusal::NotPaused);
        }
        if !value.is_finite() {
            return Err(Refusal::NoValue { name: self.state_label(index) });
        }
        let mut state = self.course.state().to_vec();
        match state.get_mut(index) {
            Some(old) => *old = value,
            None => {
                return Err(Refusal::Unknown { name: index.to_string() });
            }
        }
        if let Some(missing) = state.iter().position(|value| !value.is_finite()) {
            return Err(Refusal::NoValue { name: self.state_label(missing) });
        }
        self.start_from(state);
        self.announce(Announcement::StateSet(index, value));
        Ok(())
    }

    /// The same from what was typed, as [`Play::set_parameter_text`] takes it.
    pub fn set_state_text(&mut self, index: usize, text: &str) -> Result<(), Refusal> {
        let unknown = || Refusal::Unknown { name: index.to_string() };
        let (view, state) = self.state(index).zip(self.model().states.get(index)).ok_or_else(unknown)?;
        match self.read_field(text, &view.text, &state.unit)? {
            Some(value) => self.set_state(index, value),
            None => Ok(()),
        }
    }

    /// Whether the run began from a state set by hand and not from the model's initial values.
    pub fn is_started_by_hand(&self) -> bool {
        self.course.begun().start.is_some()
    }

    /// Starts a run from a state, with the parameters shown.
    pub(crate) fn start_from(&mut self, state: Vec<f64>) {
        let parameters = self.course.parameters().to_vec();
        let setup = Setup { parameters, start: Some(state), ..self.course.begun().clone() };
        self.restart(setup);
    }

    /// The label of a state in the chosen language; its name where it has none.
    pub(crate) fn state_label(&self, index: usize) -> String {
        let Some(state) = self.model().states.get(index) else {
            return String::new();
        };
        state.label.as_deref().map_or_else(|| state.name(), |label| self.text(label).to_owned())
    }

    /// A state's value in its own unit, for its field, with the resolution that its swing in this run calls for.
    pub(crate) fn state_number(&self, index: usize, state: &State, value: f64) -> String {
        let node = self.model().graph.find(Node::State(index as u32));
        if node.is_some_and(|node| self.is_count(node, &state.unit)) {
            return self.count(value);
        }
        let scale = self.scales.get(index).copied().unwrap_or_default();
        let scale = state.unit.from_si(scale.max(value.abs()));
        Layout::of_scale(scale, MOVING_DIGITS).number(state.unit.from_si(value), self.style)
    }
}
