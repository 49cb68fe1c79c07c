//! Traversals of a graph. Operands have smaller indices than the node that uses them, so every pass is a loop over indices,
//! without recursion however deep an expression is.

use crate::{Graph, Node, NodeId};
use rustc_hash::{FxHashMap, FxHashSet};
use units::order::sort;

/// A set smaller than 1/32 of the nodes is searched without a pass over all nodes.
const SMALL_PART: usize = 32;

impl Graph {
    /// Calls `visit` with each operand of `id`; for a [`Node::Solution`] these are matrix entries and right-hand side of
    /// its system.
    pub fn for_each_operand(&self, id: NodeId, mut visit: impl FnMut(NodeId)) {
        match self.node(id) {
            Node::Constant(_) | Node::Parameter(_) | Node::Initial(_) | Node::Independent | Node::State(_) => {}
            Node::Unary(_, x) | Node::Piece(_, x) => visit(x),
            Node::Binary(_, a, b) | Node::Interpolated(_, a, b) => {
                visit(a);
                visit(b);
            }
            Node::Select(condition, chosen, other)
            | Node::Friction(condition, chosen, other)
            | Node::Binomial(condition, chosen, other) => {
                visit(condition);
                visit(chosen);
                visit(other);
            }
            Node::Solution { system, .. } => {
                self.systems()[system as usize].operands().for_each(visit);
            }
        }
    }

    /// The roots and all nodes they depend on, operands first.
    pub fn reachable(&self, roots: &[NodeId]) -> Vec<NodeId> {
        let Some(last) = roots.iter().max() else {
            return Vec::new();
        };
        // One of many equations usually depends on a small part of a large graph.
        if let Some(few) = self.reachable_few(roots, last.0 as usize / SMALL_PART) {
            return few;
        }
        let mut needed = vec![false; last.0 as usize + 1];
        for root in roots {
            needed[root.0 as usize] = true;
        }
        let mut systems = FxHashSet::default();
        for number in (0..needed.len()).rev() {
            if !needed[number] {
                continue;
            }
            let id = NodeId(number as u32);
            if let Node::Solution { system, .. } = self.node(id)
                && !systems.insert(system)
            {
                continue;
            }
            self.for_each_operand(id, |operand| needed[operand.0 as usize] = true);
        }
        (0..needed.len()).filter(|&number| needed[number]).map(|number| NodeId(number as u32)).collect()
    }

    /// [`Graph::reachable`] if there are at most about `most` nodes, otherwise `None`.
    fn reachable_few(&self, roots: &[NodeId], most: usize) -> Option<Vec<NodeId>> {
        if roots.len() > most {
            return None;
        }
        let mut found: FxHashSet<NodeId> = FxHashSet::default();
        let mut systems = FxHashSet::default();
        let mut waiting = roots.to_vec();
        while let Some(id) = waiting.pop() {
            if !found.insert(id) || matches!(self.node(id), Node::Solution { system, .. } if !systems.insert(system)) {
                continue;
            }
            self.for_each_operand(id, |operand| waiting.push(operand));
            if found.len() + waiting.len() > most {
                return None;
            }
        }
        let mut sorted: Vec<NodeId> = found.into_iter().collect();
        sort(&mut sorted);
        Some(sorted)
    }

    /// Rebuilds `roots` inside `target`. `replace` gives the new node of an input that changes; inputs are
    /// [`Node::Parameter`], [`Node::Initial`], [`Node::Independent`] and [`Node::State`].
    pub fn rebuild_into(
        &self,
        target: &mut Graph,
        roots: &[NodeId],
        mut replace: impl FnMut(&mut Graph, Node) -> Option<NodeId>,
    ) -> Vec<NodeId> {
        rebuild(Some(self), target, roots, |graph, _, node| replace(graph, node))
    }

    /// Rebuilds `roots` inside `target` with some nodes replaced by inputs, on which the result then depends.
    pub fn rebuild_from_inputs(&self, target: &mut Graph, roots: &[NodeId], inputs: &[(NodeId, Node)]) -> Vec<NodeId> {
        rebuild(Some(self), target, roots, |graph, id, _| {
            let input = inputs.iter().find(|(replaced, _)| *replaced == id);
            input.map(|&(_, input)| graph.insert(input))
        })
    }

    /// [`Graph::rebuild_into`] inside the graph itself.
    pub fn substitute(
        &mut self,
        roots: &[NodeId],
        mut replace: impl FnMut(&mut Graph, Node) -> Option<NodeId>,
    ) -> Vec<NodeId> {
        rebuild(None, self, roots, |graph, _, node| replace(graph, node))
    }

    /// Rebuilds `roots` inside the graph itself. `replace` receives each node, by its index and with operands already
    /// rebuilt, and returns its replacement, if any.
    pub fn rewrite(
        &mut self,
        roots: &[NodeId],
        replace: impl FnMut(&mut Graph, NodeId, Node) -> Option<NodeId>,
    ) -> Vec<NodeId> {
        rebuild(None, self, roots, replace)
    }
}

/// Rebuilds nodes of `source`, or of `target` itself if that is `None`.
fn rebuild(
    source: Option<&Graph>,
    target: &mut Graph,
    roots: &[NodeId],
    mut replace: impl FnMut(&mut Graph, NodeId, Node) -> Option<NodeId>,
) -> Vec<NodeId> {
    let mut rebuilt: FxHashMap<NodeId, NodeId> = FxHashMap::default();
    let mut systems: FxHashMap<u32, u32> = FxHashMap::default();
    for id in source.unwrap_or(target).reachable(roots) {
        let node = match source.unwrap_or(target).node(id) {
            input
            @ (Node::Constant(_) | Node::Parameter(_) | Node::Initial(_) | Node::Independent | Node::State(_)) => input,
            Node::Unary(function, x) => Node::Unary(function, rebuilt[&x]),
            Node::Binary(function, a, b) => Node::Binary(function, rebuilt[&a], rebuilt[&b]),
            Node::Select(condition, chosen, other) => {
                Node::Select(rebuilt[&condition], rebuilt[&chosen], rebuilt[&other])
            }
            Node::Friction(speed, adhesion, sliding) => {
                Node::Friction(rebuilt[&speed], rebuilt[&adhesion], rebuilt[&sliding])
            }
            Node::Piece(interpolation, x) => Node::Piece(carried(source, target, interpolation), rebuilt[&x]),
            Node::Interpolated(interpolation, x, piece) => {
                Node::Interpolated(carried(source, target, interpolation), rebuilt[&x], rebuilt[&piece])
            }
            Node::Binomial(trials, probability, stream) => {
                Node::Binomial(rebuilt[&trials], rebuilt[&probability], rebuilt[&stream])
            }
            Node::Solution { system, row } => {
                let system = *systems.entry(system).or_insert_with(|| {
                    let system = &source.unwrap_or(target).systems()[system as usize];
                    let system = system.map(|operand| rebuilt[&operand]);
                    target.insert_system(system)
                });
                Node::Solution { system, row }
            }
        };
        let new = replace(target, id, node).unwrap_or_else(|| match node {
            Node::Unary(function, x) => target.unary(function, x),
            Node::Binary(function, a, b) => target.binary(function, a, b),
            Node::Select(condition, chosen, other) => target.select(condition, chosen, other),
            Node::Piece(interpolation, x) => target.piece(interpolation, x),
            Node::Interpolated(interpolation, x, piece) => target.interpolated(interpolation, x, piece),
            input => target.insert(input),
        });
        rebuilt.insert(id, new);
    }
    roots.iter().map(|root| rebuilt[root]).collect()
}

/// Index in `target` of an interpolation of `source`, or of `target` itself.
fn carried(source: Option<&Graph>, target: &mut Graph, interpolation: u32) -> u32 {
    match source {
        Some(source) => target.insert_interpolation(&source.interpolations()[interpolation as usize]),
        None => interpolation,
    }
}
