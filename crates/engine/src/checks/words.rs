//! Outcomes of claims as text.

use super::outcome::{Measured, Outcome, Verdict};
use program::{Claim, Model, Moment, Program, Test, Tolerance};
use units::number::{Style, plain};
use units::{Language, Unit, Words, words};

/// Significant digits of values; differences have [`FEW`].
const DIGITS: usize = 7;
const FEW: usize = 2;

/// The outcome of a claim in one line: the worst value, its time, the expected value and the difference.
pub fn claim_outcome(program: &Program, claim: &Claim, outcome: &Outcome) -> Words {
    match (&outcome.verdict, &outcome.worst) {
        (Verdict::Stopped(error), _) => {
            words!("the run stops: {stopped}", stopped = error.message(&program.model))
        }
        (Verdict::NotReached, _) => words("the run ends before"),
        (Verdict::TooLong, _) => words("not decided: the run takes too much computing"),
        (Verdict::Held, None) => words("true"),
        (Verdict::Failed, None) => words("not true"),
        (_, Some(worst)) => {
            let at = moment(&program.model, worst.time);
            match worst.measured {
                None => words!("not true at {at}"),
                Some(measured) => {
                    let said = said(program, claim, &measured, &at);
                    match claim.moment {
                        Moment::Always => words!("at worst {said}"),
                        _ => said,
                    }
                }
            }
        }
    }
}

/// The independent variable as text, for example `t = 3.2 s`; `time` in SI units.
pub fn moment(model: &Model, time: f64) -> Words {
    let (name, unit) = (model.independent.name.clone(), model.independent.unit.clone());
    Words::each(move |language| format!("{name} = {}", quantity(time, &unit, DIGITS, language)))
}

fn said(program: &Program, claim: &Claim, measured: &Measured, at: &Words) -> Words {
    let (unit, relative) = match &claim.test {
        Test::Near { value, tolerance, .. } | Test::HalvedStep { value, tolerance } => {
            (&value.unit, matches!(tolerance, Tolerance::Relative(_)))
        }
        Test::Holds { compared, .. } => {
            let Some(compared) = compared else { return Words::same("") };
            (
                if program.model.graph.as_constant(compared.left.node).is_some() {
                    &compared.right.unit
                } else {
                    &compared.left.unit
                },
                false,
            )
        }
    };
    let number = |si: f64| {
        let unit = unit.clone();
        Words::each(move |language| quantity(si, &unit, DIGITS, language))
    };
    let distance = |off: f64| {
        let unit = unit.clone();
        Words::each(move |language| difference(off, &unit, relative, language))
    };
    let (value, expected) = (number(measured.value), number(measured.expected));
    let off = distance(measured.off);
    let allowed = measured.allowed.map(distance).unwrap_or_else(|| Words::same(""));
    match &claim.test {
        Test::Near { .. } => words!("{value} at {at}; expected {expected}, off by {off} ({allowed} allowed)",),
        Test::HalvedStep { .. } if program.method.unwrap_or_default().adaptive() => words!(
            "{value} at {at}; with a tenth of the tolerance {expected}, a change of {off} (less than {allowed} claimed)",
        ),
        Test::HalvedStep { .. } => {
            words!("{value} at {at}; with half the step {expected}, a change of {off} (less than {allowed} claimed)",)
        }
        Test::Holds { .. } => {
            words!("{value} at {at}, compared with {expected}")
        }
    }
}

/// A quantity as text in its display unit, for example `612.5 J`.
fn quantity(si: f64, unit: &Unit, digits: usize, language: Language) -> String {
    let number = plain(unit.from_si(si), digits, Style::of(language.tag()));
    if unit.text.is_empty() { number } else { format!("{number} {unit}") }
}

/// A difference as text: in percent if it is relative, else in the display unit.
fn difference(off: f64, unit: &Unit, relative: bool, language: Language) -> String {
    if relative {
        return format!("{} %", plain(100.0 * off, FEW, Style::of(language.tag())));
    }
    quantity(off, unit, FEW, language)
}
