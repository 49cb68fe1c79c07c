//! Periods, frequencies and damping rates of what swings about an equilibrium.

use super::energy::Energy;
use super::equilibrium::{Equilibrium, equilibria};
use super::labels::{Meaning, is_free, meaning};
use super::proposal::{Proposal, named};
use super::study::{Study, rough, rounded, with_unit};
use program::{Compiled, Kind};
use std::f64::consts::{PI, SQRT_2};
use units::{Words, words};

/// Name of the kind.
pub const KIND: &str = "period";
/// Factors of common mistakes, and their reciprocals.
const MISTAKES: [f64; 5] = [2.0, SQRT_2, 4.0, PI, 2.0 * PI];

/// A labelled quantity that depends on parameters only.
pub(super) struct Labelled {
    pub name: String,
    pub label: String,
    pub value: Compiled,
    /// SI value with the values of the document.
    pub number: f64,
    /// SI value with other ones.
    pub moved: f64,
}

/// Labelled definitions that do not change during a run, with numbers that are not 0.
pub(super) fn labelled(study: &Study) -> Vec<Labelled> {
    let constant = study.model.quantities.iter().filter(|quantity| {
        quantity.value.kind == Kind::Number && !quantity.varies && !quantity.hidden && !quantity.remembered
    });
    constant
        .filter_map(|quantity| {
            let [number, moved] =
                [&study.stated, &study.moved].map(|values| study.constant(quantity.value.node, values));
            let (label, value) = (quantity.label.clone()?, quantity.value.clone());
            (number.is_finite() && number != 0.0).then(|| Labelled {
                name: quantity.name.clone(),
                label,
                value,
                number,
                moved,
            })
        })
        .collect()
}

/// True if two values are equal but for rounding and the last digits of typed constants.
pub(super) fn equal(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= 1e-5 * expected.abs()
}

/// True if a value is a common mistake away from the expected one, with the values of the document and with other ones: a
/// pair of value and expected value for each.
pub(super) fn is_mistaken(here: [f64; 2], elsewhere: [f64; 2], mistakes: &[f64]) -> bool {
    let by = |factor: f64| [here, elsewhere].iter().all(|[value, expected]| equal(*value, expected * factor));
    mistakes.iter().any(|&factor| by(factor) || by(1.0 / factor))
}

/// Claims that a motion takes the labelled time for a half period.
pub fn periods(study: &mut Study, _: &[Energy]) -> Vec<Proposal> {
    let equilibria = equilibria(study);
    let labelled = labelled(study);
    let mut proposals: Vec<Proposal> =
        labelled.iter().filter_map(|labelled| period(study, &equilibria, labelled)).collect();
    // One period of a motion is worth a look; what follows from the same numbers is not.
    let mut seen: Vec<(Vec<String>, String)> = Vec::new();
    for proposal in &mut proposals {
        let motion = proposal.claim.split(' ').next().unwrap_or_default().to_owned();
        let run = (proposal.setup.clone(), motion);
        proposal.routine = seen.contains(&run);
        seen.push(run);
    }
    proposals
}

fn period(study: &Study, equilibria: &[Equilibrium], labelled: &Labelled) -> Option<Proposal> {
    let meaning = meaning(&labelled.label)?;
    let time = study.model.independent.unit.dimension;
    let dimension = if meaning == Meaning::Period { time } else { time.inverse() };
    let own = study.model.depends(labelled.value.node).parameters;
    let related = |equilibrium: &&Equilibrium| own.iter().any(|index| equilibrium.parameters.contains(index));
    if labelled.value.dimension() != dimension {
        return None;
    }
    let related: Vec<&Equilibrium> = equilibria.iter().filter(related).collect();
    if meaning == Meaning::DampingRate {
        return related.into_iter().find_map(|equilibrium| decay(study, equilibrium, labelled));
    }
    let expected = |stiffness: f64| {
        let frequency = stiffness.sqrt();
        match meaning {
            Meaning::Period => 2.0 * PI / frequency,
            Meaning::Frequency if labelled.value.unit.counts_cycles() => frequency / (2.0 * PI),
            _ => frequency,
        }
    };
    let exact = related.iter().find(|one| equal(labelled.number, expected(one.stiffness)));
    let mistaken = |one: &&&Equilibrium| {
        let [here, elsewhere] = [one.stiffness, one.stiffness_moved].map(expected);
        let by_factor = is_mistaken([labelled.number, here], [labelled.moved, elsewhere], &MISTAKES);
        is_free(&labelled.label) && (one.stiffness < 0.0 || by_factor)
    };
    let found = exact.or_else(|| related.iter().find(mistaken))?;
    half_period(study, found, labelled, meaning)
}

/// After half a period the motion is on the other side, at the same distance.
fn half_period(study: &Study, equilibrium: &Equilibrium, labelled: &Labelled, meaning: Meaning) -> Option<Proposal> {
    let off = [equilibrium.drive.as_slice(), equilibrium.friction.as_deref()?].concat();
    let (setup, start) = released(study, equilibrium, &off)?;
    let state = &study.model.states[equilibrium.motion.position as usize];
    let (name, unit) = (state.name(), &state.unit);
    let target = match equilibrium.position {
        0.0 => format!("-{name}(0)"),
        position => format!("{} - {name}(0)", with_unit(unit.from_si(2.0 * position), &unit.text)),
    };
    let half = match meaning {
        Meaning::Period => format!("{}/2", labelled.name),
        Meaning::Frequency if labelled.value.unit.counts_cycles() => format!("1/(2*{})", labelled.name),
        _ => format!("pi/{}", labelled.name),
    };
    let within = rough(unit.from_si(0.05 * (start - equilibrium.position).abs()), &unit.text);
    let [shown, of] = [labelled.name.clone(), name.clone()].map(Words::same);
    Some(Proposal {
        kind: KIND,
        subject: labelled.name.clone(),
        setup,
        name: named(&study.language, &words!("Half a period by {shown}", shown = shown.clone())),
        claim: format!("{name} within {within} of {target} at {half}"),
        why: words!(
            "{shown} is labelled as the period or frequency of {of}, and small oscillations follow from its equation",
            shown = shown.clone(),
            of = of.clone()
        ),
        suspicion: Some(if equilibrium.stiffness < 0.0 {
            words!(
                "the equation of {of} has no force back to an equilibrium, so that {shown} is the period or frequency of nothing: a force has the wrong sign"
            )
        } else {
            words!("the equation of {of} has another period than {shown} says: look at the factors in both")
        }),
        routine: false,
    })
}

/// Assignments of a run without the parameters `off` that begins near an equilibrium (at any distance if the equation is
/// linear), and the position at its start, SI units.
fn released(study: &Study, equilibrium: &Equilibrium, off: &[usize]) -> Option<(Vec<String>, f64)> {
    let motion = equilibrium.motion;
    let mut setup = study.assignments(off);
    let mut parameters = study.stated.clone();
    off.iter().for_each(|&index| parameters[index] = 0.0);
    let start = study.start(&parameters);
    let position = start.states[motion.position as usize];
    let far = |position: f64| (position - equilibrium.position).abs() > 1e-6 * equilibrium.position.abs();
    if equilibrium.linear && far(position) {
        return Some((setup, position));
    }
    let index = study.initial_parameter(motion.position)?;
    let parameter = &study.model.parameters[index];
    let (low, high) = parameter.range.unwrap_or((position - 1.0, position + 1.0));
    let span = (high - low).min(if parameter.unit.dimension.is_none() { 1.0 } else { high - low });
    let near = [1.0, -1.0].map(|side| equilibrium.position + side * 0.02 * span);
    let near = near.into_iter().find(|near| (low..=high).contains(near))?;
    let near = parameter.unit.to_si(rounded(parameter.unit.from_si(near), 2));
    setup.push(study.assignment(index, near));
    match study.initial_parameter(motion.velocity) {
        Some(velocity) if parameters[velocity] != 0.0 => setup.push(study.assignment(velocity, 0.0)),
        None if start.states[motion.velocity as usize] != 0.0 => return None,
        _ => {}
    }
    Some((setup, near))
}

/// After a period the amplitude has decayed at the labelled rate.
fn decay(study: &Study, equilibrium: &Equilibrium, labelled: &Labelled) -> Option<Proposal> {
    let (rate, expected) = (labelled.number, equilibrium.damping / 2.0);
    let stated = equilibrium.friction.as_ref()?.iter().all(|&index| study.stated[index] == study.generic[index]);
    if !stated || !equal(rate, expected) || !equilibrium.linear {
        return None;
    }
    let period = 2.0 * PI / (equilibrium.stiffness - expected * expected).sqrt();
    let (setup, start) = released(study, equilibrium, &equilibrium.drive)?;
    if !(0.001..3.0).contains(&(expected * period)) {
        return None;
    }
    let state = &study.model.states[equilibrium.motion.position as usize];
    let (name, unit) = (state.name(), &state.unit);
    let time = &study.model.independent.unit;
    let time = with_unit(time.from_si(period), &time.text);
    let amplitude = (start - equilibrium.position).abs();
    let within = rough(unit.from_si(0.1 * amplitude * (expected * period).min(0.3)), &unit.text);
    let (from, rest) = match equilibrium.position {
        0.0 => (format!("{name}(0)"), String::new()),
        position => {
            let shown = with_unit(unit.from_si(position.abs()), &unit.text);
            let (sign, against) = if position < 0.0 { ("-", "+") } else { ("", "-") };
            (format!("({name}(0) {against} {shown})"), format!("{sign}{shown} + "))
        }
    };
    let [shown, of] = [labelled.name.clone(), name.clone()].map(Words::same);
    Some(Proposal {
        kind: KIND,
        subject: labelled.name.clone(),
        setup,
        name: named(&study.language, &words!("Decay by {shown}", shown = shown.clone())),
        claim: format!("{name} within {within} of {rest}{from}*exp(-{}*{time}) at {time}", labelled.name),
        why: words!(
            "{shown} is labelled as damping rate, and that of {of} follows from its equation",
            shown = shown.clone(),
            of = of.clone()
        ),
        suspicion: Some(words!(
            "the friction in the equation of {of} damps at another rate than {shown} says: look at the factors in both"
        )),
        routine: false,
    })
}
