//! Values that are integers by their form, such as counts; they are shown without decimals.

use crate::{Binary, Model, Node, NodeId, Unary};

impl Model {
    /// True for each node whose value is always an integer (if finite), as far as its form shows; one value per node.
    /// Integers are states that only events change, by integers, and values computed from them.
    pub fn whole_numbers(&self) -> Vec<bool> {
        let zero = |node| self.graph.as_constant(node) == Some(0.0);
        let mut states: Vec<bool> = self.states.iter().map(|state| zero(state.derivative)).collect();
        // A state that turns out not to be an integer can affect others: repeat until nothing changes.
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

    /// [`Model::whole_numbers`] under the assumption that the states marked in `states` are integers.
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
