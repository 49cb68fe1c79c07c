//! Values compared in the conditions of a model: their zeros are the only moments at which a condition can change.

use super::switches::{Held, Motion};
use crate::{Model, Node, NodeId, Unary};
use std::collections::HashSet;

/// Values compared in the conditions of events and in the jumps of the equations, as far as they change with the states. No
/// condition changes between two neighbouring zeros of all of them.
#[derive(Clone, Debug)]
pub struct Compared {
    /// The model; its graph is extended by the nodes of these values.
    pub model: Model,
    /// The compared values: differences of both sides.
    pub values: Vec<NodeId>,
    /// Rates of change of the values along the solution, one per value.
    pub rates: Vec<NodeId>,
    /// Index of the first event whose condition uses each value; `None` for the equations.
    pub events: Vec<Option<usize>>,
}

impl Model {
    /// The compared values; `None` if there are none. Values that depend on the independent variable alone are scheduled
    /// ([`Model::timed_switches`]) and not included. Switches of the equations have their `held` values here and in the
    /// rates, because at the end of a step the true ones belong to the next step already.
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
    /// Adds the value whose zeros are the changes of a switch.
    fn add(&mut self, switch: NodeId, event: Option<usize>, seen: &mut HashSet<(NodeId, NodeId)>) {
        let graph = &mut self.model.graph;
        let zero = graph.constant(0.0);
        let (a, b) = match graph.node(switch) {
            Node::Unary(function @ (Unary::Floor | Unary::Ceil | Unary::Round), x) => {
                let pi = graph.constant(std::f64::consts::PI);
                let angle = graph.multiply(pi, x);
                // Zero at the integers, or half-way between for `round`.
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
