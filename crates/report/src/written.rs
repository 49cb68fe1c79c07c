//! Numbers with units as a sentence or a table has them.

use analysis::fit::Outcome;
use units::Unit;
use units::number::{Group, Style, plain, with_unit};

/// An SI value with five digits and a unit in which it needs no power of ten.
pub fn quantity(si: f64, unit: &Unit, style: Style) -> String {
    let unit = unit.for_size(unit.from_si(si).abs());
    with_unit(&plain(unit.from_si(si), 5, style), &unit)
}

/// How the residuals of all observations of the same name are written, in one unit: in the fitted part and outside.
pub fn sizes(outcome: &Outcome, name: &str, style: Style) -> Group {
    let own = || outcome.observations.iter().filter(|one| one.name == name);
    let sizes: Vec<f64> = own().flat_map(|one| [Some(one.rmse), one.outside.map(|part| part.rmse)]).flatten().collect();
    let unit = own().next().map_or_else(Unit::dimensionless, |one| one.unit.clone());
    Group::of_residuals(&unit, &sizes, 3, style)
}
