//! Units of columns for which the files state none: decided once, for all theories together.

use super::fitted::Theory;
use super::settings::FitSettings;
use crate::quoted::quoted;
use crate::records::Measured;
use crate::refusal::{Refusal, listed};
use crate::values::Reader;
use analysis::assumed_unit::{AssumedUnit, Expectation, assumed_unit};
use analysis::origin::UnitOrigin;
use program::Compiled;
use std::collections::BTreeSet;
use units::Unit;

/// Sets the units of all observed columns, and of their times, for which the files state none. The numbers of a quantity
/// have the same unit in all these files, and for all theories.
///
/// # Errors
/// The theories declare different units, and the numbers do not decide between them.
pub fn settle_units(theories: &mut [Theory], data: &mut [Measured], settings: &FitSettings) -> Result<(), Refusal> {
    let found: Vec<Vec<usize>> = data.iter().map(|one| columns(one, settings)).collect();
    let clocks = |one: &Measured, columns: &[usize]| -> BTreeSet<usize> {
        columns.iter().filter_map(|column| one.table.columns.get(*column)).map(|column| column.independent).collect()
    };
    let times: Vec<BTreeSet<usize>> = data.iter().zip(&found).map(|(one, columns)| clocks(one, columns)).collect();
    let declared =
        |theory: &Theory| Expectation { declared: theory.document.program.model.independent.unit.clone(), ratio: None };
    let declared: Vec<Expectation> = theories.iter().map(declared).collect();
    for (file, clocks) in times.iter().enumerate() {
        for clock in clocks {
            settle(data, &[(file, *clock)], &declared)?;
        }
    }
    for (place, observe) in settings.observe.iter().enumerate() {
        let columns = found.iter().enumerate().filter_map(|(file, columns)| Some((file, *columns.get(place)?)));
        let open: Vec<(usize, usize)> = columns.filter(|(file, column)| lacks_unit(&data[*file], *column)).collect();
        let mut expectations = Vec::new();
        for theory in theories.iter_mut() {
            let mut reader = Reader { model: &mut theory.document.program.model };
            // An expression that the theory does not have is refused with its task.
            let Ok(observed) = reader.expression("--observe", &observe.quantity) else { continue };
            expectations.extend(open.iter().map(|at| expectation(theory, &observed, data, *at)));
        }
        settle(data, &open, &expectations)?;
    }
    Ok(())
}

/// Columns of the observed quantities; empty if one cannot be found, which is refused with the task.
fn columns(measured: &Measured, settings: &FitSettings) -> Vec<usize> {
    let mut found = Vec::new();
    for observe in &settings.observe {
        match measured.column(observe, &found) {
            Ok(column) => found.push(column),
            Err(_) => return Vec::new(),
        }
    }
    found
}

/// True if neither the file nor the user states a unit, nor something that may be one.
fn lacks_unit(measured: &Measured, column: usize) -> bool {
    let column = measured.table.columns.get(column).filter(|column| column.unit.is_none());
    column.is_some_and(|column| !matches!(column.origin.unit, UnitOrigin::Unknown(_)))
}

fn expectation(theory: &Theory, observed: &Compiled, data: &[Measured], (file, column): (usize, usize)) -> Expectation {
    let (model, table) = (&theory.document.program.model, &data[file].table);
    let own = &table.columns[column];
    let times = table.columns.get(own.independent).map(|times| times.si(Some(&model.independent.unit)));
    Expectation::new(model, observed, &times.unwrap_or_default(), &own.values)
}

/// Sets the unit of these columns, each given by its file and its index.
fn settle(data: &mut [Measured], columns: &[(usize, usize)], theories: &[Expectation]) -> Result<(), Refusal> {
    let open = columns.iter().filter(|(file, column)| lacks_unit(&data[*file], *column));
    let open: Vec<(usize, usize)> = open.copied().collect();
    let Some(&(file, column)) = open.first() else { return Ok(()) };
    match assumed_unit(None, theories) {
        Some(AssumedUnit::Unit(unit)) if unit.text.is_empty() => {}
        Some(AssumedUnit::Unit(unit)) => {
            for (file, column) in open {
                let column = &mut data[file].table.columns[column];
                column.unit = Some(unit.clone());
                column.origin.unit = UnitOrigin::Assumed;
            }
        }
        Some(AssumedUnit::Open(units)) => return Err(asked(&data[file], column, &units)),
        None => {}
    }
    Ok(())
}

/// Question for the unit of a column.
fn asked(measured: &Measured, column: usize, units: &[Unit]) -> Refusal {
    let (name, called) = (quoted(measured.table.typed(column)), measured.called(column));
    let declared = listed(units.iter().map(|unit| if unit.text.is_empty() { "a pure number" } else { &unit.text }));
    let options: Vec<String> = units.iter().map(|unit| format!("--unit {name}={}", quoted(&unit.text))).collect();
    Refusal::with_hint(
        format!(
            "{} states no unit of {called}, and the theories have it in {declared}: residuals in different units cannot be compared",
            measured.name
        ),
        format!("state it: {}", options.join(" or ")),
    )
}
