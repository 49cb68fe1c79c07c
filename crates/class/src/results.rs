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
    /// Name of the quantity in the theory.
    pub name: String,
    /// True if it follows from the fitted parameters.
    pub is_derived: bool,
    /// Unit in which it is shown; that of the first hand-in, empty for a pure number.
    pub unit: String,
    /// Index of each hand-in that has it, and its result.
    pub results: Vec<(usize, Measured)>,
    /// The pooled value, or the reason why there is none.
    pub pool: Result<Pool, Words>,
}

/// Prefixes of the facts with standard errors and with units.
const ERROR: &str = "standard error of ";
const UNIT: &str = "unit of ";
/// Prefix of quantities that follow from the fitted parameters.
const DERIVED: &str = "derived ";

/// Results of a quantity by hand-in.
#[derive(Default)]
struct Found {
    unit: Option<String>,
    results: BTreeMap<usize, Measured>,
}

/// Fitted quantities of hand-ins, by theory and name. `hand_ins`: index and computed facts of each. Of several fits of a
/// hand-in with the same theory the last one counts. A quantity that a fit does not determine is left out.
pub fn quantities<'a>(hand_ins: impl Iterator<Item = (usize, &'a [Fact])>) -> Vec<Quantity> {
    let mut found: BTreeMap<(String, String), Found> = BTreeMap::new();
    for (index, facts) in hand_ins {
        for fit in facts.chunk_by(|one, other| one.part == other.part && one.item == other.item) {
            let theory = fit.iter().find(|fact| fact.part == Part::Fit && fact.quantity == "theory");
            let Some(FactValue::Text(theory)) = theory.map(|fact| &fact.value) else { continue };
            for error in fit {
                let Some(name) = error.quantity.strip_prefix(ERROR) else { continue };
                let value = fit.iter().find(|fact| fact.quantity == name).and_then(number);
                let measured = value.zip(number(error)).map(|(value, error)| Measured { value, error });
                if let Some(measured) = measured.filter(|one| one.value.is_finite() && one.error > 0.0) {
                    let unit = fit.iter().find(|fact| fact.quantity.strip_prefix(UNIT) == Some(name)).and_then(text);
                    let found = found.entry((theory.clone(), name.to_owned())).or_default();
                    found.unit.get_or_insert(unit.unwrap_or_default());
                    found.results.insert(index, measured);
                }
            }
        }
    }
    let quantity = |((theory, name), found): ((String, String), Found)| {
        let (unit, results) = (found.unit.unwrap_or_default(), Vec::from_iter(found.results));
        let pool = pool(&results.iter().map(|(_, measured)| *measured).collect::<Vec<_>>());
        let derived = name.strip_prefix(DERIVED).map(str::to_owned);
        let is_derived = derived.is_some();
        Quantity { theory, name: derived.unwrap_or(name), is_derived, unit, results, pool }
    };
    found.into_iter().map(quantity).collect()
}

fn text(fact: &Fact) -> Option<String> {
    match &fact.value {
        FactValue::Text(text) => Some(text.clone()),
        FactValue::Number(_) => None,
    }
}

fn number(fact: &Fact) -> Option<f64> {
    match fact.value {
        FactValue::Number(Number(number)) => Some(number),
        FactValue::Text(_) => None,
    }
}
