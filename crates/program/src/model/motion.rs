//! Comparison of the dynamics of two models.

use crate::{Model, NodeId};

impl Model {
    /// True if a run of the other model with the same parameters has the same bits: parameters of the same names in the
    /// same order, and equal states, initial values, equations and events. Labels, ranges, defaults and defined quantities
    /// may differ.
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

    /// All nodes that determine the initial state and the motion.
    fn motion(&self) -> Vec<NodeId> {
        let states = self.states.iter().flat_map(|state| [state.initial, state.derivative]);
        let events = self.events.iter().flat_map(|event| {
            let values = event.actions.iter().map(|(_, value)| *value);
            std::iter::once(event.condition).chain(values)
        });
        states.chain(events).collect()
    }

    /// Indices of the states that each event sets.
    fn targets(&self) -> Vec<Vec<u32>> {
        self.events.iter().map(|event| event.actions.iter().map(|(state, _)| *state).collect()).collect()
    }
}
