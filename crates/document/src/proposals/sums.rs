//! Sums that are kept because rates of change cancel: populations, charges, momenta.

use super::energy::Energy;
use super::pattern::{amounts, is_rounding};
use super::proposal::{Proposal, named};
use super::study::{Study, rough};
use super::written::written;
use program::{NodeId, Role};
use units::{Words, words};

/// Name of the kind.
pub const KIND: &str = "sum";
/// Maximum number of variables of a sum.
const MOST: usize = 12;
/// Factors that a mistake makes of a term.
const MISTAKES: [f64; 3] = [-1.0, 2.0, 0.5];

/// A variable that may be part of a sum: its weight, and the terms of its weighted rate of change.
#[derive(Clone)]
struct Part {
    state: u32,
    weight: Option<NodeId>,
    terms: Vec<NodeId>,
    values: Vec<Vec<f64>>,
}

/// Claims that sums are kept whose rates of change cancel.
pub fn kept(study: &mut Study, _: &[Energy]) -> Vec<Proposal> {
    let mut parts: Vec<Part> = (0..study.model.states.len() as u32).filter_map(|state| part(study, state)).collect();
    let mut proposals = Vec::new();
    while let Some(first) = parts.pop() {
        let mut group = vec![first];
        while let Some(index) = parts.iter().position(|part| group.iter().any(|other| shares(part, other))) {
            group.push(parts.swap_remove(index));
        }
        group.sort_by_key(|part| part.state);
        if (2..=MOST).contains(&group.len()) && alike(study, &group) {
            proposals.extend(sum(study, &group));
        }
    }
    proposals.reverse();
    proposals
}

fn part(study: &mut Study, state: u32) -> Option<Part> {
    let own = study.model.states[state as usize].clone();
    let is_position = study.motions.iter().any(|motion| motion.position == state);
    if !matches!(own.role, Role::Own) || is_position || study.is_discrete(state) || !is_name(&own.variable) {
        return None;
    }
    let terms = study.split(own.derivative);
    let forces: Vec<[NodeId; 2]> = terms.iter().map_while(|&term| study.divided(term)).collect();
    let mass = forces.first().map(|[_, mass]| *mass).filter(|mass| {
        let is_velocity = study.motions.iter().any(|motion| motion.velocity == state);
        is_velocity
            && forces.len() == terms.len()
            && forces.iter().all(|[_, other]| other == mass)
            && !study.model.depends(*mass).varies()
    });
    let terms = if mass.is_some() { forces.into_iter().map(|[force, _]| force).collect() } else { terms };
    let values = study.values_moved(&terms);
    Some(Part { state, weight: mass, terms, values })
}

/// False for states that store running values.
fn is_name(variable: &str) -> bool {
    !variable.contains([' ', '('])
}

/// True if a term of one is a term of the other but for a constant factor.
fn shares(one: &Part, other: &Part) -> bool {
    one.values.iter().any(|term| other.values.iter().any(|same| are_proportional(term, same)))
}

fn are_proportional(one: &[f64], other: &[f64]) -> bool {
    let square = |list: &[f64]| list.iter().map(|value| value * value).sum::<f64>();
    let factor = one.iter().zip(other).map(|(a, b)| a * b).sum::<f64>() / square(other);
    let simple = [1.0, 2.0, 0.5].iter().any(|simple| (factor.abs() - simple).abs() < 1e-9);
    let rest: f64 = one.iter().zip(other).map(|(a, b)| (a - factor * b) * (a - factor * b)).sum();
    let varies = one.iter().any(|value| (value - one[0]).abs() > 1e-9 * one[0].abs());
    simple && varies && rest <= 1e-16 * square(one)
}

/// True if all weighted variables have one dimension.
fn alike(study: &Study, group: &[Part]) -> bool {
    let dimension = |part: &Part| study.model.states[part.state as usize].unit.dimension;
    group
        .iter()
        .all(|part| dimension(part) == dimension(&group[0]) && part.weight.is_some() == group[0].weight.is_some())
}

fn sum(study: &Study, group: &[Part]) -> Option<Proposal> {
    let terms: Vec<&[f64]> = group.iter().flat_map(|part| part.values.iter().map(Vec::as_slice)).collect();
    let amounts = amounts(&terms);
    let total: Vec<f64> = (0..amounts.len()).map(|point| terms.iter().map(|term| term[point]).sum()).collect();
    let mistake =
        if is_rounding(&total, &amounts) { None } else { Some(mistake(group, &total, &amounts, terms.len())?) };
    let summand = |part: &Part, suffix: &str| {
        let name = study.model.states[part.state as usize].name();
        Some(match part.weight {
            Some(weight) => format!("{}*{name}{suffix}", factor(study, weight)?),
            None => format!("{name}{suffix}"),
        })
    };
    let join = |suffix: &str| group.iter().map(|part| summand(part, suffix)).collect::<Option<Vec<_>>>();
    let text = join("")?.join(" + ");
    let greatest = group
        .iter()
        .filter(|part| part.weight.is_none())
        .flat_map(|part| study.run.iter().map(|point| point.states[part.state as usize].abs()));
    let greatest = greatest.fold(0.0, f64::max);
    let unit = &study.model.states[group[0].state as usize].unit;
    let start: f64 = group.iter().map(|part| study.run[0].states[part.state as usize]).sum();
    // A sum near 0 has no fraction.
    let within = match group[0].weight {
        None if start.abs() < 0.01 * greatest => rough(unit.from_si(1e-6 * greatest), &unit.text),
        _ => "0.0001 %".to_owned(),
    };
    let names: Vec<String> = group.iter().map(|part| study.model.states[part.state as usize].name()).collect();
    let shown = Words::same(text.clone());
    let suspicion = mistake.map(|term| {
        let term = Words::same(written(&study.model, term).unwrap_or_else(|| "?".to_owned()));
        words!("what leaves one variable does not reach the others: all terms of {shown} would cancel if {term} had another sign or factor")
    });
    Some(Proposal {
        kind: KIND,
        subject: names.join(" "),
        setup: Vec::new(),
        name: named(&study.language, &words!("{names} are kept together", names = Words::same(names.join(", ")))),
        claim: format!("{text} within {within} of {} always", join("(0)")?.join(" + ")),
        why: words!("what leaves one variable reaches another, so that their rates of change cancel"),
        suspicion,
        routine: false,
    })
}

fn factor(study: &Study, weight: NodeId) -> Option<String> {
    let text = written(&study.model, weight)?;
    Some(if text.contains([' ', '+', '-', '/']) { format!("({text})") } else { text })
}

/// The term that would have to have another sign or factor for all rates to cancel.
fn mistake(group: &[Part], total: &[f64], amounts: &[f64], terms: usize) -> Option<NodeId> {
    let corrected = |term: &[f64], factor: f64| {
        let left: Vec<f64> = total.iter().zip(term).map(|(total, value)| total + (factor - 1.0) * value).collect();
        is_rounding(&left, amounts)
    };
    let all = group.iter().flat_map(|part| part.terms.iter().zip(&part.values));
    let mut wrong = all.filter(|(_, values)| MISTAKES.iter().any(|&factor| corrected(values, factor)));
    (terms > 3).then(|| wrong.next().map(|(term, _)| *term)).flatten()
}
