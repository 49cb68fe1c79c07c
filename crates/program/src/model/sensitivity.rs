//! Sensitivity equations: a model extended by the sensitivities of its states to parameters.
//!
//! With the rates f(t, x, p), the sensitivity s = dx/dp obeys s' = f_x s + f_p, and s(0) is the derivative of the initial
//! value. At an event, s jumps because the moment tau depends on p. Let g(t, x, p) pass through zero and x become h(t, x,
//! p); then
//!
//! tau' = -(g_x s + g_p) / (g_x f + g_t),   s+ = h_x (s + f tau') + h_t tau' + h_p - f+ tau'
//!
//! where tau' = d tau/dp and f+ are the rates after the jump (Rozenvasser, Automation and Remote Control 28 (1967) 52;
//! Hiskens & Pai, IEEE Trans. Circuits Syst. I 47 (2000) 204).
//!
//! Several events can fire at one moment, each with its own tau'. They act one after the other, in the order of the
//! document, each on the state x and the sensitivity s left by the previous ones.

use super::MOST_NODES;
use crate::graph::along;
use crate::{Binary, Dependence, Graph, Jump, Model, Node, NodeId, Role, Sensitive, State, Unary};
use units::Unit;

impl Model {
    /// The model with sensitivities as further states: after its own states, the sensitivities of all of them to the first
    /// of `parameters` (indices in [`Model::parameters`]), then to the second, and so on. Nodes of the model keep their
    /// indices. `None` if there would be too many nodes.
    pub fn with_sensitivities(&self, parameters: &[usize]) -> Option<Model> {
        let mut extended = self.clone();
        for event in &mut extended.events {
            event.jump = Some(Jump { delays: Vec::new(), sensitivities: Vec::new() });
        }
        let sensitive = Sensitive { states: self.states.len(), parameters: parameters.len(), delays: Vec::new() };
        extended.sensitive = Some(sensitive.clone());
        let jumps = extended.find_switches().into_iter().filter(|switch| switch.jumps);
        let delays = jumps.map(|switch| (switch.node, Vec::new())).collect();
        extended.sensitive = Some(Sensitive { delays, ..sensitive });
        let inputs = self.inputs();
        for (position, &parameter) in parameters.iter().enumerate() {
            let moved = self.moved_by(parameter as u32, &inputs);
            self.add_sensitivity(&mut extended, parameter as u32, (position, parameters.len()), &moved);
            if extended.graph.len() > MOST_NODES {
                return None;
            }
        }
        Some(extended)
    }

    /// Total derivatives of `nodes` with respect to a parameter, one per node, through the states as well. `position` is
    /// the index of the parameter among those given to [`Model::with_sensitivities`], which must have made this model;
    /// `states` is the number of states of the original model.
    pub fn sensitivities(&mut self, nodes: &[NodeId], parameter: usize, position: usize, states: usize) -> Vec<NodeId> {
        let initial: Vec<NodeId> = self.states[..states].iter().map(|state| state.initial).collect();
        total(&mut self.graph, nodes, parameter as u32, states * (position + 1), &initial)
    }

    /// Rates of change of `nodes` with the independent variable along the solution, one per node.
    pub fn rates_of(&mut self, nodes: &[NodeId]) -> Vec<NodeId> {
        let rates: Vec<NodeId> = self.states.iter().map(|state| state.derivative).collect();
        moving(&mut self.graph, nodes, &rates)
    }

    /// Dependences of the initial value and of the rate of each state.
    fn inputs(&self) -> Vec<[Dependence; 2]> {
        self.states.iter().map(|state| [state.initial, state.derivative].map(|node| self.depends(node))).collect()
    }

    /// One per state: false if a parameter has no effect on it, directly or over other states. `inputs` as [`Model::inputs`].
    fn moved_by(&self, parameter: u32, inputs: &[[Dependence; 2]]) -> Vec<bool> {
        // The moment of an event can have an effect on any state.
        let mut moved = vec![!self.events.is_empty(); inputs.len()];
        let mut grows = true;
        while std::mem::take(&mut grows) {
            for (state, of) in inputs.iter().enumerate() {
                let reads = |of: &Dependence| {
                    of.parameters.contains(&parameter)
                        || of.states.iter().chain(&of.initial).any(|&state| moved[state as usize])
                };
                if !moved[state] && of.iter().any(reads) {
                    moved[state] = true;
                    grows = true;
                }
            }
        }
        moved
    }

    /// Adds the sensitivities to one parameter; `place` is its index among the parameters and their number, `moved` as
    /// [`Model::moved_by`].
    fn add_sensitivity(&self, extended: &mut Model, parameter: u32, place: (usize, usize), moved: &[bool]) {
        let states = self.states.len();
        let first = extended.states.len();
        let initial: Vec<NodeId> = self.states.iter().map(|state| state.initial).collect();
        let rates: Vec<NodeId> = self.states.iter().map(|state| state.derivative).collect();
        let graph = &mut extended.graph;
        let at_start = total(graph, &initial, parameter, first, &[]);
        let derivatives = total(graph, &rates, parameter, first, &initial);
        let zero = graph.constant(0.0);
        let scale = self.parameters[parameter as usize].value.abs();
        let scale = if scale > 0.0 { scale } else { self.parameters[parameter as usize].unit.factor.abs() };
        for (number, state) in self.states.iter().enumerate() {
            let mut unit = Unit::dimensionless();
            // The step control takes the unit as the typical size of the state.
            unit.factor = state.unit.factor / scale;
            extended.states.push(State {
                variable: format!("d{}/d{}", state.name(), self.parameters[parameter as usize].name),
                order: 0,
                label: None,
                unit,
                initial: at_start[number],
                role: Role::Own,
                // Begins at 0 and stays there.
                derivative: if moved[number] { derivatives[number] } else { zero },
            });
        }
        for number in 0..self.events.len() {
            self.add_jump(extended, number, parameter, place, &initial);
        }
        for (switch, delays) in extended.sensitive.iter_mut().flat_map(|sensitive| &mut sensitive.delays) {
            let crossings = crossings(&mut extended.graph, *switch);
            delays.push(delay(&mut extended.graph, &crossings, parameter, first, &rates, &initial));
        }
        debug_assert_eq!(extended.states.len(), first + states);
    }

    /// Adds to event `number` the jump of the sensitivities to one parameter.
    fn add_jump(
        &self,
        extended: &mut Model,
        number: usize,
        parameter: u32,
        (position, parameters): (usize, usize),
        initial: &[NodeId],
    ) {
        let event = &self.events[number];
        let states = self.states.len();
        let first = states * (position + 1);
        let all = states * (parameters + 1);
        let rates: Vec<NodeId> = self.states.iter().map(|state| state.derivative).collect();
        let graph = &mut extended.graph;
        let crossings = comparisons(graph, event.condition);
        let own_delay = delay(graph, &crossings, parameter, first, &rates, initial);
        let delay = graph.insert(Node::State((all + position) as u32));
        let mut after: Vec<NodeId> = (0..states).map(|state| graph.insert(Node::State(state as u32))).collect();
        for &(state, value) in &event.actions {
            after[state as usize] = value;
        }
        let rates_after = with_states(graph, &rates, &after);
        // `direct`: h_x s + h_p; `moving`: the rate of h along the motion.
        let direct = total(graph, &after, parameter, first, initial);
        let moving = moving(graph, &after, &rates);
        let mut sensitivities = Vec::with_capacity(states);
        for state in 0..states {
            let lag = graph.subtract(moving[state], rates_after[state]);
            let shift = graph.multiply(lag, delay);
            sensitivities.push(graph.add(direct[state], shift));
        }
        if let Some(jump) = &mut extended.events[number].jump {
            jump.delays.push(own_delay);
            jump.sensitivities.extend(sensitivities);
        }
    }
}

/// `nodes` with the first states replaced by these values.
fn with_states(graph: &mut Graph, nodes: &[NodeId], values: &[NodeId]) -> Vec<NodeId> {
    graph.substitute(nodes, |_, node| match node {
        Node::State(state) => values.get(state as usize).copied(),
        _ => None,
    })
}

/// Total derivatives with respect to a parameter. The sensitivities of the states begin at state `first`; `initial` has the
/// nodes of the initial values, written `y(0)` in expressions.
fn total(graph: &mut Graph, nodes: &[NodeId], parameter: u32, first: usize, initial: &[NodeId]) -> Vec<NodeId> {
    let one = graph.constant(1.0);
    let at_start = along(graph, initial, |node| (node == Node::Parameter(parameter)).then_some(one));
    let states = initial.len();
    // `initial` is empty while the initial values themselves are differentiated: they contain no states.
    let sensitivities: Vec<NodeId> =
        (0..states).map(|state| graph.insert(Node::State((first + state) as u32))).collect();
    along(graph, nodes, |node| match node {
        Node::Parameter(number) => (number == parameter).then_some(one),
        Node::State(state) => sensitivities.get(state as usize).copied(),
        Node::Initial(state) => at_start.get(state as usize).copied(),
        _ => None,
    })
}

/// Rates of change along a solution whose states have the rates `rates`.
fn moving(graph: &mut Graph, nodes: &[NodeId], rates: &[NodeId]) -> Vec<NodeId> {
    let one = graph.constant(1.0);
    along(graph, nodes, |node| match node {
        Node::State(state) => rates.get(state as usize).copied(),
        Node::Independent => Some(one),
        _ => None,
    })
}

/// Derivative with respect to a parameter of the moment at which one of these expressions passes through zero.
///
/// Of several expressions, such as the comparisons of a condition, the one nearest to its zero in time counts. An
/// expression with zero speed is ignored. If none is left, the derivative is 0.
fn delay(
    graph: &mut Graph,
    crossings: &[NodeId],
    parameter: u32,
    first: usize,
    rates: &[NodeId],
    initial: &[NodeId],
) -> NodeId {
    let zero = graph.constant(0.0);
    let never = graph.constant(f64::MAX);
    let (mut nearest, mut known) = (never, zero);
    for &crossing in crossings {
        let change = total(graph, &[crossing], parameter, first, initial)[0];
        let speed = moving(graph, &[crossing], rates)[0];
        let quotient = graph.divide(change, speed);
        let delay = graph.negate(quotient);
        let ahead = graph.divide(crossing, speed);
        let ahead = graph.unary(Unary::Absolute, ahead);
        // Without speed this is NaN or infinite, and the comparison is false.
        let nearer = graph.binary(Binary::Less, ahead, nearest);
        (nearest, known) = (graph.select(nearer, ahead, nearest), graph.select(nearer, delay, known));
    }
    known
}

/// Expressions that pass through zero where a switch changes; for rounding functions, up to a constant.
fn crossings(graph: &mut Graph, switch: NodeId) -> Vec<NodeId> {
    match graph.node(switch) {
        Node::Piece(interpolation, x) => vec![graph.passing_points(interpolation, x)],
        Node::Unary(_, x) => vec![x],
        Node::Binary(_, a, b) => vec![graph.subtract(a, b)],
        _ => Vec::new(),
    }
}

/// Left minus right side of every inequality in a condition.
fn comparisons(graph: &mut Graph, condition: NodeId) -> Vec<NodeId> {
    let mut open = vec![condition];
    let mut found = Vec::new();
    while let Some(id) = open.pop() {
        match graph.node(id) {
            Node::Unary(Unary::Not, inner) => open.push(inner),
            Node::Binary(Binary::And | Binary::Or, a, b) => open.extend([b, a]),
            Node::Binary(Binary::Less | Binary::LessOrEqual, a, b) => {
                let difference = graph.subtract(a, b);
                if !found.contains(&difference) {
                    found.push(difference);
                }
            }
            _ => {}
        }
    }
    found
}
