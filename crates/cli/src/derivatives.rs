//! `meniscus derivatives`: velocity and acceleration computed from a measured column.

use crate::arguments::{Derivatives, Difference};
use crate::data;
use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::terminal::output;
use analysis::csv::{self, Dialect};
use analysis::derivative::{self, Differentiation};
use analysis::smoothing::WIDEST;
use runner::names::Observe;
use runner::records::{Stated, columns_as_text};
use units::Unit;

/// Reads the data, differentiates the column and writes a table.
pub fn run(arguments: &Derivatives, terminal: Terminal) -> Result<(), Failure> {
    let data = data::read(
        &arguments.data,
        Stated { units: &arguments.unit, against: &arguments.against, dates: arguments.dates, ..Stated::default() },
    )?;
    let Observe { quantity, .. } = &arguments.observe;
    let column = data.column(&arguments.observe, &[])?;
    let table = &data.table;
    let values = &table.columns[column].values;
    let time = &table.columns[table.columns[column].independent];
    let times = &time.values;
    let how = match (arguments.smooth, arguments.stencil) {
        (Some(window), _) => Differentiation::Smooth { window, degree: arguments.degree },
        (None, Difference::Central) => Differentiation::Central,
        (None, Difference::Forward) => Differentiation::Forward,
        (None, Difference::Backward) => Differentiation::Backward,
    };
    if let (Differentiation::Smooth { window, degree }, false) = (how, how.is_possible()) {
        return Err(Failure::with_hint(
            format!("--smooth {window} --degree {degree}: no such smoothing polynomial"),
            format!("the window is an odd number of rows up to {WIDEST}, and the degree is from 2 to 7 and below it"),
        ));
    }
    let [level, first, second] = how.derivatives(times, values);
    if first.iter().all(|value| value.is_nan()) {
        return Err(Failure::with_hint(
            format!("{}: {quantity} has no two neighbours to be differentiated", data.name),
            "times must ascend; uneven ones can be smoothed, with --smooth 7",
        ));
    }
    let unit =
        |unit: &Option<Unit>, fallback: &str| unit.as_ref().map_or(fallback.to_owned(), |unit| unit.text.clone());
    let (of_time, of_level) = (unit(&time.unit, "s"), unit(&table.columns[column].unit, ""));
    // Derivatives of a column without a unit have none either.
    let head = |name: &str, order: usize| match derivative::unit(&of_level, &of_time, order).as_str() {
        "" => name.to_owned(),
        unit => format!("{name} [{unit}]"),
    };
    let independent = if time.name.is_empty() { "t" } else { &time.name };
    let heads = [
        format!("{independent} [{of_time}]"),
        head(quantity, 0),
        head(&format!("{quantity}'"), 1),
        head(&format!("{quantity}''"), 2),
    ];
    let dialect = if arguments.decimal_comma { Dialect::Semicolons } else { Dialect::Commas };
    let text = csv::write(&heads.each_ref().map(String::as_str), &[times, &level, &first, &second], dialect);
    output::deliver(arguments.output.as_deref(), std::slice::from_ref(&arguments.data), text.as_bytes())?;
    terminal.print(&columns_as_text(&data));
    for finding in &data.findings {
        terminal.note(finding);
    }
    Ok(())
}
