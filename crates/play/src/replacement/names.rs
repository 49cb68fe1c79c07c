//! Which parameters and states of one model are those of another, by name and dimension.

use program::{Model, Node};

/// Where the names of a model stand in the one that replaces it.
#[derive(Debug)]
pub(super) struct Names {
    parameters: Vec<Option<usize>>,
    states: Vec<Option<usize>>,
    /// Whether the independent variable measures the same.
    pub same_time: bool,
}

impl Names {
    pub fn between(from: &Model, to: &Model) -> Self {
        let parameters = from.parameters.iter().map(|parameter| {
            let same = |other: &program::Parameter| {
                other.name == parameter.name
                    && other.unit.dimension == parameter.unit.dimension
                    && other.kind() == parameter.kind()
            };
            to.parameters.iter().position(same)
        });
        let states = from.states.iter().map(|state| {
            let same = |other: &program::State| {
                (&other.variable, other.order) == (&state.variable, state.order)
                    && other.unit.dimension == state.unit.dimension
            };
            to.states.iter().position(same)
        });
        Self {
            parameters: parameters.collect(),
            states: states.collect(),
            same_time: from.independent.unit.dimension == to.independent.unit.dimension,
        }
    }

    /// Where a parameter stands now.
    pub fn parameter(&self, index: usize) -> Option<usize> {
        *self.parameters.get(index)?
    }

    /// Where a state stands now.
    pub fn state(&self, index: usize) -> Option<usize> {
        *self.states.get(index)?
    }

    /// Where what is now this state stood before.
    pub fn former_state(&self, index: usize) -> Option<usize> {
        self.states.iter().position(|place| *place == Some(index))
    }

    /// What an input of the former graph is now, for [`program::Graph::same`].
    pub fn input(&self, node: Node) -> Option<Node> {
        match node {
            Node::Parameter(index) => Some(Node::Parameter(self.parameter(index as usize)? as u32)),
            Node::State(index) => Some(Node::State(self.state(index as usize)? as u32)),
            Node::Initial(index) => Some(Node::Initial(self.state(index as usize)? as u32)),
            other => Some(other).filter(|_| self.same_time),
        }
    }
}
