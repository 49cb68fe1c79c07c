//! Serialized form of a graph, and the checks when it is read.

use super::{Graph, Interpolation, LinearSystem, Node, NodeId, Written};
use std::sync::Arc;

impl From<Graph> for Written {
    fn from(graph: Graph) -> Self {
        let interpolations = graph.interpolations.iter().map(|interpolation| (**interpolation).clone()).collect();
        Self { nodes: graph.nodes, systems: graph.systems, interpolations }
    }
}

impl TryFrom<Written> for Graph {
    type Error = &'static str;

    fn try_from(written: Written) -> Result<Self, Self::Error> {
        let mut graph = Self { systems: written.systems, ..Self::default() };
        if !graph.systems.iter().all(LinearSystem::is_sound) {
            return Err("a linear system with entries outside its matrix");
        }
        let numbers = graph.systems.iter().map(LinearSystem::numbers).sum::<Option<usize>>();
        if numbers.is_none_or(|numbers| numbers > LinearSystem::MOST_NUMBERS) {
            return Err("linear systems that are too large");
        }
        if !written.interpolations.iter().all(Interpolation::is_sound) {
            return Err("a table whose points are in disorder");
        }
        graph.interpolations = written.interpolations.into_iter().map(Arc::new).collect();
        for (number, node) in written.nodes.into_iter().enumerate() {
            if let Node::Solution { system, row } = node
                && graph.systems.get(system as usize).is_none_or(|system| row as usize >= system.right.len())
            {
                return Err("a solution of no linear system");
            }
            if let Node::Piece(interpolation, _) | Node::Interpolated(interpolation, ..) = node
                && interpolation as usize >= graph.interpolations.len()
            {
                return Err("a value of no table");
            }
            if graph.insert(node).0 as usize != number {
                return Err("a node that is there twice");
            }
            let mut before = true;
            graph.for_each_operand(NodeId(number as u32), |operand| before &= (operand.0 as usize) < number);
            if !before {
                return Err("a node before its operands");
            }
        }
        Ok(graph)
    }
}
