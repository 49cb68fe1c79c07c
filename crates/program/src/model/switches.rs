//! Switches: discontinuities of the equations of motion or of their slope. They come from comparisons, `sign`, `floor`,
//! `ceil`, `round`, points of tables, and corners of `abs`, `min` and `max`.
//!
//! Integration methods assume smooth equations. Within a step every switch is therefore held at its value at the beginning,
//! and the step ends where the true value changes (Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I,
//! section II.6; Cellier & Kofman, Continuous System Simulation, chapter 9).

use super::continuity::is_continuous;
use crate::{Binary, Graph, Model, Node, NodeId, Unary, Variable, differentiate};
use std::collections::HashMap;

/// Maximum number of switches that are analysed, which takes a pass over all nodes per switch. Beyond it, every switch
/// counts as a jump.
const MOST_JUDGED: usize = 200;

/// A model with held switches.
#[derive(Clone, Debug)]
pub struct Held {
    /// The model with one further parameter per switch, after its own ones: the held value. Only the rates of change read
    /// them.
    pub model: Model,
    /// The switches, in the order of these parameters.
    pub switches: Vec<Switch>,
    /// Parameter node that holds each switch, by the node of the switch.
    values: HashMap<NodeId, NodeId>,
}

/// A value in the equations that changes only at isolated moments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Switch {
    /// True value, a node of [`Held::model`].
    pub node: NodeId,
    /// True if the rates jump; false if only their slope does.
    pub jumps: bool,
    /// True if the rates jump or their slope may be infinite.
    pub is_sharp: bool,
}

/// A switch, in the equations or in the condition of an event, that depends only on the independent variable, on
/// parameters, and on states that only events change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Timed {
    /// True value, a node of the graph returned with it.
    pub node: NodeId,
    /// Quantity that it compares with 0 or rounds.
    pub argument: NodeId,
    /// Derivative of the argument with respect to the independent variable.
    pub slope: NodeId,
    /// True if the argument is linear in the independent variable, so that the switch changes at most once between other
    /// changes.
    pub even: bool,
}

impl Model {
    /// The model with its switches held; `None` if it has none. Bends (jumps of a finite slope only) are held if `bends` is
    /// true.
    ///
    /// A corner multiplied by a factor that vanishes there, as in `v*abs(v)`, has a continuous slope and is no switch.
    /// Values that depend only on parameters and on states that only events change are no switches either.
    pub fn held(&self, bends: bool) -> Option<Held> {
        let mut found = self.find_switches();
        found.retain(|switch| switch.is_sharp || bends);
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

    /// The switches whose moments are known in advance, in a graph that extends that of the model.
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

    /// The switches of the rates, in the order of the graph. Rates of sensitivities are not searched: they jump already
    /// where the rates of their states bend. Where the slope of a rate may be infinite they have no value, so that a model with
    /// sensitivities is held there as at a jump.
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
        // A copy of the graph, made for the first sharp switch.
        let mut judged = None;
        let switch = |node: NodeId| {
            let motion = moving[&node];
            if motion == Motion::AtRest {
                return None;
            }
            if candidates.len() > MOST_JUDGED {
                return Some(Switch { node, jumps: true, is_sharp: true });
            }
            let order = smoothness(graph, &nodes, &rates, node)?;
            let is_sharp = order == 0;
            let jumps = is_sharp
                && (self.sensitive.is_some()
                    || !is_continuous(judged.get_or_insert_with(|| graph.clone()), &rates, node));
            (order < 2).then_some(Switch { node, jumps, is_sharp })
        };
        candidates.iter().copied().filter_map(switch).collect()
    }

    /// Cause of changes between events, by node.
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
    /// Nodes of `graph`, which extends that of [`Held::model`], with their switches held.
    pub(super) fn hold(&self, graph: &mut Graph, nodes: &[NodeId]) -> Vec<NodeId> {
        with_held(graph, nodes, &self.values)
    }
}

/// Nodes with their switches replaced by the held values.
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

/// Cause of changes of a value between events; a later variant includes the earlier ones.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Motion {
    AtRest,
    WithTime,
    WithState,
}

impl Node {
    /// True if the function itself has a jump of its value or of its slope.
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

/// True if only the slope jumps.
fn is_corner(node: Node) -> bool {
    matches!(node, Node::Unary(Unary::Absolute, _) | Node::Binary(Binary::Minimum | Binary::Maximum, ..))
}

/// Lowest order of derivative of the rates (`roots`) that is discontinuous where a switch changes: 0 for a jump, 1 for a
/// bend; `None` if no rate depends on it. Multiplication by a factor that vanishes there adds the order of its zero.
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

/// Maximum depth of the analysis of a factor, deeper than any product written by hand.
const DEEPEST_FACTOR: u32 = 8;

/// Lower bound of the order of the zero of `factor` at `x` = 0, as far as its form shows.
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

    /// Zeros of products, quotients and sums of x and y at x = 0.
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
