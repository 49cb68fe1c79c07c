//! Warnings about valid models that are probably not what the author meant.

use crate::names::{Declarations, crossing, for_each};
use crate::notation::quote;
use crate::{Diagnostic, ExpressionKind, Places, Span, discrete_kinds, moments};
use program::{Event, Model, Node, NodeId, Unary};
use units::words;

/// Adds the warnings about a model.
pub(crate) fn warn(model: &Model, places: &Places, declarations: &Declarations, diagnostics: &mut Vec<Diagnostic>) {
    friction_by_sign(model, declarations, diagnostics);
    // Events of crossings and of dry friction come in pairs and need no warning.
    let mut written = Vec::new();
    let mut number = 0;
    for event in &declarations.events {
        let crosses = crossing(declarations, event).is_some();
        let of_author = event.actions.iter().any(|action| is_own(&action.name.text));
        if !crosses && event.button.is_none() && (of_author || event.stops) {
            written.push((&model.events[number], places.events[number], event.condition.span));
        }
        number += if crosses { 2 } else { 1 };
    }
    true_at_the_start(model, &written, diagnostics);
    let written: Vec<(&Event, Span)> = written.iter().map(|&(event, place, _)| (event, place)).collect();
    set_twice(model, &written, diagnostics);
}

/// True if the quantity is the author's, and not one in which an event stores its own data.
fn is_own(name: &str) -> bool {
    !moments::is_hidden(name) || discrete_kinds::quantity(name).is_some()
}

/// Warns of events whose conditions are true at the start with default parameters: an event fires only when its condition
/// becomes true.
fn true_at_the_start(model: &Model, events: &[(&Event, Span, Span)], diagnostics: &mut Vec<Diagnostic>) {
    let mut graph = model.graph.clone();
    let defaults = |nodes: &[NodeId], graph: &mut program::Graph, initial: &[NodeId]| {
        graph.substitute(nodes, |graph, input| match input {
            Node::Parameter(number) => Some(graph.constant(model.parameters.get(number as usize)?.value)),
            Node::State(number) | Node::Initial(number) => initial.get(number as usize).copied(),
            Node::Independent => Some(graph.constant(0.0)),
            _ => None,
        })
    };
    let initial: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
    let initial = defaults(&initial, &mut graph, &[]);
    for &(event, _, place) in events {
        let truth = defaults(&[event.condition], &mut graph, &initial);
        // No warning if the actions change nothing at the start; data that the event stores about itself do not count.
        let values: Vec<NodeId> = event.actions.iter().map(|(_, value)| *value).collect();
        let values = defaults(&values, &mut graph, &initial);
        let is_set = |((state, _), value): (&(u32, NodeId), &NodeId)| {
            let is_hidden = model.states.get(*state as usize).is_some_and(|state| !is_own(&state.variable));
            is_hidden || initial.get(*state as usize) == Some(value)
        };
        if !event.stops && event.actions.iter().zip(&values).all(is_set) {
            continue;
        }
        if truth.iter().any(|&truth| graph.as_constant(truth).is_some_and(|truth| truth != 0.0)) {
            let message = words("the condition is true at the start already, and there the event does not fire");
            diagnostics.push(Diagnostic::warning("true-at-the-start", message, place).with_hint(words(
                "it fires when it becomes true again; what holds from the start belongs in the initial values",
            )));
        }
    }
}

/// Warns of events with the same condition that set the same state: the later one overrides the earlier one.
fn set_twice(model: &Model, events: &[(&Event, Span)], diagnostics: &mut Vec<Diagnostic>) {
    for (number, &(event, place)) in events.iter().enumerate() {
        let mut earlier = events[..number].iter().filter(|(other, _)| other.condition == event.condition);
        let sets = |&(state, _): &(u32, NodeId)| event.actions.iter().any(|&(own, _)| own == state);
        let clash = earlier.find_map(|(other, place)| {
            let (state, _) = other.actions.iter().find(|action| sets(action))?;
            let name = model.states.get(*state as usize)?.name();
            Some((discrete_kinds::quantity(&name).map_or_else(|| name.clone(), str::to_owned), *place))
        });
        if let Some((name, first)) = clash {
            let message = words!("this event and an earlier one set `{name}` at the same moment");
            diagnostics.push(
                Diagnostic::warning("set-twice", message, place).with_label(first, words("the earlier one")).with_hint(
                    words(
                        "they act in the order of the document, each on what those before have left; write one event",
                    ),
                ),
            );
        }
    }
}

/// Warns of friction written with `sign`: near rest both signs drive the speed back to 0 (chattering).
fn friction_by_sign(model: &Model, declarations: &Declarations, diagnostics: &mut Vec<Diagnostic>) {
    let Some(held) = model.held(false) else { return };
    let mut moving = model.clone();
    let mut leads_back = |node: NodeId| {
        let Node::Unary(Unary::Sign, x) = held.model.graph.node(node) else { return false };
        let rate = moving.rates_of(&[x]);
        moving.graph.reachable(&rate).contains(&node)
    };
    if !held.switches.iter().any(|switch| switch.jumps && leads_back(switch.node)) {
        return;
    }
    let equations = declarations.equations.iter().flat_map(|equation| [equation.left, equation.right]);
    let definitions = declarations.definitions.iter().map(|definition| definition.value);
    let mut found: Option<(Span, String)> = None;
    for expression in equations.chain(definitions) {
        for_each(expression, |part| {
            if let ExpressionKind::Call { function, arguments } = &part.kind
                && let ("sign", [speed]) = (function.text.as_str(), arguments.as_slice())
            {
                let primed = matches!(speed.kind, ExpressionKind::Name { order, .. } if order > 0);
                if found.is_none() || primed {
                    found = Some((part.span, quote(speed)));
                }
            }
        });
    }
    let Some((span, speed)) = found else { return };
    let message = words!("`sign({speed})` cannot hold a body at rest: where `{speed}` comes to 0 the run stops");
    diagnostics.push(
        Diagnostic::warning("sign-as-friction", message, span)
            .with_hint(words!("for dry friction write `coulomb({speed}, F)` in place of `F*sign({speed})`")),
    );
}
