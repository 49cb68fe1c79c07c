//! Assignment of roles to the columns of a table.

use super::bodies::{forget_bodies, owners as owners_of_bodies};
use super::names::{is_frame, is_row_number};
use super::remark::{Remark, remarks};
use super::{decide, layout, numbers};
use crate::origin::{Reason, Role};
use crate::table::{Column, Table};
use std::collections::BTreeSet;
use units::order::sort;

/// Decides the roles of all columns, and numbers the bodies if several columns are clocks without named bodies. Returns
/// remarks on unclear roles. If several readings are possible, they are stored in [`Table::readings`], and the roles are
/// those of the first.
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

/// Assigns every column to the one of `clocks` against which it is measured.
pub(crate) fn measure_against(table: &mut Table, clocks: &[usize], reason: Reason) {
    let mut clocks = clocks.to_vec();
    sort(&mut clocks);
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

/// The column `clock`, columns of its name in other bodies, and the independent variables of the bodies without one.
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

/// One per column: the clock it belongs to. `clocks` ascend.
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
        // A counter beside a time is not a measured quantity.
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

/// Names the bodies of several clocks by numbers from 1.
fn number_bodies(table: &mut Table, clocks: &[usize]) {
    for column in &mut table.columns {
        let place = clocks.binary_search(&column.independent).ok();
        column.body = place.map(|place| (place + 1).to_string());
    }
}
