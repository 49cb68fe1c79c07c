//! Runs in the rows of a table: one below the other, recognised by a clock that restarts, or named by a column of words.

use super::cells::COLUMNS;
use super::doubts::called;
use super::others::Others;
use crate::finding::Finding;
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
    let named = table.columns.iter().any(|column| column.body.is_some());
    if starts.len() < 2 || named {
        return;
    }
    let title = |run: usize| match titles.get(run) {
        Some(title) if titles.len() == starts.len() => title.clone(),
        _ => format!("Run {}", run + 1),
    };
    let parts: Vec<(String, Vec<usize>)> = starts
        .iter()
        .zip(&ends)
        .enumerate()
        .map(|(run, (start, end))| (title(run), (*start..*end).collect()))
        .collect();
    divide(table, &parts);
}

/// Divides the rows by a column of words that names the run of each: sensors that take turns, or boards in one log. `names`
/// are the names of all columns of the file, one per entry of `others`.
pub(super) fn by_words(table: &mut Table, others: &[Others], names: &[String], findings: &mut Vec<Finding>) {
    let clocks: Vec<usize> = table.clocks().collect();
    let [clock] = clocks[..] else { return };
    if table.columns.iter().any(|column| column.body.is_some()) {
        return;
    }
    let is_left_out = |index: &usize| table.columns.iter().all(|column| column.origin.number != index + 1);
    for (index, others) in others.iter().enumerate().filter(|(index, _)| is_left_out(index)) {
        let heading = names.get(index).map_or("", String::as_str);
        let parts = others.labels.runs(&table.columns[clock].values, heading);
        if parts.is_empty() {
            continue;
        }
        if divide(table, &parts) {
            let column = called(heading, index);
            findings.retain(|finding| *finding != Finding::WordColumn(column.clone()));
            let runs = parts.into_iter().map(|(name, _)| name).collect();
            findings.push(Finding::Labels { column, runs });
        }
        return;
    }
}

/// Moves the rows of each run beside each other, as bodies of these names. Returns false, without a change, if that would
/// need too much memory for gaps.
fn divide(table: &mut Table, parts: &[(String, Vec<usize>)]) -> bool {
    let (count, length) = (table.columns.len(), table.rows());
    let longest = parts.iter().map(|(_, rows)| rows.len()).max().unwrap_or(0);
    if parts.len() * count > COLUMNS || parts.len() * longest > 20 * length {
        return false;
    }
    let mut columns = Vec::with_capacity(parts.len() * count);
    for (run, (title, rows)) in parts.iter().enumerate() {
        for column in &table.columns {
            let mut values: Vec<f64> = rows.iter().map(|row| column.values[*row]).collect();
            values.resize(longest, f64::NAN);
            columns.push(Column {
                name: column.name.clone(),
                unit: column.unit.clone(),
                body: Some(title.clone()),
                independent: column.independent + run * count,
                values,
                origin: column.origin.clone(),
            });
        }
    }
    table.columns = columns;
    true
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
