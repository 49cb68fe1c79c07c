//! Runs that stand below each other, each under the same header and with a clock that begins again.

use super::cells::COLUMNS;
use crate::table::{Column, Table};

/// Puts runs beside each other as bodies, `Run 1` and `Run 2`, if the times begin again where the header stands again. `repeats`
/// are the rows before which it does, ascending.
pub(super) fn side_by_side(table: &mut Table, repeats: &[usize]) {
    let length = table.rows();
    let mut starts = vec![0];
    starts.extend(repeats.iter().copied().filter(|row| (1..length).contains(row)));
    let ends: Vec<usize> = starts.iter().skip(1).copied().chain([length]).collect();
    let longest = starts.iter().zip(&ends).map(|(start, end)| end - start).max().unwrap_or(0);
    let count = table.columns.len();
    let named = table.columns.iter().any(|column| column.body.is_some());
    // Runs of very different lengths would fill much memory with nothing.
    let too_many = starts.len() * count > COLUMNS || starts.len() * longest > 20 * length;
    let Some(times) = table.independent().last().map(|index| &table.columns[index].values) else { return };
    let begins_again = |row: &usize| {
        let (before, after) = times.split_at(*row);
        let last = before.iter().rev().find(|time| time.is_finite());
        let first = after.iter().find(|time| time.is_finite());
        last.zip(first).is_some_and(|(last, first)| first < last)
    };
    if starts.len() < 2 || named || too_many || !starts[1..].iter().all(begins_again) {
        return;
    }
    let mut columns = Vec::with_capacity(starts.len() * count);
    for (run, (start, end)) in starts.iter().zip(&ends).enumerate() {
        for column in &table.columns {
            let mut values = column.values[*start..*end].to_vec();
            values.resize(longest, f64::NAN);
            columns.push(Column {
                name: column.name.clone(),
                unit: column.unit.clone(),
                body: Some(format!("Run {}", run + 1)),
                independent: column.independent + run * count,
                values,
                origin: column.origin.clone(),
            });
        }
    }
    table.columns = columns;
}
