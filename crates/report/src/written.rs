//! Formatting of numbers with units for sentences and tables.

use analysis::fit::{Outcome, Task};
use units::Unit;
use units::number::{Group, Style, plain, with_unit};

/// Prefix with the record's name, `run 2: `; empty if there is only one record.
pub fn of_record(record: Option<usize>, task: &Task) -> String {
    let record = record.and_then(|record| task.records.get(record)).filter(|_| task.records.len() > 1);
    record.map_or_else(String::new, |record| [&record.name, ": "].concat())
}

/// A value, given in SI, with five digits and a unit in which it needs no power of ten.
pub fn quantity(si: f64, unit: &Unit, style: Style) -> String {
    let unit = unit.for_size(unit.from_si(si).abs());
    with_unit(&plain(unit.from_si(si), 5, style), &unit)
}

/// Converts a difference from SI to a unit, without the zero of the unit.
pub fn size(unit: &Unit, si: f64) -> f64 {
    unit.from_si(si) - unit.from_si(0.0)
}

/// A difference, given in SI, with three digits and a suitable unit.
pub fn difference(si: f64, shown: &Unit, style: Style) -> String {
    Group::of_residuals(shown, &[si], 3, style).quantity(si).replace(' ', "\u{a0}")
}

/// Common number format of the residuals of all observations of one name, inside and outside the fitted part.
pub fn sizes(outcome: &Outcome, name: &str, style: Style) -> Group {
    let own = || outcome.observations.iter().filter(|one| one.name == name);
    let sizes: Vec<f64> = own().flat_map(|one| [Some(one.rmse), one.outside.map(|part| part.rmse)]).flatten().collect();
    let unit = own().next().map_or_else(Unit::dimensionless, |one| one.unit.clone());
    Group::of_residuals(&unit, &sizes, 3, style)
}
