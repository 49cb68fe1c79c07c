//! Runs of a logger in one file, each of which becomes a record.

use analysis::csv::{self, Dialect};
use analysis::table::{Column, Table};

/// Name and CSV text of each run of a table; empty unless there are several.
pub(crate) fn texts(table: &Table) -> Vec<(String, String)> {
    table.runs().into_iter().map(|(name, columns)| (name, written(table, &columns))).collect()
}

/// CSV text of some columns, without empty rows at the end.
fn written(table: &Table, columns: &[usize]) -> String {
    let columns: Vec<&Column> = columns.iter().filter_map(|index| table.columns.get(*index)).collect();
    let filled =
        |column: &&Column| column.values.iter().rposition(|value| value.is_finite()).map_or(0, |last| last + 1);
    let rows = columns.iter().map(filled).max().unwrap_or(0);
    let head = |column: &&Column| match (&column.unit, column.origin.unit.unknown()) {
        (Some(unit), _) => format!("{} [{}]", column.name, unit.text),
        (None, Some(unknown)) => format!("{} [{unknown}]", column.name),
        (None, None) => column.name.clone(),
    };
    let heads: Vec<String> = columns.iter().map(head).collect();
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let values: Vec<&[f64]> =
        columns.iter().map(|column| column.values.get(..rows).unwrap_or(&column.values)).collect();
    csv::write(&heads, &values, Dialect::Commas)
}
