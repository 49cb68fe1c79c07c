//! `--draw F=push.csv`: replaces a curve drawn by the user of the document by one from a file.

use crate::records::Measured;
use crate::refusal::Refusal;
use document::Document;
use engine::Setup;
use program::{Drawn, Interpolation, Table};

/// Replaces a table that readers of the document draw by measured data with two columns, argument and value. The columns are in
/// the units of the table unless they have units of their own. `data` reads them once the table is known.
///
/// # Errors
/// A name that is no such table, data that are no curve in its range, and those of `data`.
pub fn draw<E: From<Refusal>>(
    document: &mut Document,
    setup: &mut Setup,
    name: &str,
    data: impl FnOnce() -> Result<Measured, E>,
) -> Result<(), E> {
    let model = &mut document.program.model;
    let mut drawings = model.drawings();
    let known = model.tables.iter().filter_map(|table| Some((table, table.drawn.as_ref()?)));
    let found = known.clone().zip(&mut drawings).find(|((table, _), _)| table.name == name);
    let Some(((table, drawn), values)) = found else {
        let refusal = match known.clone().next() {
            None => Refusal::request(format!("--draw {name}: nothing is drawn in the document")),
            Some(_) => Refusal::unknown("drawn table", name, known.map(|(table, _)| table.name.as_str())),
        };
        return Err(refusal.into());
    };
    *values = read(table, drawn, &data()?)?;
    if let Some(drawn) = model.with_drawings(&drawings) {
        *model = drawn;
    }
    setup.drawings = model.drawings();
    Ok(())
}

/// Values of the points of a curve, interpolated from measured data. SI.
fn read(table: &Table, drawn: &Drawn, measured: &Measured) -> Result<Vec<f64>, Refusal> {
    let what = format!("--draw {}: {}", table.name, measured.name);
    let [arguments, values] = measured.table.columns.as_slice() else {
        return Err(Refusal::request(format!(
            "{what} has {} columns; it must have two, argument and value",
            measured.table.columns.len()
        )));
    };
    for (column, unit) in [(arguments, &table.argument_unit), (values, &table.unit)] {
        if column.unit.as_ref().is_some_and(|own| own.dimension != unit.dimension) {
            return Err(Refusal::request(format!("{what}: the column `{}` must be in {unit}", column.name)));
        }
    }
    let pairs = arguments.si(Some(&table.argument_unit)).into_iter().zip(values.si(Some(&table.unit)));
    let points: Vec<[f64; 2]> = pairs.filter(|(x, y)| x.is_finite() && y.is_finite()).map(|(x, y)| [x, y]).collect();
    let Some(curve) = Interpolation::through_points(drawn.course, &points).filter(|_| points.len() > 1) else {
        return Err(Refusal::request(format!("{what}: the arguments of at least two points must increase")));
    };
    let at = |point: usize| {
        let x = drawn.argument(point);
        curve.value(x, curve.piece(x))
    };
    let drawn_values: Vec<f64> = (0..Drawn::POINTS).map(at).collect();
    if drawn.takes(&drawn_values) {
        return Ok(drawn_values);
    }
    let [low, high] = [drawn.low, drawn.high].map(|value| table.unit.from_si(value));
    let out = format!("{what} leaves the range from {low} to {high} {}", table.unit);
    Err(Refusal::request(out.trim_end()))
}
