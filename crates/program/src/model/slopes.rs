//! The derivatives that stiff methods need.

use super::MOST_NODES;
use crate::{Graph, Model, NodeId, Variable, differentiate_all};

impl Model {
    /// The derivatives of all rates of change, for stiff methods: in a graph that extends the model's, first by each
    /// state, one column after the other, then by the independent variable. `None` if there would be too many nodes.
    pub fn slopes(&self) -> Option<(Graph, Vec<NodeId>)> {
        let mut graph = self.graph.clone();
        let rates: Vec<NodeId> = self.states.iter().map(|state| state.derivative).collect();
        let mut slopes = Vec::with_capacity(rates.len() * (rates.len() + 1));
        let states = (0..rates.len()).map(|number| Variable::State(number as u32));
        for variable in states.chain([Variable::Independent]) {
            slopes.extend(differentiate_all(&mut graph, &rates, variable));
            if graph.len() > MOST_NODES {
                return None;
            }
        }
        Some((graph, slopes))
    }
}
