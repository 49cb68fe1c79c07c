//! Terms of accelerations: what each of them contributes, and on what it depends.

use super::study::{Motion, Study};
use program::{Binary, LinearSystem, Node, NodeId, Unary};

/// Behaviour of a term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class {
    /// Depends on positions only: a force with a potential, or a constant one.
    Position,
    /// Depends on velocities and keeps its value if all are reversed, such as a centrifugal force.
    Even,
    /// Changes its sign if all velocities are reversed: friction, or a magnetic force.
    Odd,
    /// Depends on the independent variable, or on a state that is not part of the motion.
    Driven,
    /// Depends on velocities in another way.
    Other,
}

/// A term of an acceleration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    /// A summand of an acceleration or, if equations are coupled, of their right-hand sides.
    pub node: NodeId,
    pub class: Class,
}

/// Maximum number of terms of one acceleration.
const MOST: usize = 24;

impl Study<'_> {
    /// Terms of the accelerations of some motions, with the accelerations that each contributes, one per motion (`None`
    /// for 0).
    pub fn terms(&mut self, motions: &[Motion]) -> Vec<(Term, Vec<Option<NodeId>>)> {
        let mut terms = Vec::new();
        let mut systems = Vec::new();
        for (row, motion) in motions.iter().enumerate() {
            if let Node::Solution { system, .. } = self.model.graph.node(motion.acceleration) {
                if !systems.contains(&system) {
                    systems.push(system);
                    self.terms_of_system(system, motions, &mut terms);
                }
                continue;
            }
            for node in self.split(motion.acceleration) {
                let mut contributions = vec![None; motions.len()];
                contributions[row] = Some(node);
                terms.push((Term { node, class: self.class(node) }, contributions));
            }
        }
        terms
    }

    /// Terms of the right-hand sides of a linear system: its solution is linear in them.
    fn terms_of_system(&mut self, system: u32, motions: &[Motion], terms: &mut Vec<(Term, Vec<Option<NodeId>>)>) {
        let whole = self.model.graph.systems()[system as usize].clone();
        let zero = self.model.graph.constant(0.0);
        for (row, &right) in whole.right.iter().enumerate() {
            for node in self.split(right) {
                let mut alone = vec![zero; whole.right.len()];
                alone[row] = node;
                let alone = LinearSystem { entries: whole.entries.clone(), right: alone };
                let alone = self.model.graph.insert_system(alone);
                let contributions = motions.iter().map(|motion| match self.model.graph.node(motion.acceleration) {
                    Node::Solution { system: own, row } if own == system => {
                        Some(self.model.graph.insert(Node::Solution { system: alone, row }))
                    }
                    _ => None,
                });
                let contributions = contributions.collect();
                terms.push((Term { node, class: self.class(node) }, contributions));
            }
        }
    }

    /// Nodes whose sum is the node.
    pub fn split(&mut self, node: NodeId) -> Vec<NodeId> {
        let parts = self.parts(node);
        if parts.len() > MOST { vec![node] } else { parts }
    }

    fn parts(&mut self, node: NodeId) -> Vec<NodeId> {
        match self.model.graph.node(node) {
            Node::Binary(Binary::Add, a, b) => [self.parts(a), self.parts(b)].concat(),
            Node::Binary(Binary::Subtract, a, b) => {
                let subtracted = self.parts(b);
                let negated: Vec<NodeId> = subtracted.into_iter().map(|part| self.model.graph.negate(part)).collect();
                [self.parts(a), negated].concat()
            }
            Node::Unary(Unary::Negate, a) => {
                let parts = self.parts(a);
                parts.into_iter().map(|part| self.model.graph.negate(part)).collect()
            }
            Node::Binary(Binary::Divide, a, b) => {
                let parts = self.parts(a);
                parts.into_iter().map(|part| self.model.graph.divide(part, b)).collect()
            }
            Node::Binary(Binary::Multiply, a, b) => {
                let (factor, sum) = if self.is_factor(a) { (a, b) } else { (b, a) };
                if !self.is_factor(factor) {
                    return vec![node];
                }
                let parts = self.parts(sum);
                parts.into_iter().map(|part| self.model.graph.multiply(factor, part)).collect()
            }
            Node::Select(condition, chosen, other) => {
                let (chosen, other) = (self.parts(chosen), self.parts(other));
                let graph = &mut self.model.graph;
                let zero = graph.constant(0.0);
                let chosen = chosen.into_iter().map(|part| graph.select(condition, part, zero)).collect::<Vec<_>>();
                let other = other.into_iter().map(|part| graph.select(condition, zero, part)).collect::<Vec<_>>();
                [chosen, other].concat()
            }
            Node::Constant(bits) if f64::from_bits(bits) == 0.0 => Vec::new(),
            _ => vec![node],
        }
    }

    /// Dividend and divisor of a term, such as force and mass of a part of an acceleration.
    pub fn divided(&mut self, term: NodeId) -> Option<[NodeId; 2]> {
        match self.model.graph.node(term) {
            Node::Binary(Binary::Divide, dividend, divisor) => Some([dividend, divisor]),
            Node::Unary(Unary::Negate, term) => {
                let [dividend, divisor] = self.divided(term)?;
                Some([self.model.graph.negate(dividend), divisor])
            }
            Node::Binary(Binary::Multiply, a, b) => {
                let (factor, [dividend, divisor]) = match self.divided(b) {
                    Some(divided) => (a, divided),
                    None => (b, self.divided(a)?),
                };
                Some([self.model.graph.multiply(factor, dividend), divisor])
            }
            _ => None,
        }
    }

    /// True if a node depends on no position, no velocity and no time.
    fn is_factor(&self, node: NodeId) -> bool {
        let depends = self.model.depends(node);
        !depends.independent && depends.states.iter().all(|&state| self.is_discrete(state))
    }

    fn class(&mut self, node: NodeId) -> Class {
        let depends = self.model.depends(node);
        let velocity = |state: &u32| self.motions.iter().any(|motion| motion.velocity == *state);
        let position = |state: &u32| self.motions.iter().any(|motion| motion.position == *state);
        let foreign = |state: &u32| !velocity(state) && !position(state) && !self.is_discrete(*state);
        if depends.independent || depends.states.iter().any(foreign) {
            return Class::Driven;
        }
        if !depends.states.iter().any(velocity) {
            return Class::Position;
        }
        let reversed = self.reversed(&[node]);
        let values = self.values(&[node, reversed[0]]);
        let alike = |sign: f64| {
            let scale = values[0].iter().map(|value| value.abs()).fold(0.0, f64::max);
            values[0].iter().zip(&values[1]).all(|(value, other)| (value - sign * other).abs() <= 1e-9 * scale)
        };
        if alike(-1.0) {
            Class::Odd
        } else if alike(1.0) {
            Class::Even
        } else {
            Class::Other
        }
    }
}
