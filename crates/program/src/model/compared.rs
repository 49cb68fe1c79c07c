//! What the conditions of a model compare: numbers whose zeros are the only moments at which a condition can change.

use super::switches::{Held, Motion};
use crate::{Model, Node, NodeId, Unary};
use std::collections::HashSet;

/// The numbers that the conditions of events and the jumps of the equations compare, as far as they move with the states.
/// Between two neighbouring zeros of all of them no condition changes.
#[derive(Clone, Debug)]
pub struct Compared {
    /// The model, whose graph has the nodes of these numbers besides its own.
    pub model: Model,
    /// The numbers.
    pub values: Vec<NodeId>,
    /// How fast each changes along the motion.
    pub rates: Vec<NodeId>,
    /// The first event whose condition compares each; none where an equation does.
    pub events: Vec<Option<usize>>,
}

impl Model {
    /// What is compared; `None` where nothing is. What depends on the independent variable alone is scheduled
    /// ([`Model::timed_switches`]) and not among them. The switches of the equations have the values at which they are `held`
    /// during a step, in these numbers and in their rates: at the end of a step the true ones are already those of the next.
    pub fn compared(&self, held: Option<&Held>) -> Option<Compared> {
        let conditions = self.events.iter().enumerate().map(|(number, event)| (Some(number), event.condition));
        let switches = self.find_switches().into_iter().filter(|switch| switch.jumps);
        let roots: Vec<_> = conditions.chain(switches.map(|switch| (None, switch.node))).collect();
        let nodes: Vec<NodeId> = roots.iter().map(|(_, node)| *node).collect();
        let moving = self.moving(&self.graph.reachable(&nodes));
        let moved = held.map_or(self, |held| &held.model);
        let mut compared = Compared { model: moved.clone(), values: Vec::new(), rates: Vec::new(), events: Vec::new() };
        let mut seen = HashSet::new();
        for (event, root) in roots {
            for node in self.graph.reachable(&[root]) {
                if self.graph.node(node).is_switch() && moving[&node] == Motion::WithState {
                    compared.add(node, event, &mut seen);
                }
            }
        }
        if let Some(held) = held {
            compared.values = held.hold(&mut compared.model.graph, &compared.values);
        }
        compared.rates = compared.model.rates_of(&compared.values);
        (!compared.values.is_empty()).then_some(compared)
    }
}

impl Compared {
    /// Adds the number whose zeros are the changes of a switch.
    fn add(&mut self, switch: NodeId, event: Option<usize>, seen: &mut HashSet<(NodeId, NodeId)>) {
        let graph = &mut self.model.graph;
        let zero = graph.constant(0.0);
        let (a, b) = match graph.node(switch) {
            Node::Unary(function @ (Unary::Floor | Unary::Ceil | Unary::Round), x) => {
                let pi = graph.constant(std::f64::consts::PI);
                let angle = graph.multiply(pi, x);
                // Zero at the whole numbers, or half-way between.
                let function = if function == Unary::Round { Unary::Cos } else { Unary::Sin };
                (graph.unary(function, angle), zero)
            }
            Node::Piece(interpolation, x) => (graph.passing_points(interpolation, x), zero),
            Node::Unary(_, x) => (x, zero),
            Node::Binary(_, a, b) => (a, b),
            _ => return,
        };
        if seen.insert((a.min(b), a.max(b))) {
            self.values.push(graph.subtract(a, b));
            self.events.push(event);
        }
    }
}
