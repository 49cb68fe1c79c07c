//! `meniscus derivatives`: velocity and acceleration of a measured column, made anew.

use crate::arguments::{Derivatives, Difference};
use crate::data::{self, Observe};
use crate::failure::Failure;
use crate::fitting::{print, write_file};
use crate::terminal::Terminal;
use analysis::csv::{self, Dialect};
use analysis::smoothing::savitzky_golay;
use analysis::stencil::{Stencil, differentiate};
use units::Unit;

/// Reads the data, differentiates the column and writes a table.
pub fn run(arguments: &Derivatives, terminal: Terminal) -> Result<(), Failure> {
    let data = data::read(&arguments.data)?;
    let Observe { quantity, .. } = &arguments.observe;
    let column = data.column(&arguments.observe, &[])?;
    let table = &data.table;
    let values = table.columns[column].values.clone();
    let time = &table.columns[table.columns[column].independent];
    let times = &time.values;
    let [level, first, second] = match arguments.smooth {
        Some(window) => {
            if window % 2 == 0 || arguments.degree < 2 || arguments.degree >= window || arguments.degree > 7 {
                return Err(Failure::with_hint(
                    format!("--smooth {window} --degree {}: no such smoothing polynomial", arguments.degree),
                    "the window is an odd number of rows, and the degree is from 2 to 7 and below it",
                ));
            }
            [0, 1, 2].map(|order| savitzky_golay(times, &values, window, arguments.degree, order))
        }
        None => {
            let (one, two) = match arguments.stencil {
                Difference::Central => (Stencil::Central, Stencil::FivePoint),
                Difference::Forward => (Stencil::Forward, Stencil::Second),
                Difference::Backward => (Stencil::Backward, Stencil::Second),
            };
            [values.clone(), differentiate(times, &values, one), differentiate(times, &values, two)]
        }
    };
    if first.iter().all(|value| value.is_nan()) {
        return Err(Failure::with_hint(
            format!("{}: {quantity} has no two neighbours to be differentiated", data.name),
            "times must ascend; uneven ones can be smoothed, with --smooth 7",
        ));
    }
    let unit =
        |unit: &Option<Unit>, fallback: &str| unit.as_ref().map_or(fallback.to_owned(), |unit| unit.text.clone());
    let (of_time, of_level) = (unit(&time.unit, "s"), unit(&table.columns[column].unit, ""));
    let head = |name: &str, power: u32| {
        let per = match power {
            0 => String::new(),
            1 => format!("/{of_time}"),
            _ => format!("/{of_time}^{power}"),
        };
        // Without a unit of its own nobody knows that of its derivatives.
        if of_level.is_empty() { name.to_owned() } else { format!("{name} [{of_level}{per}]") }
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
    match &arguments.output {
        Some(path) => write_file(path, std::slice::from_ref(&arguments.data), text.as_bytes())?,
        None => print(&text)?,
    }
    for finding in &data.findings {
        terminal.print(&format!("note: {}\n", finding.text(false)));
    }
    Ok(())
}
