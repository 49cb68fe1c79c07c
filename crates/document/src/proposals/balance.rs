//! Integrals of power that account for the changes of an energy.

use super::energy::Energy;
use super::pattern::{amounts, is_rounding};
use super::proposal::{Proposal, named};
use super::study::Study;
use super::written::written;
use program::{Kind, Node, NodeId, Quantity};
use units::{Words, words};

/// Name of the kind.
pub const KIND: &str = "balance";
/// Maximum number of integrals that are combined.
const MOST: usize = 4;
/// Factors of an integral in a balance, and factors that a mistake makes of them.
const FACTORS: [f64; 7] = [0.0, 1.0, -1.0, 2.0, -2.0, 0.5, -0.5];

/// Claims that an energy and the integrals of power of the document add up to the energy at the start.
pub fn accounted(study: &mut Study, energies: &[Energy]) -> Vec<Proposal> {
    let one = |energy: &Energy| accounted_one(study, energy).or_else(|| work(study, energy));
    energies.iter().filter_map(one).collect()
}

fn accounted_one(study: &mut Study, energy: &Energy) -> Option<Proposal> {
    if !energy.is_explained() || energy.changes().is_empty() {
        return None;
    }
    let integrals = integrals(study, energy);
    let nodes: Vec<NodeId> = integrals.iter().map(|integral| integral.value.node).collect();
    let rates = study.model.rates_of(&nodes);
    let nodes: Vec<NodeId> = rates.into_iter().chain(energy.changes()).chain([energy.rate]).collect();
    let values = study.values_moved(&nodes);
    let lists: Vec<&[f64]> = values.iter().map(Vec::as_slice).collect();
    let amounts = amounts(&lists);
    let factors = balance(&values[..integrals.len()], values.last()?, &amounts)?;
    let (setup, parameters) = changing(study, energy)?;
    let mut left = energy.name.clone();
    for (integral, factor) in integrals.iter().zip(&factors).filter(|(_, factor)| **factor != 0.0) {
        left.push_str(if *factor > 0.0 { " + " } else { " - " });
        left.push_str(&integral.name);
    }
    let within = energy.tolerance(study, &parameters, 1e-3)?;
    let name = Words::same(energy.name.clone());
    let wrong = integrals.iter().zip(&factors).find(|(_, factor)| factor.abs() != 1.0 && **factor != 0.0);
    let suspicion = wrong.map(|(integral, factor)| {
        let (integral, factor) = (Words::same(integral.name.clone()), Words::same(factor.abs().to_string()));
        words!("the terms of the equations change {name} {factor} times as much as {integral} says: a factor is wrong in one of both", name = name.clone())
    });
    Some(Proposal {
        kind: KIND,
        subject: energy.name.clone(),
        setup,
        name: named(&study.language, &words!("{name} is accounted for", name = name.clone())),
        claim: format!("{left} within {within} of {}(0) always", energy.name),
        why: words!("the works of all terms add up to the change of {name}"),
        suspicion,
        routine: false,
    })
}

/// A run in which the energy changes: assignments, and all parameters, SI units.
fn changing(study: &Study, energy: &Energy) -> Option<(Vec<String>, Vec<f64>)> {
    let (mut setup, mut parameters) = study.moving(&energy.motions, &[])?;
    // A document without friction shows nothing of its work.
    if study.values_at(&energy.changes(), &parameters, &study.run).iter().flatten().all(|power| *power == 0.0) {
        let depends = energy.changes().into_iter().flat_map(|power| study.model.depends(power).parameters);
        let index = depends.map(|index| index as usize).find(|&index| study.stated[index] != study.generic[index])?;
        parameters[index] = study.generic[index];
        setup.push(study.assignment(index, study.generic[index]));
    }
    Some((setup, parameters))
}

/// The rate of the energy of one motion is the power of the forces that are not part of it. An acceleration is divided by a
/// mass, and the force is what it divides.
fn work(study: &mut Study, energy: &Energy) -> Option<Proposal> {
    let [motion] = energy.motions.as_slice() else { return None };
    let velocity = study.model.graph.insert(Node::State(motion.velocity));
    let mut forces = Vec::new();
    for (power, term) in energy.changing_terms().filter(|terms| !terms.is_empty())? {
        let force = study.divided(term).map_or(term, |[force, _]| force);
        let product = study.model.graph.multiply(force, velocity);
        let difference = study.model.graph.subtract(product, power);
        let values = study.values(&[difference, power]);
        if !is_rounding(&values[0], &amounts(&[&values[1]])) {
            return None;
        }
        forces.push(written(&study.model, force)?);
    }
    let (setup, _) = changing(study, energy)?;
    let (name, velocity) = (&energy.name, study.model.states[motion.velocity as usize].name());
    let force = forces.join(" + ").replace("+ -", "- ");
    let shown = Words::same(name.clone());
    Some(Proposal {
        kind: KIND,
        subject: name.clone(),
        setup,
        name: named(&study.language, &words!("{name} is accounted for", name = shown.clone())),
        claim: format!("{name}' within 0.01 % of ({force})*{velocity} always"),
        why: words!("the works of all terms add up to the change of {name}", name = shown),
        suspicion: None,
        routine: false,
    })
}

/// Integrals of power: quantities of the dimension of the energy that change with the time, but not with a motion directly,
/// and are 0 at the start.
fn integrals(study: &Study, energy: &Energy) -> Vec<Quantity> {
    let is_motion = |state: &u32| study.motions.iter().any(|one| one.position == *state || one.velocity == *state);
    let is_integral = |quantity: &&Quantity| {
        let depends = study.model.depends(quantity.value.node);
        quantity.value.kind == Kind::Number
            && quantity.value.dimension() == energy.unit.dimension
            && !quantity.remembered
            && !depends.states.is_empty()
            && !depends.states.iter().any(is_motion)
            && depends.states.iter().any(|&state| !study.is_discrete(state))
    };
    let start = study.start(&study.generic);
    let is_zero = |quantity: &&Quantity| {
        study.values_at(&[quantity.value.node], &study.generic, std::slice::from_ref(&start))[0][0] == 0.0
    };
    study.model.quantities.iter().filter(is_integral).filter(is_zero).take(MOST).cloned().collect()
}

/// Factors with which the rates of the integrals and that of the energy add up to 0. Those of a correct balance are tried
/// first.
fn balance(integrals: &[Vec<f64>], rate: &[f64], amounts: &[f64]) -> Option<Vec<f64>> {
    for factors in [&FACTORS[..3], &FACTORS[..]] {
        let count = factors.len().pow(integrals.len() as u32);
        for number in 1..count {
            let mut rest = number;
            let chosen: Vec<f64> = integrals
                .iter()
                .map(|_| {
                    let factor = factors[rest % factors.len()];
                    rest /= factors.len();
                    factor
                })
                .collect();
            let mut residual = rate.to_vec();
            for (integral, factor) in integrals.iter().zip(&chosen) {
                residual.iter_mut().zip(integral).for_each(|(left, value)| *left += factor * value);
            }
            if is_rounding(&residual, amounts) {
                return Some(chosen);
            }
        }
    }
    None
}
