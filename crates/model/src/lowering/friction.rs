//! Dry friction: `coulomb(v, F_s, F_k)` is the force F_k against the motion while a body slides. While the body sticks (v =
//! 0), it is the force that keeps v at 0, up to F_s. Coulomb's law; the switching between sliding and sticking follows
//! Karnopp, J. Dyn. Syst. Meas. Control 107 (1985) 100.
//!
//! Each friction gets a state that only events change: 1 or -1 while it slides forwards or backwards, 0 while it sticks.
//! The forces lambda of the sticking ones are solved from dv/dt = 0, which is linear in all lambda. One event ends the
//! sliding when v passes through 0, another the sticking when the force exceeds F_s.

use crate::limits;
use crate::names::{Declarations, for_each};
use crate::{Diagnostic, Expression, ExpressionKind, Places, Span};
use program::{
    Binary, Event, Graph, LinearSystem, Model, Node, NodeId, Role, State, Unary, Variable, along, differentiate,
};
use std::collections::HashMap;
use units::{Unit, words};

/// Place of each friction, and its speed as written.
pub(crate) type Calls = HashMap<NodeId, (Span, String)>;

/// One dry friction of a model.
struct Friction {
    node: NodeId,
    speed: NodeId,
    /// Limit of the force while it sticks (F_s), and force while it slides (F_k).
    limits: [NodeId; 2],
    /// Rate of change of the speed: `rate` with, `rest` without all friction forces.
    rate: NodeId,
    rest: NodeId,
    /// Change of `rate` per unit of force, one value per friction.
    effects: Vec<NodeId>,
    /// State whose rate is adjusted to hold the speed at 0, and the derivative of the speed with respect to that state.
    target: (usize, NodeId),
    /// State that holds the direction of motion: 1, -1 or 0.
    motion: NodeId,
    span: Span,
}

/// Solves the model for its dry friction, and adds the necessary states and events.
pub(crate) fn add_friction(
    model: &mut Model,
    places: &mut Places,
    calls: &Calls,
    declarations: &Declarations,
) -> Result<(), Vec<Diagnostic>> {
    let roots = roots(model);
    let is_friction = |id: &NodeId| matches!(model.graph.node(*id), Node::Friction(..));
    let mut found: Vec<NodeId> = model.graph.reachable(&roots).into_iter().filter(is_friction).collect();
    // `F(0)` of a force F is not a separate friction.
    let first_of: HashMap<NodeId, NodeId> = found
        .iter()
        .map(|&node| (initially(&mut model.graph, node), node))
        .filter(|(first, node)| first != node)
        .collect();
    found.retain(|node| !first_of.contains_key(node));
    if found.is_empty() {
        return start_without_friction(model, places);
    }
    let first = declarations.equations.first().map(|equation| equation.span).unwrap_or_default();
    let span = |node: &NodeId| calls.get(node).map_or(first, |(span, _)| *span);
    if found.len() > limits::FRICTIONS {
        let message = words!("the model has {} dry frictions; {} are the most", found.len(), limits::FRICTIONS);
        return Err(vec![Diagnostic::error("model-too-large", message, span(&found[limits::FRICTIONS]))]);
    }
    let states = model.states.len();
    let mut frictions = Vec::new();
    let mut diagnostics = Vec::new();
    for (number, &node) in found.iter().enumerate() {
        match friction(model, node, &found, states + number, span(&node)) {
            Ok(friction) => frictions.push(friction),
            Err(diagnostic) => diagnostics.push(*diagnostic),
        }
    }
    if !diagnostics.is_empty() {
        return Err(diagnostics);
    }
    let forces = forces(&mut model.graph, &frictions, None);
    let mut replaced: HashMap<NodeId, NodeId> = found.iter().copied().zip(forces.iter().copied()).collect();
    for (first, node) in first_of {
        if let Some(&force) = replaced.get(&node) {
            replaced.insert(first, initially(&mut model.graph, force));
        }
    }
    put_in(model, &replaced);
    for (number, (friction, &force)) in frictions.iter().zip(&forces).enumerate() {
        hold(model, friction, &replaced);
        let held = self::forces(&mut model.graph, &frictions, Some(number))[number];
        let text = calls.get(&friction.node).map_or("v", |(_, speed)| speed);
        add_state(model, friction, held, &frictions, format!("coulomb({text})"));
        places.states.push(friction.span);
        add_events(model, friction, force, held);
        places.events.extend([friction.span; 2]);
    }
    put_in_at_start(model, &replaced);
    start_without_friction(model, places)
}

/// Replaces frictions in initial values by the forces at the start.
fn put_in_at_start(model: &mut Model, forces: &HashMap<NodeId, NodeId>) {
    let initial: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
    if !has_friction(&model.graph, &initial) {
        return;
    }
    let graph = &mut model.graph;
    let mut known = HashMap::new();
    for (&friction, &force) in forces {
        let [friction_then, force] =
            [friction, force].map(|node| at_start(graph, node, |_, state, _| initial.get(state as usize).copied()));
        known.extend([(friction, force), (friction_then, force)]);
    }
    let values = graph.rewrite(&initial, |_, id, _| known.get(&id).copied());
    for (state, value) in model.states.iter_mut().zip(values) {
        state.initial = value;
    }
}

/// Error for initial values that depend on dry friction which depends on them or has no effect.
fn start_without_friction(model: &Model, places: &Places) -> Result<(), Vec<Diagnostic>> {
    let depends = model.states.iter().position(|state| has_friction(&model.graph, &[state.initial]));
    let Some(span) = depends.and_then(|state| places.states.get(state)) else { return Ok(()) };
    let message = words("this value at the start depends on dry friction, which depends on the values at the start");
    Err(vec![
        Diagnostic::error("friction-at-start", message, *span)
            .with_hint(words("dry friction belongs into the equation of motion: `m*x'' = -k*x - coulomb(x', mu*m*g)`")),
    ])
}

/// `node` at the start of the run, as a function of the initial states.
fn initially(graph: &mut Graph, node: NodeId) -> NodeId {
    at_start(graph, node, |graph, state, _| Some(graph.insert(Node::Initial(state))))
}

/// `node` at the start of the run. `initial` gives the value of a state from its number and node.
fn at_start(graph: &mut Graph, node: NodeId, initial: impl Fn(&mut Graph, u32, NodeId) -> Option<NodeId>) -> NodeId {
    graph.rewrite(&[node], |graph, id, node| match node {
        Node::State(state) | Node::Initial(state) => initial(graph, state, id),
        Node::Independent => Some(graph.constant(0.0)),
        _ => None,
    })[0]
}

/// All nodes that may contain friction.
fn roots(model: &Model) -> Vec<NodeId> {
    let states = model.states.iter().map(|state| state.derivative);
    let quantities = model.quantities.iter().map(|quantity| quantity.value.node);
    let events = model
        .events
        .iter()
        .flat_map(|event| event.actions.iter().map(|(_, value)| *value).chain(std::iter::once(event.condition)));
    states.chain(quantities).chain(events).collect()
}

/// Calls of dry friction in an expression.
pub(crate) fn frictions(expression: &Expression) -> Vec<&Expression> {
    let mut calls = Vec::new();
    for_each(expression, |part| {
        if let ExpressionKind::Call { function, .. } = &part.kind
            && function.text == "coulomb"
        {
            calls.push(part);
        }
    });
    calls
}

/// True if any of these expressions contains friction.
fn has_friction(graph: &Graph, roots: &[NodeId]) -> bool {
    graph.reachable(roots).into_iter().any(|id| matches!(graph.node(id), Node::Friction(..)))
}

/// Properties of one friction.
fn friction(
    model: &mut Model,
    node: NodeId,
    all: &[NodeId],
    motion: usize,
    span: Span,
) -> Result<Friction, Box<Diagnostic>> {
    let Node::Friction(speed, adhesion, sliding) = model.graph.node(node) else {
        return Err(without_effect(span));
    };
    if has_friction(&model.graph, &[speed, adhesion, sliding]) {
        let message = words("the speed and the limits of dry friction must not depend on dry friction");
        return Err(Box::new(Diagnostic::error("friction-of-friction", message, span)));
    }
    let rate = model.rates_of(&[speed])[0];
    let rates: Vec<NodeId> = model.states.iter().map(|state| state.derivative).collect();
    let graph = &mut model.graph;
    let (one, zero) = (graph.constant(1.0), graph.constant(0.0));
    let by = |graph: &mut Graph, node: NodeId, friction: NodeId| {
        let wanted = graph.node(friction);
        along(graph, &[node], |node| (node == wanted).then_some(one))[0]
    };
    let effects: Vec<NodeId> = all.iter().map(|&other| by(graph, rate, other)).collect();
    if has_friction(graph, &effects) {
        let message = words("the equations are not linear in this dry friction");
        return Err(Box::new(Diagnostic::error("friction-not-linear", message, span)));
    }
    let target = rates.iter().enumerate().find_map(|(state, &rate)| {
        let slope = differentiate(graph, speed, Variable::State(state as u32));
        (slope != zero && by(graph, rate, node) != zero).then_some((state, slope))
    });
    let own = all.iter().position(|&other| other == node).map(|place| effects[place]);
    let Some(target) = target.filter(|_| own != Some(zero)) else { return Err(without_effect(span)) };
    let rest = graph.rewrite(&[rate], |_, _, node| matches!(node, Node::Friction(..)).then_some(zero))[0];
    let motion = graph.insert(Node::State(motion as u32));
    Ok(Friction { node, speed, limits: [adhesion, sliding], rate, rest, effects, target, motion, span })
}

fn without_effect(span: Span) -> Box<Diagnostic> {
    let message = words("this dry friction does not act on what moves with its speed");
    let diagnostic = Diagnostic::error("friction-without-effect", message, span)
        .with_hint(words("write it into the equation of motion: `m*x'' = -k*x - coulomb(x', mu*m*g)`"));
    Box::new(diagnostic)
}

/// Forces of all frictions; the one with index `held` is treated as sticking.
fn forces(graph: &mut Graph, frictions: &[Friction], held: Option<usize>) -> Vec<NodeId> {
    let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
    let sticks: Vec<NodeId> = (frictions.iter().enumerate())
        .map(
            |(number, friction)| {
                if held == Some(number) { one } else { graph.binary(Binary::Equal, friction.motion, zero) }
            },
        )
        .collect();
    let sliding: Vec<NodeId> =
        frictions.iter().map(|friction| graph.multiply(friction.motion, friction.limits[1])).collect();
    if let [friction] = frictions {
        let opposite = graph.divide(friction.rest, friction.effects[0]);
        let sticking = graph.negate(opposite);
        return vec![graph.select(sticks[0], sticking, sliding[0])];
    }
    let (mut entries, mut right) = (Vec::new(), Vec::new());
    for (row, friction) in frictions.iter().enumerate() {
        for (column, &effect) in friction.effects.iter().enumerate() {
            let own = if row == column { one } else { zero };
            entries.push(((row, column), graph.select(sticks[row], effect, own)));
        }
        let opposite = graph.negate(friction.rest);
        right.push(graph.select(sticks[row], opposite, sliding[row]));
    }
    let system = graph.insert_system(LinearSystem::new(entries, right));
    (0..frictions.len()).map(|row| graph.insert(Node::Solution { system, row: row as u32 })).collect()
}

/// Replaces the frictions by their forces.
fn put_in(model: &mut Model, forces: &HashMap<NodeId, NodeId>) {
    let old = roots(model);
    let new = model.graph.rewrite(&old, |_, id, _| forces.get(&id).copied());
    let replaced: HashMap<NodeId, NodeId> = old.into_iter().zip(new).collect();
    let put = |node: &mut NodeId| *node = replaced[node];
    model.states.iter_mut().for_each(|state| put(&mut state.derivative));
    model.quantities.iter_mut().for_each(|quantity| put(&mut quantity.value.node));
    for event in &mut model.events {
        put(&mut event.condition);
        event.actions.iter_mut().for_each(|(_, value)| put(value));
    }
}

/// Sets the rate of the speed to exactly 0, without rounding errors, while a friction sticks.
fn hold(model: &mut Model, friction: &Friction, forces: &HashMap<NodeId, NodeId>) {
    let (target, slope) = friction.target;
    let graph = &mut model.graph;
    let rate = graph.rewrite(&[friction.rate], |_, id, _| forces.get(&id).copied())[0];
    let zero = graph.constant(0.0);
    let sticks = graph.binary(Binary::Equal, friction.motion, zero);
    let excess = graph.divide(rate, slope);
    let free = model.states[target].derivative;
    let held = graph.subtract(free, excess);
    model.states[target].derivative = graph.select(sticks, held, free);
}

/// 0 if this force can be held, otherwise the sign of the direction in which the friction starts to slide.
fn gives_way(graph: &mut Graph, friction: &Friction, force: NodeId) -> NodeId {
    let zero = graph.constant(0.0);
    let magnitude = graph.unary(Unary::Absolute, force);
    let holds = graph.binary(Binary::LessOrEqual, magnitude, friction.limits[0]);
    let direction = graph.unary(Unary::Sign, force);
    graph.select(holds, zero, direction)
}

/// Adds the state for the direction of motion. `held` is the force that would keep the friction sticking.
fn add_state(model: &mut Model, friction: &Friction, held: NodeId, all: &[Friction], name: String) {
    let initial: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
    let graph = &mut model.graph;
    let zero = graph.constant(0.0);
    let at_start = |graph: &mut Graph, node: NodeId, motions: &HashMap<NodeId, NodeId>| {
        at_start(graph, node, |_, state, id| motions.get(&id).or(initial.get(state as usize)).copied())
    };
    // At the start the other frictions stick if their speed is 0.
    let mut motions = HashMap::new();
    for other in all {
        let speed = at_start(graph, other.speed, &HashMap::new());
        let direction = graph.unary(Unary::Sign, speed);
        motions.insert(other.motion, direction);
    }
    let held = at_start(graph, held, &motions);
    let limit = at_start(graph, friction.limits[0], &motions);
    let moves = motions[&friction.motion];
    let from_rest = gives_way(graph, &Friction { limits: [limit; 2], effects: Vec::new(), ..*friction }, held);
    let rests = graph.binary(Binary::Equal, moves, zero);
    let start = graph.select(rests, from_rest, moves);
    model.states.push(State {
        variable: name,
        order: 0,
        label: None,
        unit: Unit::dimensionless(),
        role: Role::Friction,
        initial: start,
        derivative: zero,
    });
}

/// Adds the events for the end of sliding and the end of sticking.
fn add_events(model: &mut Model, friction: &Friction, force: NodeId, held: NodeId) {
    let graph = &mut model.graph;
    let zero = graph.constant(0.0);
    let Node::State(motion) = graph.node(friction.motion) else { return };
    let (target, slope) = friction.target;
    let slides = graph.binary(Binary::NotEqual, friction.motion, zero);
    let forwards = graph.multiply(friction.motion, friction.speed);
    let turned = graph.binary(Binary::Less, forwards, zero);
    let condition = graph.binary(Binary::And, slides, turned);
    let state = graph.insert(Node::State(target as u32));
    let excess = graph.divide(friction.speed, slope);
    let stopped = graph.subtract(state, excess);
    let direction = gives_way(graph, friction, held);
    let actions = vec![(target as u32, stopped), (motion, direction)];
    model.events.push(Event::new(condition, actions));
    let sticks = graph.binary(Binary::Equal, friction.motion, zero);
    let magnitude = graph.unary(Unary::Absolute, force);
    let exceeded = graph.binary(Binary::Less, friction.limits[0], magnitude);
    let condition = graph.binary(Binary::And, sticks, exceeded);
    // With a limit of 0 the force is 0 just before sliding begins: the friction gives way in the direction of the rate of
    // the force.
    let rate = model.rates_of(&[force])[0];
    let graph = &mut model.graph;
    let none = graph.binary(Binary::Equal, force, zero);
    let pushed = graph.select(none, rate, force);
    let direction = graph.unary(Unary::Sign, pushed);
    model.events.push(Event::new(condition, vec![(motion, direction)]));
}
