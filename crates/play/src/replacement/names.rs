//! Matches the parameters and states of two models by name and dimension.

use program::{Model, Node};

/// Maps indices of a model to indices of the model that replaces it.
#[derive(Debug)]
pub(crate) struct Names {
    parameters: Vec<Option<usize>>,
    states: Vec<Option<usize>>,
    /// True if the independent variable has the same dimension.
    pub same_time: bool,
}

impl Names {
    pub fn between(from: &Model, to: &Model) -> Self {
        let parameters = from.parameters.iter().map(|parameter| {
            let same = |other: &program::Parameter| {
                other.name == parameter.name
                    && other.unit.dimension == parameter.unit.dimension
                    // 3 Hz are not 3 rad/s.
                    && other.unit.turning(&parameter.unit) == 1.0
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

    /// New index of a parameter.
    pub fn parameter(&self, index: usize) -> Option<usize> {
        *self.parameters.get(index)?
    }

    /// New index of a state.
    pub fn state(&self, index: usize) -> Option<usize> {
        *self.states.get(index)?
    }

    /// Former index of a state with this new index.
    pub fn former_state(&self, index: usize) -> Option<usize> {
        self.states.iter().position(|place| *place == Some(index))
    }

    /// Node of the new graph for an input of the former one, for [`program::Graph::same`].
    pub fn input(&self, node: Node) -> Option<Node> {
        match node {
            Node::Parameter(index) => Some(Node::Parameter(self.parameter(index as usize)? as u32)),
            Node::State(index) => Some(Node::State(self.state(index as usize)? as u32)),
            Node::Initial(index) => Some(Node::Initial(self.state(index as usize)? as u32)),
            other => Some(other).filter(|_| self.same_time),
        }
    }
}
