//! Jacobian for stiff methods.

use super::MOST_NODES;
use crate::graph::differentiate_through;
use crate::{Graph, Model, Node, NodeId, Variable, differentiate_all};
use std::collections::HashMap;
use units::order::{sort, sort_by_key};

/// Derivatives of all rates, in a graph that extends that of the model.
#[derive(Clone, Debug)]
pub struct Slopes {
    /// The extended graph.
    pub graph: Graph,
    /// Derivatives with respect to the states, state by state; those that are identically 0 are left out.
    pub by_states: Vec<Slope>,
    /// Derivative of each rate with respect to the independent variable, one per state.
    pub by_independent: Vec<NodeId>,
}

/// Derivative of one rate with respect to one state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slope {
    /// Index of the state whose rate is differentiated.
    pub rate: u32,
    /// Index of the state with respect to which it is differentiated.
    pub state: u32,
    /// Node of the derivative.
    pub node: NodeId,
}

impl Model {
    /// Derivatives of all rates, for stiff methods. `None` if there would be too many nodes.
    pub fn slopes(&self) -> Option<Slopes> {
        let mut graph = self.graph.clone();
        let rates: Vec<NodeId> = self.states.iter().map(|state| state.derivative).collect();
        let readers = Readers::of(&graph, &rates);
        let mut numbers: HashMap<NodeId, Vec<u32>> = HashMap::new();
        for (number, rate) in (0..).zip(&rates) {
            numbers.entry(*rate).or_default().push(number);
        }
        let mut by_states = Vec::new();
        for state in 0..rates.len() as u32 {
            // Only nodes that depend on the state have a derivative with respect to it.
            let affected = self.graph.find(Node::State(state)).map(|node| readers.above(node)).unwrap_or_default();
            let derivatives = differentiate_through(&mut graph, &affected, Variable::State(state));
            let begin = by_states.len();
            for (node, &derivative) in affected.iter().filter_map(|node| Some((node, derivatives.get(node)?))) {
                let own = numbers.get(node).into_iter().flatten();
                by_states.extend(own.map(|&rate| Slope { rate, state, node: derivative }));
            }
            sort_by_key(&mut by_states[begin..], |slope| slope.rate);
            if graph.len() > MOST_NODES {
                return None;
            }
        }
        let by_independent = differentiate_all(&mut graph, &rates, Variable::Independent);
        (graph.len() <= MOST_NODES).then_some(Slopes { graph, by_states, by_independent })
    }
}

/// Direct users of each node, among the nodes on which some roots depend.
struct Readers(HashMap<NodeId, Vec<NodeId>>);

impl Readers {
    fn of(graph: &Graph, roots: &[NodeId]) -> Self {
        let mut readers: HashMap<NodeId, Vec<NodeId>> = HashMap::new();
        for &root in roots {
            readers.entry(root).or_default();
        }
        for node in graph.reachable(roots) {
            graph.for_each_operand(node, |operand| {
                let readers = readers.entry(operand).or_default();
                // A square has the same operand twice.
                if readers.last() != Some(&node) {
                    readers.push(node);
                }
            });
        }
        Self(readers)
    }

    /// A node and all nodes that depend on it, operands first.
    fn above(&self, node: NodeId) -> Vec<NodeId> {
        let mut found = Vec::new();
        let mut seen = std::collections::HashSet::new();
        let mut waiting = vec![node];
        while let Some(next) = waiting.pop() {
            if let Some(readers) = self.0.get(&next)
                && seen.insert(next)
            {
                found.push(next);
                waiting.extend(readers);
            }
        }
        sort(&mut found);
        found
    }
}
