//! Where the equations of motion jump or bend: comparisons, `sign`, `floor`, `ceil`, `round`, the points of tables, and the
//! corners of `abs`, `min` and `max`.
//!
//! A method of integration takes its equations to be smooth. So within a step every switch is held at the value that it had
//! at the beginning, which makes them smooth, and the step ends where the true value changes (Hairer, Norsett & Wanner,
//! Solving Ordinary Differential Equations I, section II.6; Cellier & Kofman, Continuous System Simulation, chapter 9).

use crate::{Binary, Graph, Model, Node, NodeId, Unary, Variable, differentiate};
use std::collections::HashMap;

/// Beyond so many switches each is taken for a jump: to see what each does to the rates takes a pass over all of them.
const MOST_JUDGED: usize = 200;

/// A model whose switches are held.
#[derive(Clone, Debug)]
pub struct Held {
    /// The model, with one more parameter behind its own for each switch: the value at which it is held. Only the rates of
    /// change read them.
    pub model: Model,
    /// What is held, in the order of these parameters.
    pub switches: Vec<Switch>,
    /// By node of the model that switches, the parameter that holds it.
    values: HashMap<NodeId, NodeId>,
}

/// A value in the equations that changes at isolated moments only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Switch {
    /// Its true value, a node of [`Held::model`].
    pub node: NodeId,
    /// Whether rates of change jump with it; else they bend.
    pub jumps: bool,
}

/// A switch, in the equations or in the condition of an event, that depends on the independent variable alone, besides
/// parameters and what only events change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Timed {
    /// Its true value, a node of the graph that comes with it.
    pub node: NodeId,
    /// What it compares with 0 or rounds.
    pub argument: NodeId,
    /// How fast that changes.
    pub slope: NodeId,
    /// Whether it changes at most once between changes of the others, because its argument grows evenly.
    pub even: bool,
}

impl Model {
    /// The model with its switches held; `None` where nothing switches. Bends are held if `bends` says so.
    ///
    /// A corner beside a factor that vanishes there, as in `v*abs(v)`, has a continuous slope and is no switch; neither is what
    /// depends only on parameters and on states that events alone change.
    pub fn held(&self, bends: bool) -> Option<Held> {
        let mut found = self.find_switches();
        found.retain(|switch| switch.jumps || bends);
        if found.is_empty() {
            return None;
        }
        let mut model = self.clone();
        let mut switches = Vec::with_capacity(found.len());
        let mut held = HashMap::new();
        for switch in found {
            let graph = &mut model.graph;
            let zero = graph.constant(0.0);
            let node = match graph.node(switch.node) {
                Node::Unary(Unary::Absolute, x) => graph.binary(Binary::Less, x, zero),
                Node::Binary(Binary::Minimum, a, b) => graph.binary(Binary::Less, a, b),
                Node::Binary(Binary::Maximum, a, b) => graph.binary(Binary::Less, b, a),
                _ => switch.node,
            };
            let value = graph.insert(Node::Parameter((self.parameters.len() + switches.len()) as u32));
            held.insert(switch.node, value);
            switches.push(Switch { node, ..switch });
        }
        let rates: Vec<NodeId> = model.states.iter().map(|state| state.derivative).collect();
        let rates = with_held(&mut model.graph, &rates, &held);
        for (state, rate) in model.states.iter_mut().zip(rates) {
            state.derivative = rate;
        }
        Some(Held { model, switches, values: held })
    }

    /// The switches whose moments can be known beforehand, in a graph that extends the model's.
    pub fn timed_switches(&self) -> (Graph, Vec<Timed>) {
        let rates = self.states.iter().map(|state| state.derivative);
        let roots: Vec<NodeId> = rates.chain(self.events.iter().map(|event| event.condition)).collect();
        let nodes = self.graph.reachable(&roots);
        let steps = |id: &NodeId| self.graph.node(*id).is_switch() && !is_corner(self.graph.node(*id));
        if !nodes.iter().any(steps) {
            return (Graph::default(), Vec::new());
        }
        let moving = self.moving(&nodes);
        let mut graph = self.graph.clone();
        let mut found = Vec::new();
        for node in nodes.into_iter().filter(|node| steps(node) && moving[node] == Motion::WithTime) {
            let argument = match graph.node(node) {
                Node::Unary(_, x) | Node::Piece(_, x) => x,
                Node::Binary(_, a, b) => graph.subtract(a, b),
                _ => node,
            };
            let slope = differentiate(&mut graph, argument, Variable::Independent);
            let even = graph.reachable(&[slope]).into_iter().all(|id| graph.node(id) != Node::Independent);
            found.push(Timed { node, argument, slope, even });
        }
        (graph, found)
    }

    /// What switches in the rates of change, in the order of the graph; `node` is that of this model. Of sensitivities the
    /// rates jump already where those of their states bend; these are none.
    pub(super) fn find_switches(&self) -> Vec<Switch> {
        let graph = &self.graph;
        let own = self.sensitive.as_ref().map_or(self.states.len(), |sensitive| sensitive.states);
        let rates: Vec<NodeId> = self.states.iter().take(own).map(|state| state.derivative).collect();
        let nodes = graph.reachable(&rates);
        let candidates: Vec<NodeId> = nodes.iter().copied().filter(|&id| graph.node(id).is_switch()).collect();
        if candidates.is_empty() {
            return Vec::new();
        }
        let moving = self.moving(&nodes);
        let switch = |node: NodeId| {
            let motion = moving[&node];
            if motion == Motion::AtRest {
                return None;
            }
            let order = if candidates.len() > MOST_JUDGED { 0 } else { smoothness(graph, &nodes, &rates, node)? };
            (order < 2).then_some(Switch { node, jumps: order == 0 })
        };
        candidates.iter().copied().filter_map(switch).collect()
    }

    /// By node, what makes its value change between events.
    pub(super) fn moving(&self, nodes: &[NodeId]) -> HashMap<NodeId, Motion> {
        let mut found: HashMap<NodeId, Motion> = HashMap::new();
        for &id in nodes {
            let motion = match self.graph.node(id) {
                Node::Constant(_) | Node::Parameter(_) | Node::Initial(_) => Motion::AtRest,
                Node::Independent => Motion::WithTime,
                Node::State(state) => {
                    let rests = |state: &crate::State| self.graph.as_constant(state.derivative) == Some(0.0);
                    let rests = self.states.get(state as usize).is_some_and(rests);
                    if rests { Motion::AtRest } else { Motion::WithState }
                }
                _ => {
                    let mut greatest = Motion::AtRest;
                    self.graph.for_each_operand(id, |operand| greatest = greatest.max(found[&operand]));
                    greatest
                }
            };
            found.insert(id, motion);
        }
        found
    }
}

impl Held {
    /// Nodes of `graph`, which extends that of [`Held::model`], with the switches in them held.
    pub(super) fn hold(&self, graph: &mut Graph, nodes: &[NodeId]) -> Vec<NodeId> {
        with_held(graph, nodes, &self.values)
    }
}

/// Nodes with the switches in them replaced by what holds these.
fn with_held(graph: &mut Graph, nodes: &[NodeId], held: &HashMap<NodeId, NodeId>) -> Vec<NodeId> {
    graph.rewrite(nodes, |graph, id, node| {
        let value = *held.get(&id)?;
        Some(match node {
            Node::Unary(Unary::Absolute, x) => {
                let negative = graph.negate(x);
                graph.select(value, negative, x)
            }
            Node::Binary(Binary::Minimum | Binary::Maximum, a, b) => graph.select(value, a, b),
            _ => value,
        })
    })
}

/// Why a value changes between events; the later include the earlier.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Motion {
    AtRest,
    WithTime,
    WithState,
}

impl Node {
    /// Whether the value or the slope jumps somewhere, and not only that of what it is computed from.
    pub fn is_switch(self) -> bool {
        let steps = match self {
            Self::Unary(function, _) => matches!(function, Unary::Sign | Unary::Floor | Unary::Ceil | Unary::Round),
            Self::Binary(function, ..) => {
                matches!(function, Binary::Less | Binary::LessOrEqual | Binary::Equal | Binary::NotEqual)
            }
            Self::Piece(..) => true,
            _ => false,
        };
        steps || is_corner(self)
    }
}

/// Whether it is the slope that jumps and not the value.
fn is_corner(node: Node) -> bool {
    matches!(node, Node::Unary(Unary::Absolute, _) | Node::Binary(Binary::Minimum | Binary::Maximum, ..))
}

/// How often the rates of change, `roots`, can be differentiated where a switch changes: 0 for a jump, 1 for a bend. What is
/// multiplied by a factor that vanishes there gains the order of its zero.
fn smoothness(graph: &Graph, nodes: &[NodeId], roots: &[NodeId], switch: NodeId) -> Option<u32> {
    let (of_itself, zero) = match graph.node(switch) {
        Node::Unary(Unary::Absolute, x) => (1, Some(x)),
        Node::Unary(Unary::Sign, x) => (0, Some(x)),
        Node::Binary(Binary::Minimum | Binary::Maximum, ..) => (1, None),
        _ => (0, None),
    };
    let mut found = HashMap::from([(switch, of_itself)]);
    for &reader in nodes.iter().filter(|&&reader| reader > switch) {
        let mut least: Option<u32> = None;
        graph.for_each_operand(reader, |operand| {
            let Some(&order) = found.get(&operand) else { return };
            let factor = match (graph.node(reader), zero) {
                (Node::Binary(Binary::Multiply, a, b), Some(zero)) => {
                    zero_order(graph, if a == operand { b } else { a }, zero, DEEPEST_FACTOR)
                }
                (Node::Interpolated(interpolation, _, piece), _) if piece == operand => {
                    graph.interpolations()[interpolation as usize].smoothness()
                }
                _ => 0,
            };
            least = Some(least.map_or(order + factor, |least| least.min(order + factor)));
        });
        if let Some(order) = least {
            found.insert(reader, order);
        }
    }
    roots.iter().filter_map(|root| found.get(root)).min().copied()
}

/// How deep a factor is looked into for what makes it zero: deeper than any product that a person writes.
const DEEPEST_FACTOR: u32 = 8;

/// The order of the zero that `factor` is known to have where `x` is 0.
fn zero_order(graph: &Graph, factor: NodeId, x: NodeId, depth: u32) -> u32 {
    if let Node::Unary(Unary::Negate, opposite) = graph.node(x) {
        return zero_order(graph, factor, opposite, depth);
    }
    if factor == x {
        return 1;
    }
    if depth == 0 {
        return 0;
    }
    let of = |node| zero_order(graph, node, x, depth - 1);
    match graph.node(factor) {
        Node::Unary(Unary::Negate | Unary::Absolute, inner) => of(inner),
        Node::Binary(Binary::Multiply, a, b) => of(a) + of(b),
        Node::Binary(Binary::Divide, a, b) if of(b) == 0 => of(a),
        Node::Binary(Binary::Add | Binary::Subtract, a, b) => of(a).min(of(b)),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The zeros of products, quotients and sums of x and y where x is 0.
    #[test]
    fn the_order_of_a_zero() {
        let mut graph = Graph::default();
        let (x, y) = (graph.insert(Node::State(0)), graph.insert(Node::State(1)));
        let square = graph.multiply(x, x);
        let product = graph.multiply(x, y);
        let quotient = graph.divide(square, y);
        let inverse = graph.divide(y, x);
        let sum = graph.add(square, product);
        let shifted = graph.add(x, y);
        for (node, expected) in
            [(x, 1), (y, 0), (square, 2), (product, 1), (quotient, 2), (inverse, 0), (sum, 1), (shifted, 0)]
        {
            assert_eq!(zero_order(&graph, node, x, DEEPEST_FACTOR), expected, "{:?}", graph.node(node));
        }
    }
}
