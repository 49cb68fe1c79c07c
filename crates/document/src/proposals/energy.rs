//! Energies that the equations of motion keep.

use super::labels::is_energy;
use super::pattern::{Power, amounts, combination, factor, is_rounding};
use super::proposal::{Proposal, named};
use super::study::{Motion, Study, rough};
use super::terms::Class;
use super::written::written;
use program::{Compiled, Kind, Node, NodeId, Quantity, along};
use units::number::shortest;
use units::{Dimension, Unit, Words, words};

/// Name of the kind.
pub const KIND: &str = "energy";
/// Maximum number of energies that are examined.
const MOST: usize = 6;
/// Maximum number of terms whose powers are told apart.
const FEW: usize = 11;
/// Exponents of kg, m and s.
const ENERGY: [i8; 7] = [1, 2, -2, 0, 0, 0, 0];

/// An energy of the document, and the powers that change it.
pub struct Energy {
    pub name: String,
    pub node: NodeId,
    /// Display unit.
    pub unit: Unit,
    /// Rate of change along the equations.
    pub rate: NodeId,
    pub motions: Vec<Motion>,
    /// Powers of its terms.
    powers: Vec<Work>,
    /// Sum of the slopes by velocities times the velocities: for a sum of squares, twice the kinetic energy.
    vis_viva: NodeId,
    /// Powers that change the energy; `None` if no choice of them accounts for its rate.
    changing: Option<Vec<Work>>,
    /// Term that would account for the rate if it had another factor, with this factor.
    wrong: Option<(NodeId, f64)>,
}

/// Power of a term of the equations, or of all terms of a class.
#[derive(Clone, Copy, Debug)]
struct Work {
    power: NodeId,
    /// The term; `None` for several, and for what changes an energy beside the motions.
    term: Option<NodeId>,
    class: Class,
}

impl Work {
    /// True if it is expected to change an energy.
    fn is_expected(&self) -> bool {
        matches!(self.class, Class::Odd | Class::Driven | Class::Other)
    }
}

impl Energy {
    /// Powers that change the energy, or are expected to.
    pub fn changes(&self) -> Vec<NodeId> {
        let expected = || self.powers.iter().copied().filter(Work::is_expected).collect();
        let works: Vec<Work> = self.changing.clone().unwrap_or_else(expected);
        works.iter().map(|work| work.power).collect()
    }

    /// Power and term of each change; `None` if the changes are not those of single terms.
    pub fn changing_terms(&self) -> Option<Vec<(NodeId, NodeId)>> {
        self.changing.as_ref()?.iter().map(|work| Some((work.power, work.term?))).collect()
    }

    /// Powers of the terms that change their sign with the velocity.
    pub fn frictions(&self) -> Vec<NodeId> {
        self.powers.iter().filter(|work| work.class == Class::Odd).map(|work| work.power).collect()
    }

    /// True if the powers of the terms account for the rate of change.
    pub fn is_explained(&self) -> bool {
        self.changing.is_some()
    }

    /// Tolerance of a claim that the energy is kept, from a fraction: of the value at the start, or of twice the kinetic
    /// energy where that is much greater. `None` if it has no value.
    pub fn tolerance(&self, study: &Study, parameters: &[f64], fraction: f64) -> Option<String> {
        let points = [study.start(parameters), study.run[study.run.len().min(2) - 1].clone()];
        let values = study.values_at(&[self.node, self.vis_viva], parameters, &points);
        let [at_start, moving] = [values[0][0], values[1][0]].map(f64::abs);
        let moving = if at_start == 0.0 && moving == 0.0 { values[1][1].abs() } else { moving };
        if !at_start.is_finite() || !moving.is_finite() || at_start + moving == 0.0 {
            return None;
        }
        Some(if at_start >= 0.01 * moving {
            format!("{} %", shortest(100.0 * fraction))
        } else {
            self.amount(fraction * moving)
        })
    }

    /// An amount of energy in its unit, rounded to one digit; the value in SI units.
    pub fn amount(&self, si: f64) -> String {
        rough(self.unit.from_si(si), &self.unit.text)
    }
}

/// The energies among the definitions of a document: they have the dimension or the label of an energy, and all velocities
/// of motions that are coupled with each other.
pub fn energies(study: &mut Study) -> Vec<Energy> {
    let is_energy = |quantity: &&Quantity| {
        let labelled = quantity.label.as_deref().is_some_and(is_energy);
        let measured = quantity.value.dimension() == Dimension::from_whole(ENERGY);
        let shown = !quantity.hidden && !quantity.remembered;
        quantity.value.kind == Kind::Number && quantity.varies && shown && (labelled || measured)
    };
    let quantities: Vec<Quantity> = study.model.quantities.iter().filter(is_energy).cloned().collect();
    let mut energies: Vec<Energy> = Vec::new();
    for quantity in quantities {
        let is_known = energies.iter().any(|energy| energy.node == quantity.value.node);
        if energies.len() < MOST && !is_known {
            energies.extend(energy(study, quantity.name, &quantity.value));
        }
    }
    // Beside an energy with a potential, a kinetic energy alone says little.
    let has_position = |energy: &Energy, study: &Study| {
        let states = study.model.depends(energy.node).states;
        energy.motions.iter().any(|motion| states.contains(&motion.position))
    };
    let whole: Vec<Vec<Motion>> =
        energies.iter().filter(|energy| has_position(energy, study)).map(|energy| energy.motions.clone()).collect();
    energies.retain(|energy| has_position(energy, study) || !whole.contains(&energy.motions));
    energies
}

fn energy(study: &mut Study, name: String, value: &Compiled) -> Option<Energy> {
    let states = study.model.depends(value.node).states;
    let motions: Vec<Motion> =
        study.motions.iter().copied().filter(|motion| states.contains(&motion.velocity)).collect();
    let forces: Vec<u32> = motions.iter().flat_map(|motion| study.model.depends(motion.acceleration).states).collect();
    let uses = |states: &[u32], motion: &Motion| states.contains(&motion.position) || states.contains(&motion.velocity);
    let is_whole = study.motions.iter().all(|motion| !uses(&forces, motion) || motions.contains(motion));
    // A kinetic energy alone changes with every force.
    let has_position = |states: &[u32]| study.motions.iter().any(|motion| states.contains(&motion.position));
    if motions.is_empty() || !is_whole || (!has_position(&states) && has_position(&forces)) {
        return None;
    }
    let slopes: Vec<NodeId> = motions.iter().map(|motion| study.slope(value.node, motion.velocity)).collect();
    let products: Vec<NodeId> = (motions.iter().zip(&slopes))
        .map(|(motion, slope)| {
            let velocity = study.model.graph.insert(Node::State(motion.velocity));
            study.model.graph.multiply(*slope, velocity)
        })
        .collect();
    let mut powers = Vec::new();
    for (term, contributions) in study.terms(&motions) {
        let products: Vec<NodeId> = (slopes.iter().zip(contributions))
            .filter_map(|(slope, contribution)| Some(study.model.graph.multiply(*slope, contribution?)))
            .collect();
        powers.push(Work { power: study.sum(&products), term: Some(term.node), class: term.class });
    }
    let mut powers = grouped(study, powers);
    let [by_motion, by_others] = partial_rates(study, value.node);
    powers.push(Work { power: by_others, term: None, class: Class::Even });
    let energy = Energy {
        name,
        node: value.node,
        unit: value.unit.clone(),
        rate: study.model.rates_of(&[value.node])[0],
        vis_viva: study.sum(&products),
        motions,
        powers,
        changing: None,
        wrong: None,
    };
    explained(study, energy, by_motion)
}

/// Rates of change of an energy by the change of positions alone, and by that of time and states that are no motion.
fn partial_rates(study: &mut Study, node: NodeId) -> [NodeId; 2] {
    let model = &mut study.model;
    let rates: Vec<NodeId> = model.states.iter().map(|state| state.derivative).collect();
    let is_position = |state: u32| study.motions.iter().any(|motion| motion.position == state);
    let is_velocity = |state: u32| study.motions.iter().any(|motion| motion.velocity == state);
    let one = model.graph.constant(1.0);
    let by_motion = along(&mut model.graph, &[node], |input| match input {
        Node::State(state) if is_position(state) => rates.get(state as usize).copied(),
        _ => None,
    });
    let by_others = along(&mut model.graph, &[node], |input| match input {
        Node::State(state) if !is_position(state) && !is_velocity(state) => rates.get(state as usize).copied(),
        Node::Independent => Some(one),
        _ => None,
    });
    [by_motion[0], by_others[0]]
}

/// Powers of many terms, added up class by class.
fn grouped(study: &mut Study, powers: Vec<Work>) -> Vec<Work> {
    if powers.len() <= FEW {
        return powers;
    }
    let classes = [Class::Position, Class::Even, Class::Odd, Class::Driven, Class::Other];
    let of = |class: Class| -> Vec<NodeId> {
        powers.iter().filter(|work| work.class == class).map(|work| work.power).collect()
    };
    classes
        .map(|class| (class, of(class)))
        .into_iter()
        .filter(|(_, powers)| !powers.is_empty())
        .map(|(class, powers)| Work { power: study.sum(&powers), term: None, class })
        .collect()
}

/// The energy with what changes it; `by_motion` is its rate by positions alone. `None` if nothing moves.
fn explained(study: &Study, energy: Energy, by_motion: NodeId) -> Option<Energy> {
    let nodes: Vec<NodeId> = energy.powers.iter().map(|work| work.power).chain([by_motion, energy.rate]).collect();
    let values = study.values(&nodes);
    let (rate, parts) = values.split_last()?;
    let lists: Vec<&[f64]> = parts.iter().map(Vec::as_slice).collect();
    let amounts = amounts(&lists);
    if !amounts.iter().any(|amount| *amount > 0.0) {
        return None;
    }
    let (powers, works): (Vec<Power>, Vec<Work>) = (energy.powers.iter().zip(parts))
        .filter(|(_, values)| !is_rounding(values, &amounts))
        .map(|(work, values)| (Power { values: values.clone(), expected: work.is_expected() }, *work))
        .unzip();
    let changing = combination(rate, &powers, &amounts)
        .map(|chosen| works.iter().zip(chosen).filter(|(_, chosen)| *chosen).map(|(work, _)| *work).collect());
    let wrong = factor(rate, &powers, &amounts).and_then(|(index, factor)| Some((works[index].term?, factor)));
    Some(Energy { powers: works, changing, wrong, ..energy })
}

/// Claims that energies are kept once friction and drive are switched off.
pub fn kept(study: &mut Study, energies: &[Energy]) -> Vec<Proposal> {
    energies.iter().filter_map(|energy| kept_one(study, energy)).collect()
}

fn kept_one(study: &mut Study, energy: &Energy) -> Option<Proposal> {
    let off = study.vanishing(&energy.changes())?;
    let (mut setup, parameters) = study.moving(&energy.motions, &off)?;
    setup.splice(0..0, study.assignments(&off));
    let within = energy.tolerance(study, &parameters, 1e-3)?;
    let name = &energy.name;
    let shown = Words::same(name.clone());
    let suspicion = match (&energy.changing, energy.wrong) {
        // The step may be too coarse, or an event may change it.
        (Some(_), _) => None,
        (None, Some((term, factor))) => {
            let term = Words::same(written(&study.model, term).unwrap_or_else(|| "?".to_owned()));
            let factor = Words::same(shortest((factor * 1e6).round() / 1e6));
            Some(words!(
                "{shown} and the equations disagree: the work of the term {term} would count {factor} times; look at the signs and factors of this term and of its energy"
            ))
        }
        (None, None) => Some(words!(
            "{shown} and the equations disagree: no sum of the works of their terms gives its rate of change; look at signs, factors and masses in both"
        )),
    };
    let why = if off.is_empty() {
        words!("the equations have no term that takes energy or gives it")
    } else {
        let names: Vec<String> = off.iter().map(|&index| study.model.parameters[index].name.clone()).collect();
        words!(
            "without {names} nothing in the equations takes energy or gives it",
            names = Words::same(names.join(", "))
        )
    };
    Some(Proposal {
        kind: KIND,
        subject: name.clone(),
        setup,
        name: named(&study.language, &words!("{name} is kept", name = shown)),
        claim: format!("{name} within {within} of {name}(0) always"),
        why,
        suspicion,
        routine: false,
    })
}
