//! Values of equilibrium: what begins at rest there stays.

use super::energy::Energy;
use super::equilibrium::{Equilibrium, equilibria};
use super::labels::{is_rest, without_equilibrium};
use super::period::{Labelled, labelled};
use super::proposal::{Proposal, named};
use super::study::{Study, rough};
use program::Role;
use units::{Words, words};

/// Name of the kind.
pub const KIND: &str = "rest";

/// Claims that what begins in a labelled equilibrium stays there.
pub fn equilibria_stay(study: &mut Study, _: &[Energy]) -> Vec<Proposal> {
    let labelled = labelled(study);
    let motions: Vec<Equilibrium> = equilibria(study);
    let mut proposals = Vec::new();
    for equilibrium in motions {
        let dimension = study.model.states[equilibrium.motion.position as usize].unit.dimension;
        let related = |labelled: &&Labelled| {
            let depends = study.model.depends(labelled.value.node).parameters;
            is_rest(&labelled.label)
                && labelled.value.dimension() == dimension
                && depends.iter().any(|index| equilibrium.parameters.contains(index))
        };
        if let Some(rest) = labelled.iter().find(related) {
            let velocity = study.initial_parameter(equilibrium.motion.velocity);
            let still = velocity.filter(|&index| study.stated[index] != 0.0);
            let mut setup = study.assignments(&equilibrium.drive);
            setup.extend(still.map(|index| study.assignment(index, 0.0)));
            proposals.extend(stays(study, setup, &[(equilibrium.motion.position, rest)]));
        } else {
            proposals.extend(stays_at_zero(study, &equilibrium));
        }
    }
    let of_states: Vec<(u32, &Labelled)> = (0..study.model.states.len() as u32)
        .filter_map(|state| {
            let own = &study.model.states[state as usize];
            let label = own.label.as_deref().filter(|_| own.role == Role::Own && own.order == 0)?.to_lowercase();
            let is_its_own = |rest: &&Labelled| without_equilibrium(&rest.label).is_some_and(|rest| rest == label);
            labelled.iter().find(is_its_own).map(|rest| (state, rest))
        })
        .collect();
    proposals.extend(stays(study, Vec::new(), &of_states));
    proposals
}

/// A run that begins at rest in a stable equilibrium at 0, without a drive.
fn stays_at_zero(study: &Study, equilibrium: &Equilibrium) -> Option<Proposal> {
    let motion = equilibrium.motion;
    let start = study.initial_parameter(motion.position)?;
    let velocity = study.initial_parameter(motion.velocity);
    let still = study.run[0].states[motion.velocity as usize] == 0.0 || velocity.is_some();
    let state = &study.model.states[motion.position as usize];
    let greatest = study.run.iter().map(|point| point.states[motion.position as usize].abs()).fold(0.0, f64::max);
    if equilibrium.position != 0.0
        || equilibrium.stiffness <= 0.0
        || !still
        || !study.can_vanish(start)
        || greatest == 0.0
    {
        return None;
    }
    let mut off = equilibrium.drive.clone();
    off.extend([Some(start), velocity].into_iter().flatten());
    let name = state.name();
    let shown = Words::same(name.clone());
    Some(Proposal {
        kind: KIND,
        subject: name.clone(),
        setup: study.assignments(&off),
        name: named(&study.language, &words!("At rest {name} stays", name = shown.clone())),
        claim: format!("{name} within {} of 0 always", rough(state.unit.from_si(1e-6 * greatest), &state.unit.text)),
        why: words!("{name} = 0 is an equilibrium of the equations", name = shown),
        suspicion: None,
        routine: false,
    })
}

/// A run that begins with these states in equilibrium.
fn stays(study: &Study, mut setup: Vec<String>, rests: &[(u32, &Labelled)]) -> Option<Proposal> {
    let (first, rest) = *rests.first()?;
    for &(state, rest) in rests {
        let parameter = study.initial_parameter(state)?;
        setup.push(format!("{} = {}", study.model.parameters[parameter].name, rest.name));
    }
    let state = &study.model.states[first as usize];
    let name = state.name();
    let moved = study.run.iter().map(|point| (point.states[first as usize] - rest.number).abs()).fold(0.0, f64::max);
    let within = rough(state.unit.from_si(1e-3 * moved), &state.unit.text);
    let [shown, of] = [rest.name.clone(), name.clone()].map(Words::same);
    (moved > 0.0).then(|| Proposal {
        kind: KIND,
        subject: rest.name.clone(),
        setup,
        name: named(&study.language, &words!("At {shown} it stays", shown = shown.clone())),
        claim: format!("{name} within {within} of {} always", rest.name),
        why: words!("{shown} is labelled as the equilibrium of {of}", shown = shown.clone(), of = of.clone()),
        suspicion: Some(words!(
            "{of} leaves {shown}, which is no equilibrium of the equations: look at signs and factors in both"
        )),
        routine: false,
    })
}
