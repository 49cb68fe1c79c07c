//! Whether two models move in the same way.

use crate::{Model, NodeId};

impl Model {
    /// Whether a run of the other model from the same parameters has the same bits: parameters of the same names in the same
    /// order, states, initial values, equations and events. Labels, ranges, defaults and defined quantities may differ.
    pub fn moves_like(&self, other: &Model) -> bool {
        let parameters = |model: &Model| -> Vec<_> {
            model.parameters.iter().map(|parameter| (parameter.name.clone(), parameter.unit.dimension)).collect()
        };
        // The steps of an adaptive method depend on the unit.
        let states = |model: &Model| -> Vec<_> {
            model.states.iter().map(|state| (state.variable.clone(), state.order, state.unit.clone())).collect()
        };
        self.independent == other.independent
            && parameters(self) == parameters(other)
            && states(self) == states(other)
            && self.targets() == other.targets()
            && self.buttons.iter().map(|button| button.event).eq(other.buttons.iter().map(|button| button.event))
            && self.events.iter().map(|event| event.stops).eq(other.events.iter().map(|event| event.stops))
            && self.graph.same(&self.motion(), &other.graph, &other.motion(), Some)
    }

    /// What decides how the states begin and move.
    fn motion(&self) -> Vec<NodeId> {
        let states = self.states.iter().flat_map(|state| [state.initial, state.derivative]);
        let events = self.events.iter().flat_map(|event| {
            let values = event.actions.iter().map(|(_, value)| *value);
            std::iter::once(event.condition).chain(values)
        });
        states.chain(events).collect()
    }

    /// Which states each event sets.
    fn targets(&self) -> Vec<Vec<u32>> {
        self.events.iter().map(|event| event.actions.iter().map(|(state, _)| *state).collect()).collect()
    }
}
