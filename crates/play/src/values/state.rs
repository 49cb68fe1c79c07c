//! Values of the states, for their fields.

use super::Shown;
use super::lines::Line;
use super::members::Members;
use super::readout::MOVING_DIGITS;
use crate::{Basis, TimeLine, number};
use program::{Node, Role};
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

impl Shown<'_> {
    /// All states defined by the author, in the order of the model.
    pub fn states(&self) -> Vec<StateView> {
        let states = self.basis.model().states.iter().enumerate().filter(|(_, state)| state.role == Role::Own);
        states.filter_map(|(index, _)| self.state(index)).collect()
    }

    /// One state; `None` for an unknown index.
    pub fn state(&self, index: usize) -> Option<StateView> {
        let state = self.basis.model().states.get(index)?;
        let &value = self.line.course().state().get(index)?;
        let text = self.line.state_number(self.basis, index, value);
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

    /// States in lines; for a family, the member selected with [`crate::Values::choose_member`].
    pub fn state_lines(&self) -> Vec<StateView> {
        let line = |line: &Line<usize>| {
            let &index = line.member(self.values.lines.chosen_of(line))?.parts.first()?;
            let view = self.state(index)?;
            let Some(members) = self.values.lines.family(line) else { return Some(view) };
            let labelled =
                |index: &&usize| self.basis.model().states.get(**index).is_some_and(|state| state.label.is_some());
            let all = || line.members.iter().flat_map(|member| &member.parts);
            let told = std::iter::once(&index).chain(all()).find(labelled);
            let label = told.map_or_else(|| line.name(), |&index| self.basis.state_label(index));
            Some(StateView { name: line.name(), label, members: Some(members), ..view })
        };
        self.values.lines.states.iter().filter_map(line).collect()
    }
}

impl TimeLine {
    /// Value (SI) of a state as a number in its own unit, for its field. Its resolution follows from the largest
    /// magnitude in this run. Empty for an unknown index.
    pub(crate) fn state_number(&self, basis: &Basis, index: usize, value: f64) -> String {
        let Some(state) = basis.model().states.get(index) else { return String::new() };
        let node = basis.model().graph.find(Node::State(index as u32));
        if node.is_some_and(|node| basis.is_count(node, &state.unit)) {
            return basis.count(value);
        }
        let scale = state.unit.from_si(self.greatest(index).max(value.abs()));
        Layout::of_scale(scale, MOVING_DIGITS).number(state.unit.from_si(value), basis.style())
    }
}
