//! A graph as it is written to a bundle, and the checks of one that is read.

use super::{Graph, LinearSystem, Node, NodeId, Written};

impl From<Graph> for Written {
    fn from(graph: Graph) -> Self {
        Self { nodes: graph.nodes, systems: graph.systems }
    }
}

impl TryFrom<Written> for Graph {
    type Error = &'static str;

    fn try_from(written: Written) -> Result<Self, Self::Error> {
        let mut graph = Self { systems: written.systems, ..Self::default() };
        let square = |system: &LinearSystem| system.matrix.len() == system.right.len() * system.right.len();
        if !graph.systems.iter().all(square) {
            return Err("a linear system that is not square");
        }
        for (number, node) in written.nodes.into_iter().enumerate() {
            if let Node::Solution { system, row } = node
                && graph.systems.get(system as usize).is_none_or(|system| row as usize >= system.right.len())
            {
                return Err("a solution of no linear system");
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
