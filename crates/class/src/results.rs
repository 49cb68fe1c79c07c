//! Results of a class: the same quantity, fitted with the same theory by several groups.

use crate::pooling::{Measured, Outlier, Pool, pool};
use saved::Number;
use saved::hand_in::{Fact, FactValue, Part};
use std::collections::BTreeMap;
use units::{Unit, Words};

/// A quantity fitted with a theory, in SI units.
#[derive(Clone, Debug, PartialEq)]
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
    /// For each result the parameters that were held fixed in its fit.
    pub fixed: Vec<Vec<Fixed>>,
    /// The pooled value, or the reason why there is none.
    pub pool: Result<Pool, Words>,
}

impl Quantity {
    /// The result at this place of [`Quantity::results`] as an outlier; `None` if it is not far from the others.
    pub fn outlier(&self, place: usize) -> Option<&Outlier> {
        self.pool.as_ref().ok()?.outliers.iter().find(|one| one.index == place)
    }
}

/// A parameter that was held fixed in a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Fixed {
    /// Name of the parameter.
    pub name: String,
    /// Value, SI.
    pub value: f64,
    /// Unit in which it is shown; empty for a pure number.
    pub unit: String,
}

/// Prefixes of the facts with standard errors, with units and with fixed parameters.
const ERROR: &str = "stderr:";
const UNIT: &str = "unit:";
const FIXED: &str = "fixed:";
/// Prefixes of the fitted parameters, and of quantities that follow from them.
const FITTED: &str = "value:";
const DERIVED: &str = "derived:";

/// Results of a quantity by hand-in.
#[derive(Default)]
struct Found {
    unit: Option<String>,
    results: BTreeMap<usize, (Measured, Vec<Fixed>)>,
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
                if let Some(mut measured) = measured.filter(|one| one.value.is_finite() && one.error > 0.0) {
                    let unit = unit(fit, name);
                    let found = found.entry((theory.clone(), name.to_owned())).or_default();
                    let turning = turning(&unit, found.unit.get_or_insert_with(|| unit.clone()));
                    (measured.value, measured.error) = (measured.value * turning, measured.error * turning);
                    found.results.insert(index, (measured, fixed(fit, name)));
                }
            }
        }
    }
    let quantity = |((theory, name), found): ((String, String), Found)| {
        let unit = found.unit.unwrap_or_default();
        let (results, fixed): (Vec<_>, Vec<_>) =
            found.results.into_iter().map(|(index, (measured, fixed))| ((index, measured), fixed)).unzip();
        let pool = pool(&results.iter().map(|(_, measured)| *measured).collect::<Vec<_>>());
        let derived = name.strip_prefix(DERIVED).map(str::to_owned);
        let is_derived = derived.is_some();
        let name = derived.unwrap_or_else(|| name.strip_prefix(FITTED).unwrap_or(&name).to_owned());
        Quantity { theory, name, is_derived, unit, results, fixed, pool }
    };
    found.into_iter().map(quantity).collect()
}

/// Factor of an SI value stated in the unit `own` for a quantity shown in `shown`, see [`Unit::turning`].
pub(crate) fn turning(own: &str, shown: &str) -> f64 {
    let unit = |text: &str| Unit::parse(text).ok();
    unit(own).zip(unit(shown)).map_or(1.0, |(own, shown)| own.turning(&shown))
}

/// Unit of a quantity of a fit; empty if none is stated.
fn unit(fit: &[Fact], name: &str) -> String {
    fit.iter().find(|fact| fact.quantity.strip_prefix(UNIT) == Some(name)).and_then(text).unwrap_or_default()
}

/// Parameters that were held fixed for a quantity of a fit. In a fit of several records, a quantity of one of them ends in its
/// name in parentheses, as do the values of that record's own.
fn fixed(fit: &[Fact], quantity: &str) -> Vec<Fixed> {
    let record = quantity.find(" (").map_or("", |place| &quantity[place..]);
    let of_record = |fact: &Fact| {
        let stated = fact.quantity.strip_prefix(FIXED)?;
        let name = stated.strip_suffix(record).unwrap_or(stated);
        let (value, unit) = (number(fact)?, unit(fit, &fact.quantity));
        (!name.contains(" (")).then(|| Fixed { name: name.to_owned(), value, unit })
    };
    fit.iter().filter_map(of_record).collect()
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
