//! Gives the columns of a table their roles.

use super::bodies::{forget_bodies, owners as owners_of_bodies};
use super::names::{is_frame, is_row_number};
use super::remark::{Remark, remarks};
use super::{decide, layout, numbers};
use crate::origin::{Reason, Role};
use crate::table::{Column, Table};
use std::collections::BTreeSet;

/// Decides the roles of all columns, and bodies where each has its own clock but no name; says what is not plain. Where several
/// readings hold, [`Table::readings`] has them, and the roles are those of the first.
pub(crate) fn assign(table: &mut Table) -> Vec<Remark> {
    let decision = decide::decide(&table.columns);
    let of_bodies = table.columns.iter().any(|column| column.body.is_some());
    take(table, &decision.clocks, &decision.owners, decision.reason);
    if decision.clocks.len() > 1 && !of_bodies {
        number_bodies(table, &decision.clocks);
    }
    let remarks = remarks(table, &decision);
    table.readings = decision.readings;
    remarks
}

/// Measures every column against the one of `clocks` that it belongs to.
pub(crate) fn measure_against(table: &mut Table, clocks: &[usize], reason: Reason) {
    let mut clocks = clocks.to_vec();
    clocks.sort_unstable();
    clocks.dedup();
    clocks.retain(|clock| *clock < table.columns.len());
    if clocks.is_empty() {
        return;
    }
    table.readings.clear();
    forget_bodies(table);
    let of_bodies = table.columns.iter().any(|column| column.body.is_some());
    if let ([clock], true) = (&clocks[..], of_bodies) {
        clocks = of_each_body(table, *clock);
    }
    let owners = owners(&table.columns, &clocks);
    take(table, &clocks, &owners, reason);
    if clocks.len() > 1 && !of_bodies {
        number_bodies(table, &clocks);
    }
}

/// A column, those of its name in other bodies, and what the bodies without one are measured against as read.
fn of_each_body(table: &Table, clock: usize) -> Vec<usize> {
    let Some(chosen) = table.columns.get(clock) else { return Vec::new() };
    let with_one: BTreeSet<&Option<String>> =
        table.columns.iter().filter(|column| column.name == chosen.name).map(|column| &column.body).collect();
    let is_clock = |index: usize, column: &Column| {
        let as_read = || !with_one.contains(&column.body) && matches!(column.origin.role, Role::Independent(_));
        index == clock || column.name == chosen.name || as_read()
    };
    let clocks = table.columns.iter().enumerate().filter(|(index, column)| is_clock(*index, column));
    clocks.map(|(index, _)| index).collect()
}

/// The one of `clocks`, which ascend, that each column belongs to.
pub(super) fn owners(columns: &[Column], clocks: &[usize]) -> Vec<usize> {
    let values: Vec<usize> = (0..columns.len()).filter(|index| clocks.binary_search(index).is_err()).collect();
    let of_bodies = columns.iter().any(|column| column.body.is_some());
    let found = layout::layout(columns, clocks, &values).filter(|_| !of_bodies);
    found.map_or_else(|| owners_of_bodies(columns, clocks), |layout| layout.owners)
}

fn take(table: &mut Table, clocks: &[usize], owners: &[usize], reason: Reason) {
    let first = clocks.first().copied().unwrap_or(0);
    let named = table.columns.iter().any(|column| !column.name.is_empty());
    for (index, (column, owner)) in table.columns.iter_mut().zip(owners).enumerate() {
        let is_clock = clocks.binary_search(&index).is_ok();
        // A counter beside a time is no measurement.
        let counts = named && (column.name.is_empty() || is_row_number(&column.name) || is_frame(&column.name));
        let counts = !is_clock && counts && index < first && numbers::are_whole(&column.values);
        column.independent = if is_clock || counts { index } else { *owner };
        column.origin.role = match (is_clock, counts) {
            (true, _) => Role::Independent(reason),
            (_, true) => Role::Counter,
            _ => Role::Measured,
        };
    }
}

/// Calls the bodies of several clocks by their numbers.
fn number_bodies(table: &mut Table, clocks: &[usize]) {
    for column in &mut table.columns {
        let place = clocks.binary_search(&column.independent).ok();
        column.body = place.map(|place| (place + 1).to_string());
    }
}
