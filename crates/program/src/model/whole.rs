//! Which values are whole numbers by their form: counts, which people write without decimals.

use crate::{Binary, Model, Node, NodeId, Unary};

impl Model {
    /// For each node of the graph whether its value is always a whole number (if it is finite), as far as its form
    /// tells: that of a state which only events change, by whole numbers, and of what is computed from such ones.
    pub fn whole_numbers(&self) -> Vec<bool> {
        let zero = |node| self.graph.as_constant(node) == Some(0.0);
        let mut states: Vec<bool> = self.states.iter().map(|state| zero(state.derivative)).collect();
        // Whoever is found not to be whole may be what another was taken to be whole for.
        loop {
            let whole = self.whole_with(&states);
            let is_whole = |node: NodeId| whole[node.0 as usize];
            let mut kept = states.clone();
            for (kept, state) in kept.iter_mut().zip(&self.states) {
                *kept &= is_whole(state.initial);
            }
            for (state, value) in self.events.iter().flat_map(|event| &event.actions) {
                kept[*state as usize] &= is_whole(*value);
            }
            if kept == states {
                return whole;
            }
            states = kept;
        }
    }

    /// The same if the states are whole that are said to be.
    fn whole_with(&self, states: &[bool]) -> Vec<bool> {
        let mut whole: Vec<bool> = Vec::with_capacity(self.graph.len());
        for number in 0..self.graph.len() {
            let of = |node: NodeId| whole[node.0 as usize];
            whole.push(match self.graph.node(NodeId(number as u32)) {
                Node::Constant(bits) => libm::trunc(f64::from_bits(bits)) == f64::from_bits(bits),
                Node::Initial(state) | Node::State(state) => states[state as usize],
                Node::Parameter(_) | Node::Independent | Node::Friction(..) | Node::Solution { .. } => false,
                Node::Unary(Unary::Floor | Unary::Ceil | Unary::Round | Unary::Sign | Unary::Not, _) => true,
                Node::Piece(..) => true,
                Node::Interpolated(..) => false,
                Node::Binomial(..) => true,
                Node::Unary(Unary::Negate | Unary::Absolute, x) => of(x),
                Node::Unary(..) => false,
                Node::Binary(function, a, b) => match function {
                    Binary::Less | Binary::LessOrEqual | Binary::Equal | Binary::NotEqual => true,
                    Binary::And | Binary::Or | Binary::Poisson => true,
                    Binary::Divide | Binary::Power | Binary::Atan2 => false,
                    _ => of(a) && of(b),
                },
                Node::Select(_, chosen, other) => of(chosen) && of(other),
            });
        }
        whole
    }
}
