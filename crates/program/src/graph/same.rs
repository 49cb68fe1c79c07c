//! Comparison of expressions of two graphs.

use crate::{Binary, Graph, Node, NodeId};
use std::collections::HashMap;

impl Graph {
    /// True if `nodes` are the same expressions as `others` of another graph; their values then have the same bits.
    /// `rename` maps an input of this graph (a [`Node::Parameter`], [`Node::Initial`], [`Node::Independent`] or
    /// [`Node::State`]) to that of the other one; `None` if it has none.
    pub fn same(
        &self,
        nodes: &[NodeId],
        other: &Graph,
        others: &[NodeId],
        rename: impl Fn(Node) -> Option<Node>,
    ) -> bool {
        if nodes.len() != others.len() {
            return false;
        }
        // Equal expressions are one node, so each node has at most one counterpart.
        let mut found: HashMap<NodeId, NodeId> = HashMap::new();
        for id in self.reachable(nodes) {
            let Some(counterpart) = self.counterpart(id, other, &found, &rename) else { return false };
            found.insert(id, counterpart);
        }
        nodes.iter().zip(others).all(|(node, other)| found.get(node) == Some(other))
    }

    /// Index of an interpolation in another graph.
    fn interpolation_in(&self, interpolation: u32, other: &Graph) -> Option<u32> {
        let found = other.find_interpolation(self.interpolations().get(interpolation as usize)?)?;
        Some(found as u32)
    }

    fn counterpart(
        &self,
        id: NodeId,
        other: &Graph,
        found: &HashMap<NodeId, NodeId>,
        rename: &impl Fn(Node) -> Option<Node>,
    ) -> Option<NodeId> {
        let there = |id: NodeId| found.get(&id).copied();
        match self.node(id) {
            node @ Node::Constant(_) => other.find(node),
            input @ (Node::Parameter(_) | Node::Initial(_) | Node::Independent | Node::State(_)) => {
                other.find(rename(input)?)
            }
            Node::Unary(function, x) => other.find(Node::Unary(function, there(x)?)),
            Node::Binary(function, a, b) => {
                let (a, b) = (there(a)?, there(b)?);
                // A graph orders the operands of these functions by index.
                let commutes = matches!(
                    function,
                    Binary::Add | Binary::Multiply | Binary::Equal | Binary::NotEqual | Binary::And | Binary::Or
                );
                let swapped = || if commutes { other.find(Node::Binary(function, b, a)) } else { None };
                other.find(Node::Binary(function, a, b)).or_else(swapped)
            }
            Node::Select(condition, chosen, rest) => {
                other.find(Node::Select(there(condition)?, there(chosen)?, there(rest)?))
            }
            Node::Binomial(trials, probability, stream) => {
                other.find(Node::Binomial(there(trials)?, there(probability)?, there(stream)?))
            }
            Node::Friction(..) => None,
            Node::Piece(interpolation, x) => {
                let interpolation = self.interpolation_in(interpolation, other)?;
                other.find(Node::Piece(interpolation, there(x)?))
            }
            Node::Interpolated(interpolation, x, piece) => {
                let interpolation = self.interpolation_in(interpolation, other)?;
                other.find(Node::Interpolated(interpolation, there(x)?, there(piece)?))
            }
            Node::Solution { system, row } => {
                let wanted = self.systems().get(system as usize)?.try_map(there)?;
                let system = other.systems().iter().position(|system| *system == wanted)?;
                other.find(Node::Solution { system: system as u32, row })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `(p_0 + x)/p_1` in a graph that has the nodes `before` first.
    fn graph(before: &[Node], [p, q]: [u32; 2]) -> (Graph, NodeId) {
        let mut graph = Graph::default();
        before.iter().for_each(|&node| _ = graph.insert(node));
        let [p, x, q] = [Node::Parameter(p), Node::State(0), Node::Parameter(q)].map(|node| graph.insert(node));
        let sum = graph.add(p, x);
        let quotient = graph.divide(sum, q);
        (graph, quotient)
    }

    #[test]
    fn expressions_are_the_same_whatever_stands_before_them() {
        let (one, root) = graph(&[], [0, 1]);
        // Here x has a smaller index than p and is the first summand.
        let (other, same) = graph(&[Node::State(0), Node::Independent], [0, 1]);
        assert_ne!(root, same);
        assert!(one.same(&[root], &other, &[same], Some) && other.same(&[same], &one, &[root], Some));
        assert!(!one.same(&[root], &other, &[NodeId(0)], Some) && !one.same(&[root], &other, &[], Some));
        // The quotient differs from its reciprocal, unless the parameters are exchanged.
        let (other, swapped) = graph(&[], [1, 0]);
        assert!(!one.same(&[root], &other, &[swapped], Some));
        let swap = |node| match node {
            Node::Parameter(index) => Some(Node::Parameter(1 - index)),
            other => Some(other),
        };
        assert!(one.same(&[root], &other, &[swapped], swap));
        assert!(!one.same(&[root], &other, &[swapped], |node| Some(node).filter(|node| *node != Node::Parameter(1))));
    }
}
