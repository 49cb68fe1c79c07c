//! Assignment of columns to clocks in a table with several.

use super::names::{has_tag, tag};
use super::numbers::covers;
use crate::table::Column;

/// Assignment of columns to clocks.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Layout {
    /// One per column: the index of its clock; a clock belongs to itself.
    pub owners: Vec<usize>,
    /// True if the names of the columns decided it: `tA, tB, yA, yB`.
    pub by_names: bool,
}

/// Assigns the columns in `values` to clocks; `None` if a clock would have no column, or the assignment is ambiguous.
/// `clocks` ascend.
pub(super) fn layout(columns: &[Column], clocks: &[usize], values: &[usize]) -> Option<Layout> {
    let (names, place) = (by_names(columns, clocks, values), by_place(clocks, values));
    // In `t, y1, y2, t2` a clock has no tag, so that positions decide.
    let bare =
        |clock: &usize| columns.get(*clock).is_some_and(|clock| tag(&clock.name).is_some_and(|tag| tag.is_empty()));
    let (found, by_names) = match (names, place) {
        (Some(names), Some(place)) if clocks.iter().any(bare) && names != place => (place, false),
        (Some(names), _) => (names, true),
        (None, place) => (place?, false),
    };
    let mut before = *clocks.first()?;
    let mut owners = Vec::with_capacity(columns.len());
    for index in 0..columns.len() {
        before = if clocks.binary_search(&index).is_ok() { index } else { before };
        owners.push(before);
    }
    for (value, clock) in values.iter().zip(found) {
        if let Some(owner) = owners.get_mut(*value) {
            *owner = clock;
        }
    }
    Some(Layout { owners, by_names })
}

/// Assignment by common tags in names of clocks and columns. A column without a tag belongs to the clock without one.
fn by_names(columns: &[Column], clocks: &[usize], values: &[usize]) -> Option<Vec<usize>> {
    // Upper bound of the number of clocks, because each name is compared with all of them.
    const MOST: usize = 100;
    if clocks.len() > MOST {
        return None;
    }
    let tags: Vec<String> = clocks.iter().map(|clock| tag(&columns.get(*clock)?.name)).collect::<Option<_>>()?;
    let different = tags.iter().enumerate().all(|(place, tag)| !tags.iter().take(place).any(|other| other == tag));
    let owner = |value: &usize| {
        let name = &columns.get(*value)?.name;
        let mut tagged =
            (0..clocks.len()).filter(|place| tags.get(*place).is_some_and(|tag| !tag.is_empty() && has_tag(name, tag)));
        let (first, second) = (tagged.next(), tagged.next());
        let place = first.or_else(|| tags.iter().position(String::is_empty))?;
        second.is_none().then(|| clocks.get(place).copied()).flatten()
    };
    let found: Vec<usize> = values.iter().map(owner).collect::<Option<_>>()?;
    (different && clocks.iter().all(|clock| found.contains(clock))).then_some(found)
}

/// Assignment by position: each clock before its columns, or all clocks before as many columns.
fn by_place(clocks: &[usize], values: &[usize]) -> Option<Vec<usize>> {
    let (first, last) = (*clocks.first()?, *clocks.last()?);
    let before = |value: &usize| {
        let after = clocks.partition_point(|clock| clock < value);
        after.checked_sub(1).and_then(|place| clocks.get(place)).copied().unwrap_or(first)
    };
    let found: Vec<usize> = values.iter().map(before).collect();
    if clocks.iter().all(|clock| found.binary_search(clock).is_ok()) {
        return Some(found);
    }
    let in_pairs = clocks.len() == values.len() && values.iter().all(|value| *value > last);
    in_pairs.then(|| clocks.to_vec())
}

/// True if every column has a time for each of its values.
pub(super) fn is_complete(columns: &[Column], owners: &[usize]) -> bool {
    columns
        .iter()
        .zip(owners)
        .all(|(column, owner)| columns.get(*owner).is_some_and(|clock| covers(&clock.values, &column.values)))
}
