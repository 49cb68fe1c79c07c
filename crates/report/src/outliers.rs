//! Outliers of a fit as text.

use crate::written::{of_record, quantity};
use analysis::fit::{Outcome, Outlier, Task};
use units::number::{Style, fixed, plain};
use units::{Language, Unit};

/// Maximum number of outliers that are listed, those with the largest deviations.
const NAMED: usize = 5;

/// Sentence about the outliers with value, time and deviation in standard deviations of the others; `None` if there are
/// none.
pub fn outliers(outcome: &Outcome, task: &Task, independent: (&str, &Unit), language: Language) -> Option<String> {
    let mut farthest: Vec<&Outlier> = outcome.outliers.iter().collect();
    farthest.sort_by(|one, other| other.sigmas.abs().total_cmp(&one.sigmas.abs()));
    let style = language.style();
    let named_quantity = |name: &str, si: f64, unit: &Unit| [name, " = ", &quantity(si, unit, style)].concat();
    let named = |one: &&Outlier| {
        let fit = outcome.outlying(one)?;
        let value = named_quantity(&fit.name, *fit.measured.get(one.row)?, &fit.unit);
        let time = named_quantity(independent.0, *fit.times.get(one.row)?, independent.1);
        let record = of_record(Some(one.record), task);
        let distance = if outcome.misled { String::new() } else { [" (", &sigmas(one.sigmas, style), " σ)"].concat() };
        Some([&record, &value, language.say(" at "), &time, &distance].concat())
    };
    let mut list: Vec<String> = farthest.iter().take(NAMED).filter_map(named).collect();
    if list.is_empty() {
        return None;
    }
    let more = farthest.len().saturating_sub(NAMED);
    if more > 0 {
        list.push([&more.to_string(), language.say(" more")].concat());
    }
    let one = farthest.len() == 1;
    let count = if one { String::new() } else { farthest.len().to_string() };
    let head = match (outcome.misled, one) {
        (true, true) => language.say("One value lies far from all others: "),
        (true, false) => language.say(" values lie far from all others: "),
        (false, true) => language.say("One value is an outlier: "),
        (false, false) => language.say(" values are outliers: "),
    };
    Some([&count, head, &language.join(&list), advice(outcome, one, language)].concat())
}

/// Second part of the sentence about outliers: consequence and remedy.
fn advice(outcome: &Outcome, one: bool, language: Language) -> &'static str {
    match (outcome.misled, one) {
        (true, true) => language.say(
            ". It has decided the fit, and the curve does not describe the others. It may stand for a missing measurement: correct it \
             or leave it out, and fit again.",
        ),
        (true, false) => language.say(
            ". They have decided the fit, and the curve does not describe the others. They may stand for missing measurements: correct \
             them or leave them out, and fit again.",
        ),
        _ if outcome.reweighted.is_some() => {
            language.say("; σ is the scatter of the others.")
        }
        (false, true) => language.say(
            "; σ is the scatter of the others. Check it, or fit with a robust loss.",
        ),
        (false, false) => language.say(
            "; σ is the scatter of the others. Check them, or fit with a robust loss.",
        ),
    }
}

/// A signed number of standard deviations, with the sign `+` or `−`.
pub fn sigmas(sigmas: f64, style: Style) -> String {
    let size = sigmas.abs();
    let number = match size {
        ..10.0 => fixed(size, 1, style),
        10.0..1e4 => fixed(size, 0, style),
        _ => plain(size, 2, style),
    };
    [if sigmas < 0.0 { "−" } else { "+" }, &number].concat()
}
