//! Runs one below the other, recognised by a clock that restarts.

use super::cells::COLUMNS;
use crate::roles;
use crate::table::{Column, Table};
use units::Dimension;

/// Least number of rows of a run, so that a misplaced row does not begin one.
const SHORTEST: usize = 3;

/// Moves runs beside each other as bodies, `Run 1` and `Run 2`. A run begins where the header is repeated and the times
/// restart; without repeated headers, where the times restart at the first time. `repeats` are the rows after a repeated
/// header, ascending; `titles` are the names of the runs, empty without any.
pub(super) fn side_by_side(table: &mut Table, repeats: &[usize], titles: &[String]) {
    let length = table.rows();
    let found = if repeats.is_empty() { restarts(table) } else { Vec::new() };
    let repeats = if repeats.is_empty() { &found } else { repeats };
    let Some(times) = table.independent().last().map(|index| &table.columns[index].values) else { return };
    let begins_again = |row: &usize| {
        let (before, after) = times.split_at(*row);
        let last = before.iter().rev().find(|time| time.is_finite());
        let first = after.iter().find(|time| time.is_finite());
        last.zip(first).is_some_and(|(last, first)| first < last)
    };
    let mut starts = vec![0];
    starts.extend(repeats.iter().copied().filter(|row| (1..length).contains(row) && begins_again(row)));
    let ends: Vec<usize> = starts.iter().skip(1).copied().chain([length]).collect();
    let longest = starts.iter().zip(&ends).map(|(start, end)| end - start).max().unwrap_or(0);
    let count = table.columns.len();
    let named = table.columns.iter().any(|column| column.body.is_some());
    // Runs of very different lengths would need much memory for gaps.
    let too_many = starts.len() * count > COLUMNS || starts.len() * longest > 20 * length;
    if starts.len() < 2 || named || too_many {
        return;
    }
    let title = |run: usize| match titles.get(run) {
        Some(title) if titles.len() == starts.len() => title.clone(),
        _ => format!("Run {}", run + 1),
    };
    let mut columns = Vec::with_capacity(starts.len() * count);
    for (run, (start, end)) in starts.iter().zip(&ends).enumerate() {
        for column in &table.columns {
            let mut values = column.values[*start..*end].to_vec();
            values.resize(longest, f64::NAN);
            columns.push(Column {
                name: column.name.clone(),
                unit: column.unit.clone(),
                body: Some(title(run)),
                independent: column.independent + run * count,
                values,
                origin: column.origin.clone(),
            });
        }
    }
    table.columns = columns;
}

/// Rows at which the only clock of a table restarts at its first time, within the least step. Empty unless the times of
/// every run increase.
fn restarts(table: &Table) -> Vec<usize> {
    let independent: Vec<usize> = table.independent().collect();
    let [clock] = independent[..] else { return Vec::new() };
    let column = &table.columns[clock];
    let of_time = column.unit.as_ref().is_some_and(|unit| unit.dimension == Dimension::TIME);
    let times = &column.values;
    let [first, second, ..] = times[..] else { return Vec::new() };
    let step = second - first;
    if !(of_time || column.name.is_empty() || roles::is_time(&column.name)) || step.is_nan() || step <= 0.0 {
        return Vec::new();
    }
    let starts: Vec<usize> = (1..times.len()).filter(|row| times[*row] <= times[*row - 1]).collect();
    let ends = starts.iter().copied().skip(1).chain([times.len()]);
    let steps = times.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0);
    let least = steps.fold(step, f64::min);
    let again = |(start, end): (&usize, usize)| end - start >= SHORTEST && (times[*start] - first).abs() <= least;
    let all = times.iter().all(|time| time.is_finite()) && starts.first().is_some_and(|start| *start >= SHORTEST);
    if all && starts.iter().zip(ends).all(again) { starts } else { Vec::new() }
}
