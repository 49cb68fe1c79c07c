//! Results of a class: the same quantity, fitted with the same theory by several groups.

use crate::pooling::{Measured, Pool, pool};
use saved::Number;
use saved::hand_in::{Fact, FactValue, Part};
use std::collections::BTreeMap;
use units::Words;

/// A quantity fitted with a theory, in SI units.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Title of the theory.
    pub theory: String,
    /// Name of the quantity.
    pub name: String,
    /// Index of each hand-in that has it, and its result.
    pub results: Vec<(usize, Measured)>,
    /// The pooled value, or the reason why there is none.
    pub pool: Result<Pool, Words>,
}

/// Prefix of the facts with standard errors.
const ERROR: &str = "standard error of ";

/// Fitted quantities of hand-ins, by theory and name. `hand_ins`: index and computed facts of each. Of several fits of a
/// hand-in with the same theory the last one counts. A quantity that a fit does not determine is left out.
pub fn quantities(hand_ins: &[(usize, Vec<Fact>)]) -> Vec<Quantity> {
    let mut found: BTreeMap<(String, String), BTreeMap<usize, Measured>> = BTreeMap::new();
    for (index, facts) in hand_ins {
        for fit in facts.chunk_by(|one, other| one.part == other.part && one.item == other.item) {
            let theory = fit.iter().find(|fact| fact.part == Part::Fit && fact.quantity == "theory");
            let Some(FactValue::Text(theory)) = theory.map(|fact| &fact.value) else { continue };
            for error in fit {
                let Some(name) = error.quantity.strip_prefix(ERROR) else { continue };
                let value = fit.iter().find(|fact| fact.quantity == name).and_then(number);
                let measured = value.zip(number(error)).map(|(value, error)| Measured { value, error });
                if let Some(measured) = measured.filter(|one| one.value.is_finite() && one.error > 0.0) {
                    found.entry((theory.clone(), name.to_owned())).or_default().insert(*index, measured);
                }
            }
        }
    }
    let quantity = |((theory, name), results): (_, BTreeMap<usize, Measured>)| {
        let results: Vec<(usize, Measured)> = results.into_iter().collect();
        let pool = pool(&results.iter().map(|(_, measured)| *measured).collect::<Vec<_>>());
        Quantity { theory, name, results, pool }
    };
    found.into_iter().map(quantity).collect()
}

fn number(fact: &Fact) -> Option<f64> {
    match fact.value {
        FactValue::Number(Number(number)) => Some(number),
        FactValue::Text(_) => None,
    }
}
