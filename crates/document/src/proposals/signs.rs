//! Signs: friction opposes the motion, and weight pulls down.

use super::energy::Energy;
use super::labels::{is_gravity, is_height};
use super::proposal::{Proposal, named};
use super::study::{Motion, Study};
use super::terms::Class;
use super::written::written;
use program::{NodeId, Variable, differentiate};
use units::{Dimension, Unit, Words, words};

/// Name of the kind of claims about friction.
pub const FRICTION: &str = "friction";
/// Name of the kind of claims about weight.
pub const WEIGHT: &str = "weight";

/// Claims that terms which change their sign with the velocity take energy.
pub fn friction(study: &mut Study, energies: &[Energy]) -> Vec<Proposal> {
    let mut proposals: Vec<Proposal> = energies.iter().filter_map(|energy| loss(study, energy)).collect();
    for motion in study.motions.clone() {
        if !energies.iter().any(|energy| energy.motions.contains(&motion)) {
            proposals.extend(opposed(study, motion));
        }
    }
    proposals
}

/// Sign of values: `None` if it changes, or if all are 0.
fn sign(values: &[f64]) -> Option<f64> {
    let numbers = || values.iter().filter(|value| value.is_finite());
    let scale = numbers().map(|value| value.abs()).fold(0.0, f64::max);
    let has = |sign: f64| numbers().any(|value| value * sign > 1e-9 * scale);
    match (has(1.0), has(-1.0)) {
        (true, false) => Some(1.0),
        (false, true) => Some(-1.0),
        _ => None,
    }
}

/// The energy never grows.
fn loss(study: &mut Study, energy: &Energy) -> Option<Proposal> {
    let frictions = energy.frictions();
    let sum = study.sum(&frictions);
    let sign = sign(&study.values(&[sum])[0])?;
    let others: Vec<NodeId> = energy.changes().into_iter().filter(|power| !frictions.contains(power)).collect();
    let off = study.vanishing(&others)?;
    if off.iter().any(|&index| study.model.depends(sum).parameters.contains(&(index as u32))) {
        return None;
    }
    let (moving, mut parameters) = study.moving(&energy.motions, &off)?;
    let mut setup = study.assignments(&off);
    setup.extend(moving);
    if study.values_at(&[sum], &parameters, &study.run)[0].iter().all(|power| *power == 0.0) {
        let index = nonzero(study, sum)?;
        parameters[index] = study.generic[index];
        setup.push(study.assignment(index, study.generic[index]));
    }
    let within = energy.tolerance(study, &parameters, 1e-3)?;
    let name = &energy.name;
    let at_start = study.values_at(&[energy.node], &parameters, &[study.start(&parameters)])[0][0];
    let claim = if within.ends_with('%') && at_start > 0.0 {
        format!("{name} < 1.001*{name}(0) always")
    } else {
        format!(
            "{name} - {name}(0) < {} always",
            if within.ends_with('%') { energy.amount(1e-3 * at_start.abs()) } else { within }
        )
    };
    let shown = Words::same(name.clone());
    Some(Proposal {
        kind: FRICTION,
        subject: name.clone(),
        setup,
        name: named(&study.language, &words!("{name} never grows", name = shown.clone())),
        claim,
        why: words("a term that changes its sign with the velocity is a friction, which takes energy"),
        suspicion: (sign > 0.0).then(|| {
            words!("the term that changes its sign with the velocity feeds {shown}: a friction has the wrong sign")
        }),
        routine: false,
    })
}

/// A parameter that is 0 in the document, so that the node vanishes.
fn nonzero(study: &Study, node: NodeId) -> Option<usize> {
    let mut indices = study.model.depends(node).parameters.into_iter().map(|index| index as usize);
    indices.find(|&index| study.stated[index] != study.generic[index])
}

/// The terms of one acceleration that change their sign with the velocity point against it.
fn opposed(study: &mut Study, motion: Motion) -> Option<Proposal> {
    let terms = study.terms(&[motion]);
    let odd: Vec<NodeId> =
        terms.iter().filter(|(term, _)| term.class == Class::Odd).map(|(term, _)| term.node).collect();
    let sum = study.sum(&odd);
    let velocity = study.model.graph.insert(program::Node::State(motion.velocity));
    let product = study.model.graph.multiply(sum, velocity);
    let sign = sign(&study.values(&[product])[0])?;
    let text = written(&study.model, sum)?;
    let state = &study.model.states[motion.velocity as usize];
    let (name, dimension) = (state.name(), state.unit.dimension);
    let unit = dimension.times(dimension)?.per(study.model.independent.unit.dimension)?;
    let zero = if unit.is_none() { "0".to_owned() } else { format!("0 [{}]", Unit::si(unit).text) };
    let setup = match study.values_at(&[sum], &study.stated, &study.run)[0].iter().all(|force| *force == 0.0) {
        true => nonzero(study, sum).map(|index| study.assignment(index, study.generic[index])).into_iter().collect(),
        false => Vec::new(),
    };
    let shown = Words::same(name.clone());
    Some(Proposal {
        kind: FRICTION,
        subject: state.variable.clone(),
        setup,
        name: named(&study.language, &words!("Friction opposes {name}", name = shown.clone())),
        claim: format!("({text})*{name} <= {zero} always"),
        why: words!("a term that changes its sign with {shown} is a friction, which opposes it"),
        suspicion: (sign > 0.0).then(|| {
            words!(
                "the term {text} drives the motion on instead of slowing it: a friction has the wrong sign",
                text = Words::same(text.clone())
            )
        }),
        routine: true,
    })
}

/// Claims that heights are accelerated downwards by gravity.
pub fn weight(study: &mut Study, _: &[Energy]) -> Vec<Proposal> {
    let acceleration = Dimension::from_whole([0, 1, -2, 0, 0, 0, 0]);
    let gravity = study.model.parameters.iter().position(|parameter| {
        parameter.unit.dimension == acceleration && parameter.label.as_deref().is_some_and(is_gravity)
    });
    let Some(gravity) = gravity else { return Vec::new() };
    let motions = study.motions.clone();
    motions.into_iter().filter_map(|motion| falls(study, gravity, motion)).collect()
}

fn falls(study: &mut Study, gravity: usize, motion: Motion) -> Option<Proposal> {
    let state = &study.model.states[motion.position as usize];
    if !state.label.as_deref().is_some_and(is_height) || state.unit.dimension != Dimension::LENGTH {
        return None;
    }
    let (name, velocity) = (state.name(), study.model.states[motion.velocity as usize].name());
    let slope = differentiate(&mut study.model.graph, motion.acceleration, Variable::Parameter(gravity as u32));
    let sign = sign(&study.values(&[slope])[0])?;
    let start = study.values_at(&[motion.acceleration, slope], &study.stated, &[study.start(&study.stated)]);
    // The claim is about the first moment: weight alone must be the greatest force.
    if start[0][0] * start[1][0] <= 0.0 {
        return None;
    }
    let shown = Words::same(name.clone());
    Some(Proposal {
        kind: WEIGHT,
        subject: name,
        setup: Vec::new(),
        name: named(&study.language, &words!("Weight pulls {name} down", name = shown.clone())),
        claim: format!("{velocity}' < 0 [m/s^2] at {}", study.beginning()),
        why: words!("{shown} is labelled as a height, and gravity accelerates it"),
        suspicion: (sign > 0.0).then(|| words!("gravity accelerates {shown} upwards: the weight has the wrong sign")),
        routine: true,
    })
}
