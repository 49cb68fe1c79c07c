//! Lookup of the columns that the user names, and choice of the independent variable.

use crate::names::{Assignment, Observe};
use crate::quoted::quoted;
use crate::refusal::{Refusal, listed};
use analysis::import::DateOrder;
use analysis::lookup::LookupError;
use analysis::origin::Reason;
use analysis::roles::Remark;
use analysis::table::Table;
use units::{Dimension, Language};

/// Statements of the user or a document about the columns of a file.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stated<'a> {
    /// Units of columns.
    pub units: &'a [Assignment],
    /// Independent variables, as typed.
    pub against: &'a [String],
    /// Order of day and month in dates, where the numbers do not show it.
    pub dates: Option<DateOrder>,
    /// Name and dimension of the document's independent variable; `None` without a document.
    pub variable: Option<(&'a str, Dimension)>,
    /// Observed quantities.
    pub observed: &'a [Observe],
}

/// Sets the independent variable from `--against`, or else to the one that suits the document. Returns a remark about
/// the choice.
pub fn choose(file: &str, table: &mut Table, stated: Stated) -> Result<Option<Remark>, Refusal> {
    if !stated.against.is_empty() {
        let named = |name: &String| find(file, table, name, &|name| format!("--against {name}"));
        let clocks: Vec<usize> = stated.against.iter().map(named).collect::<Result<_, _>>()?;
        return Ok(Some(table.against(&clocks, Reason::Person)));
    }
    let Some((name, dimension)) = stated.variable else { return Ok(None) };
    let column = |observe: &Observe| table.column(observe.column.as_deref().unwrap_or(&observe.quantity)).ok();
    let observed: Vec<usize> = stated.observed.iter().filter_map(column).collect();
    Ok(table.suit(name, dimension, &observed))
}

/// Index of the column of this name or number. `option` formats the option that selects a column, for hints.
pub fn find(file: &str, table: &Table, which: &str, option: &dyn Fn(&str) -> String) -> Result<usize, Refusal> {
    table.column(which).map_err(|error| match error {
        LookupError::Unknown => {
            let columns = 0..table.columns.len();
            let gaps = columns.clone().any(|index| table.number(index) != index + 1);
            let label = |index: usize| match table.columns.get(index) {
                Some(column) if gaps && !column.name.is_empty() => {
                    format!("{} (number {})", table.label(index), table.number(index))
                }
                _ => table.label(index),
            };
            Refusal::with_hint(
                format!("{file} has no column `{which}`"),
                format!("its columns are {}; choose one with {}", listed(columns.map(label)), option("COLUMN")),
            )
        }
        LookupError::Several(found) => {
            let described = |index: &usize| format!("column {}, named `{}`", table.number(*index), table.label(*index));
            let described: Vec<String> = found.iter().map(described).collect();
            let typed: Vec<String> = found.iter().map(|index| option(&quoted(table.typed(*index)))).collect();
            Refusal::with_hint(
                format!("{file}: `{which}` can be {}", described.join(", or ")),
                format!("write {}", typed.join(" or ")),
            )
        }
    })
}

/// Hint with the options that choose each of the possible independent variables of a table.
pub fn choices(table: &Table) -> String {
    let option = |reading: &Vec<usize>| {
        let typed: Vec<String> = reading.iter().map(|index| table.typed(*index)).collect();
        let words = table.reading_in_words(reading, Language::English);
        format!("--against {} ({words})", quoted(typed.join(",")))
    };
    let options: Vec<String> = table.readings.iter().map(option).collect();
    format!("write {}", options.join(", or "))
}
