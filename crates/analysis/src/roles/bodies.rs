//! Clocks of a table whose header names bodies or runs.

use super::names::{is_frame, is_row_number, is_time, tag};
use crate::origin::UnitOrigin;
use crate::table::{Column, Table};
use units::Dimension;

/// True if a column has a unit of time, or none.
pub(super) fn may_be_time(column: &Column) -> bool {
    column.unit.as_ref().is_none_or(|unit| unit.dimension == Dimension::TIME)
}

/// True if a column has a unit of time.
pub(super) fn is_in_time(column: &Column) -> bool {
    column.unit.as_ref().is_some_and(|unit| unit.dimension == Dimension::TIME)
}

/// Indices of the clocks, ascending.
pub(super) fn clocks(columns: &[Column]) -> Vec<usize> {
    let all = |wanted: &dyn Fn(&Column) -> bool| -> Vec<usize> {
        (0..columns.len()).filter(|index| columns.get(*index).is_some_and(wanted)).collect()
    };
    let exact = all(&|column| is_time(&column.name) && may_be_time(column));
    if !exact.is_empty() {
        return one_clock(columns, exact);
    }
    let tagged = all(&|column| tag(&column.name).is_some() && may_be_time(column));
    if !tagged.is_empty() {
        return tagged;
    }
    let Some(first) = columns.first() else { return Vec::new() };
    let counts = is_row_number(&first.name) || is_frame(&first.name) || (first.name == "T" && may_be_time(first));
    let time = columns.iter().position(|column| is_in_time(column) && column.name != "T").filter(|_| !counts);
    let name = time.and_then(|time| columns.get(time)).map_or(&first.name, |column| &column.name);
    if name.is_empty() { vec![time.unwrap_or(0)] } else { all(&|column| column.name == *name) }
}

/// Reduces several times with different names (`Time`, `t`) to one clock per body: a number is preferred to a time of day,
/// else the first is used. In other bodies the clock has the same name, or is the only time.
fn one_clock(columns: &[Column], times: Vec<usize>) -> Vec<usize> {
    let of = |index: &usize| columns.get(*index);
    let Some(chosen) = preferred(columns, &times).and_then(|chosen| of(&chosen)) else { return times };
    let alone = |column: &Column| {
        column.body.is_some()
            && times.iter().filter(|other| of(other).is_some_and(|other| other.body == column.body)).count() == 1
    };
    times
        .iter()
        .copied()
        .filter(|index| of(index).is_some_and(|column| column.name == chosen.name || alone(column)))
        .collect()
}

/// Preferred clock of several times: a number rather than a time of day, else the first.
pub(super) fn preferred(columns: &[Column], times: &[usize]) -> Option<usize> {
    let is_number = |index: &&usize| columns.get(**index).is_some_and(|column| column.origin.unit != UnitOrigin::Clock);
    times.iter().find(is_number).or(times.first()).copied()
}

/// One per column: the clock of its body, else the nearest one before it. `clocks` ascend.
pub(super) fn owners(columns: &[Column], clocks: &[usize]) -> Vec<usize> {
    let first = clocks.first().copied().unwrap_or(0);
    let owner = |(index, column): (usize, &Column)| {
        if clocks.binary_search(&index).is_ok() {
            return index;
        }
        // Runs may be in any order: each has its own clock.
        let same_body = |clock: &&usize| {
            column.body.is_some() && columns.get(**clock).is_some_and(|clock| clock.body == column.body)
        };
        let before = || clocks.iter().take(clocks.partition_point(|clock| *clock <= index)).rev();
        let own = before().find(same_body).or_else(|| clocks.iter().find(same_body));
        own.or_else(|| before().next()).copied().unwrap_or(first)
    };
    columns.iter().enumerate().map(owner).collect()
}

/// Removes bodies that are only numbered, as after the import of a table with several clocks without bodies.
pub(super) fn forget_bodies(table: &mut Table) {
    if table.columns.iter().all(|column| column.body.as_deref().is_none_or(is_number)) {
        table.columns.iter_mut().for_each(|column| column.body = None);
    }
}

/// True if the name of a body is a number.
pub(super) fn is_number(body: &str) -> bool {
    body.bytes().all(|byte| byte.is_ascii_digit())
}
