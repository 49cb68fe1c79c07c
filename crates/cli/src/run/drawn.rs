//! `--draw F=push.csv`: replaces a curve drawn by the user of the document by one from a file.

use crate::arguments::assignments::Assignment;
use crate::arguments::settings::unknown;
use crate::arguments::variable::Stated;
use crate::data;
use crate::failure::Failure;
use document::Document;
use program::{Drawn, Interpolation, Table};
use std::path::Path;

/// Sets the curves from files with two columns, argument and value. The columns are in the units of the table unless
/// they have units of their own.
pub fn draw(document: &mut Document, assignments: &[Assignment]) -> Result<(), Failure> {
    let model = &mut document.program.model;
    let mut drawings = model.drawings();
    for assignment in assignments {
        let curves = model.tables.iter().filter_map(|table| Some((table, table.drawn.as_ref()?)));
        let found = curves.clone().zip(&mut drawings).find(|((table, _), _)| table.name == assignment.name);
        let Some(((table, drawn), values)) = found else {
            return Err(match curves.clone().next() {
                None => Failure::request(format!("--draw {}: nothing is drawn in the document", assignment.name)),
                Some(_) => unknown("drawn table", &assignment.name, curves.map(|(table, _)| table.name.as_str())),
            });
        };
        *values = read(table, drawn, Path::new(&assignment.value))?;
    }
    if let Some(drawn) = model.with_drawings(&drawings) {
        *model = drawn;
    }
    Ok(())
}

/// Values of the points of a curve, interpolated from a file. SI.
fn read(table: &Table, drawn: &Drawn, path: &Path) -> Result<Vec<f64>, Failure> {
    let measured = data::read(path, Stated::default())?;
    let what = format!("--draw {}: {}", table.name, measured.name);
    let [arguments, values] = measured.table.columns.as_slice() else {
        return Err(Failure::request(format!(
            "{what} has {} columns; it must have two, argument and value",
            measured.table.columns.len()
        )));
    };
    for (column, unit) in [(arguments, &table.argument_unit), (values, &table.unit)] {
        if column.unit.as_ref().is_some_and(|own| own.dimension != unit.dimension) {
            return Err(Failure::request(format!("{what}: the column `{}` must be in {unit}", column.name)));
        }
    }
    let pairs = arguments.si(Some(&table.argument_unit)).into_iter().zip(values.si(Some(&table.unit)));
    let points: Vec<[f64; 2]> = pairs.filter(|(x, y)| x.is_finite() && y.is_finite()).map(|(x, y)| [x, y]).collect();
    let Some(curve) = Interpolation::through_points(drawn.course, &points).filter(|_| points.len() > 1) else {
        return Err(Failure::request(format!("{what}: the arguments of at least two points must increase")));
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
    Err(Failure::request(out.trim_end()))
}
