//! Parameters that are labelled as the value of a variable at the start.

use super::energy::Energy;
use super::labels::without_start;
use super::proposal::{Proposal, named};
use super::study::{Study, rough};
use program::{Choices, Node, NodeId, Role};
use units::{Unit, Words, words};

/// Name of the kind.
pub const KIND: &str = "start";

/// Claims that variables begin with the values of the parameters that are labelled so.
pub fn labelled(study: &mut Study, _: &[Energy]) -> Vec<Proposal> {
    (0..study.model.parameters.len()).filter_map(|index| one(study, index)).collect()
}

fn one(study: &mut Study, index: usize) -> Option<Proposal> {
    let parameter = study.model.parameters[index].clone();
    let label = without_start(parameter.label.as_deref().filter(|_| parameter.choices == Choices::Numbers)?)?;
    let (name, node, unit) = variable(study, &label, &parameter.unit)?;
    let depends = |study: &Study, node: NodeId| {
        let own = study.model.depends(node);
        let initial = own.states.iter().chain(&own.initial).map(|&state| study.model.states[state as usize].initial);
        initial.flat_map(|initial| study.model.depends(initial).parameters).chain(own.parameters).collect::<Vec<u32>>()
    };
    // A value that is computed from the parameter may differ from it for a reason.
    if depends(study, node).contains(&(index as u32)) {
        return None;
    }
    let moved = study.moved[index];
    let setup = vec![study.assignment(index, moved)];
    let within = rough(unit.from_si(1e-5 * moved.abs()), &unit.text);
    let [shown, of] = [parameter.name.clone(), name.clone()].map(Words::same);
    Some(Proposal {
        kind: KIND,
        subject: parameter.name.clone(),
        setup,
        name: named(&study.language, &words!("{of} begins with {shown}", of = of.clone(), shown = shown.clone())),
        claim: format!("{name} within {within} of {} at {}", parameter.name, study.beginning()),
        why: words!("{shown} is labelled as the value of {of} at the start", shown = shown.clone(), of = of.clone()),
        suspicion: Some(words!("what {of} begins with does not depend on {shown}: two initial values may be swapped")),
        routine: true,
    })
}

/// The one state whose label begins with these words, or the definition that has just this label; with its unit.
fn variable(study: &mut Study, label: &str, unit: &Unit) -> Option<(String, NodeId, Unit)> {
    let exact = |own: &Option<String>| own.as_deref().is_some_and(|own| own.to_lowercase() == label);
    let begins = |own: &Option<String>| {
        let own = own.as_deref().unwrap_or_default().to_lowercase();
        own.strip_prefix(label).is_some_and(|rest| rest.starts_with([' ', ',', '(']))
    };
    let states = || {
        let alike = |state: &program::State| state.role == Role::Own && state.unit.dimension == unit.dimension;
        study.model.states.iter().enumerate().filter(move |(_, state)| alike(state))
    };
    let of = |(index, state): (usize, &program::State)| (state.name(), Node::State(index as u32), state.unit.clone());
    let exactly: Vec<_> = states().filter(|(_, state)| exact(&state.label)).map(of).collect();
    let roughly: Vec<_> = states().filter(|(_, state)| begins(&state.label)).map(of).collect();
    if let [(name, node, unit)] = if exactly.is_empty() { roughly } else { exactly }.as_slice() {
        return Some((name.clone(), study.model.graph.insert(*node), unit.clone()));
    }
    let quantity =
        study.model.quantities.iter().find(|quantity| {
            exact(&quantity.label) && quantity.varies && quantity.value.dimension() == unit.dimension
        })?;
    Some((quantity.name.clone(), quantity.value.node, quantity.value.unit.clone()))
}
