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
        Some([&record, &value, language.pick::<&str>(" at ", " en "), &time, &distance].concat())
    };
    let mut list: Vec<String> = farthest.iter().take(NAMED).filter_map(named).collect();
    if list.is_empty() {
        return None;
    }
    let more = farthest.len().saturating_sub(NAMED);
    if more > 0 {
        list.push([&more.to_string(), language.pick::<&str>(" more", " más")].concat());
    }
    let one = farthest.len() == 1;
    let count = if one { String::new() } else { farthest.len().to_string() };
    let head = match (outcome.misled, one) {
        (true, true) => {
            language.pick("One value lies far from all others: ", "Un valor está muy lejos de todos los demás: ")
        }
        (true, false) => {
            language.pick(" values lie far from all others: ", " valores están muy lejos de todos los demás: ")
        }
        (false, true) => language.pick("One value is an outlier: ", "Un valor es atípico: "),
        (false, false) => language.pick(" values are outliers: ", " valores son atípicos: "),
    };
    Some([&count, head, &language.join(&list), advice(outcome, one, language)].concat())
}

/// Second part of the sentence about outliers: consequence and remedy.
fn advice(outcome: &Outcome, one: bool, language: Language) -> &'static str {
    match (outcome.misled, one) {
        (true, true) => language.pick(
            ". It has decided the fit, and the curve does not describe the others. It may stand for a missing measurement: correct it \
             or leave it out, and fit again.",
            ". Ha decidido el ajuste, y la curva no describe los demás. Puede representar una medición que falta: corrígelo u omítelo, y \
             ajusta de nuevo.",
        ),
        (true, false) => language.pick(
            ". They have decided the fit, and the curve does not describe the others. They may stand for missing measurements: correct \
             them or leave them out, and fit again.",
            ". Han decidido el ajuste, y la curva no describe los demás. Pueden representar mediciones que faltan: corrígelos u \
             omítelos, y ajusta de nuevo.",
        ),
        _ if outcome.reweighted.is_some() => {
            language.pick("; σ is the scatter of the others.", "; σ es la dispersión de los demás.")
        }
        (false, true) => language.pick(
            "; σ is the scatter of the others. Check it, or fit with a robust loss.",
            "; σ es la dispersión de los demás. Revísalo o ajusta con una pérdida robusta.",
        ),
        (false, false) => language.pick(
            "; σ is the scatter of the others. Check them, or fit with a robust loss.",
            "; σ es la dispersión de los demás. Revísalos o ajusta con una pérdida robusta.",
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
