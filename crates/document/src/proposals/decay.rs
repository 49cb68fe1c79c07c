//! Half-lives and time constants of what decays exponentially.

use super::energy::Energy;
use super::labels::{Meaning, meaning};
use super::period::{Labelled, equal, is_mistaken, labelled};
use super::proposal::{Proposal, named};
use super::study::{Study, with_unit};
use program::{Choices, Compiled, Kind, Node, Role};
use std::f64::consts::{E, LN_2};
use units::{Words, words};

/// Name of the kind.
pub const KIND: &str = "decay";
/// Factors of common mistakes.
const MISTAKES: [f64; 4] = [2.0, LN_2, E, 2.0 * LN_2];

/// Claims that a variable decays in the labelled time.
pub fn times(study: &mut Study, _: &[Energy]) -> Vec<Proposal> {
    let mut labelled = labelled(study);
    labelled.extend(parameters(study));
    labelled.retain(|labelled| labelled.value.dimension() == study.model.independent.unit.dimension);
    let states = 0..study.model.states.len() as u32;
    states.filter_map(|state| time(study, state, &labelled)).collect()
}

fn parameters(study: &Study) -> Vec<Labelled> {
    let numbers = study.model.parameters.iter().enumerate().filter(|(_, one)| one.choices == Choices::Numbers);
    numbers
        .filter_map(|(index, parameter)| {
            let node = study.model.graph.find(Node::Parameter(index as u32))?;
            let value = Compiled { node, kind: Kind::Number, unit: parameter.unit.clone() };
            let (name, label) = (parameter.name.clone(), parameter.label.clone()?);
            Some(Labelled { name, label, value, number: parameter.value, moved: study.moved[index] })
        })
        .collect()
}

fn time(study: &mut Study, state: u32, labelled: &[Labelled]) -> Option<Proposal> {
    let own = study.model.states[state as usize].clone();
    let depends = study.model.depends(own.derivative);
    if own.role != Role::Own || depends.states != [state] || depends.independent {
        return None;
    }
    let slope = study.slope(own.derivative, state);
    let run = study.values_at(&[slope, own.derivative], &study.stated, &study.run);
    let rate = -run[0][0];
    if rate.is_nan() || rate <= 0.0 || !run[0].iter().all(|slope| equal(-slope, rate)) {
        return None;
    }
    let (start, end) = (study.run[0].states[state as usize], study.run[0].states[state as usize] + run[1][0] / rate);
    let end = if end.abs() <= 1e-9 * start.abs() { 0.0 } else { end };
    let elsewhere = -study.values_at(&[slope], &study.moved, &study.run[..1])[0][0];
    let expected = |meaning: Meaning| match meaning {
        Meaning::HalfLife => Some([LN_2 / rate, LN_2 / elsewhere]),
        Meaning::TimeConstant => Some([1.0 / rate, 1.0 / elsewhere]),
        _ => None,
    };
    let found = |exact: bool| {
        labelled.iter().find_map(|labelled| {
            let meaning = meaning(&labelled.label)?;
            let [here, elsewhere] = expected(meaning)?;
            let related = study.model.depends(labelled.value.node).parameters;
            let related = related.iter().any(|index| depends.parameters.contains(index));
            let matches = if exact {
                equal(labelled.number, here)
            } else {
                is_mistaken([labelled.number, here], [labelled.moved, elsewhere], &MISTAKES)
            };
            (related && matches).then_some((labelled, meaning))
        })
    };
    let (labelled, meaning) = found(true).or_else(|| found(false))?;
    let name = own.name();
    let part = if meaning == Meaning::HalfLife { "/2" } else { "*exp(-1)" };
    let target = match end {
        0.0 => format!("{name}(0){part}"),
        end => {
            let end = with_unit(own.unit.from_si(end), &own.unit.text);
            format!("{end} + ({name}(0) - {end}){part}")
        }
    };
    let [shown, of] = [labelled.name.clone(), name.clone()].map(Words::same);
    Some(Proposal {
        kind: KIND,
        subject: labelled.name.clone(),
        setup: Vec::new(),
        name: named(&study.language, &words!("Decay by {shown}", shown = shown.clone())),
        claim: format!("{name} within 0.5 % of {target} at {}", labelled.name),
        why: words!(
            "{shown} is labelled as the time of a decay, and {of} decays exponentially",
            shown = shown.clone(),
            of = of.clone()
        ),
        suspicion: Some(words!(
            "{of} decays in another time than {shown} says: look at the factors of the equation and of {shown}"
        )),
        routine: false,
    })
}
