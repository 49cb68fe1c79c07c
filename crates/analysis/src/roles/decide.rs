//! Decision which columns are independent variables, from names, units and numbers together.

use super::bodies::{self, is_in_time, may_be_time, preferred};
use super::layout::{Layout, is_complete, layout};
use super::names::{is_error, is_frame, is_row_number, is_time, tag};
use super::numbers::{are_constant, are_equal, are_even, are_monotone, are_parallel, are_stairs, count, increase};
use crate::origin::Reason;
use crate::table::Column;
use units::order::sort;

/// Upper bound of the readings shown to a user.
const SHOWN: usize = 4;

/// Independent variables of a table.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Decision {
    /// Indices of the independent variables, ascending.
    pub clocks: Vec<usize>,
    /// One per column: the index of its independent variable.
    pub owners: Vec<usize>,
    pub reason: Reason,
    /// If several readings are possible: the independent variables of each, ascending. Else empty.
    pub readings: Vec<Vec<usize>>,
}

/// Decides the independent variables. If several readings are possible, the other fields are those of the first.
pub(super) fn decide(columns: &[Column]) -> Decision {
    if columns.iter().any(|column| column.body.is_some()) {
        let clocks = bodies::clocks(columns);
        let reason = match clocks.first().and_then(|clock| columns.get(*clock)) {
            Some(clock) if tag(&clock.name).is_some() => Reason::Name,
            Some(clock) if is_in_time(clock) => Reason::Unit,
            _ => Reason::First,
        };
        return Decision { owners: bodies::owners(columns, &clocks), clocks, reason, readings: Vec::new() };
    }
    let named = columns.iter().any(|column| !column.name.is_empty());
    let table = Table { columns, errors: errors(columns), named, still: Vec::new() };
    let still = table.still();
    Table { still, ..table }.decide()
}

fn errors(columns: &[Column]) -> Vec<bool> {
    let names = columns.iter().map(|column| column.name.to_lowercase()).collect();
    columns.iter().map(|column| is_error(&column.name, &names)).collect()
}

struct Table<'a> {
    columns: &'a [Column],
    /// One per column: true if it is named as the error of another column.
    errors: Vec<bool>,
    /// True if any column has a name.
    named: bool,
    /// One per column: true if it cannot be an independent variable, because it stands still; empty if none can be ruled out.
    still: Vec<bool>,
}

impl Table<'_> {
    /// Columns that stand still: constants, and counters of the starts of a logger. Empty unless another column can be the
    /// independent variable of at least one more.
    fn still(&self) -> Vec<bool> {
        let is_time = |column: &Column| tag(&column.name).is_some() && may_be_time(column) || is_in_time(column);
        let is_still = |column: &Column| are_constant(&column.values) || !is_time(column) && are_stairs(&column.values);
        let still: Vec<bool> = self.columns.iter().map(is_still).collect();
        let moves = |index: &usize| !still[*index] && self.is(*index, &|column| column.filled() > 1);
        let moving: Vec<usize> = (0..still.len()).filter(moves).collect();
        let is_clock = |index: &usize| self.is_monotone(*index) || self.is(*index, &is_time);
        if moving.len() > 1 && moving.iter().any(is_clock) { still } else { Vec::new() }
    }

    fn is_still(&self, index: usize) -> bool {
        self.still.get(index).copied().unwrap_or(false)
    }

    fn decide(&self) -> Decision {
        let times = self.all(&|column| tag(&column.name).is_some() && may_be_time(column));
        let times: Vec<usize> = times.into_iter().filter(|time| !self.is_still(*time)).collect();
        let exact: Vec<usize> =
            times.iter().copied().filter(|time| self.is(*time, &|column| is_time(&column.name))).collect();
        if self.values(&times).is_empty()
            && let Some(counter) = self.counter(&times)
        {
            // A table of the times of events.
            return self.single(counter, Reason::Alone);
        }
        if let Some(primary) = preferred(self.columns, &exact).or(times.first().copied()) {
            return self.timed(primary, Reason::Name, exact.is_empty(), &times);
        }
        let first =
            (0..self.columns.len()).find(|index| !self.numbers_rows(*index) && !self.is_still(*index)).unwrap_or(0);
        let period = self.is(first, &|column| column.name == "T" && may_be_time(column));
        let by_unit = self.all(&|column| is_in_time(column) && column.name != "T");
        // Times that do not increase are values if the first column can be their independent variable.
        let is_clock = |index: &&usize| {
            let moves = !self.is_still(**index);
            moves && (**index == first || self.increases(**index) || !self.is_monotone(first))
        };
        if let Some(time) = by_unit.iter().find(is_clock).filter(|_| !period) {
            return self.timed(*time, Reason::Unit, true, &[]);
        }
        self.untimed(first)
    }

    /// Decision for a table with a time, by name or unit.
    fn timed(&self, primary: usize, reason: Reason, inexact: bool, times: &[usize]) -> Decision {
        let further: Vec<usize> = (0..self.columns.len())
            .filter(|index| {
                *index != primary
                    && !self.is_error(*index)
                    && !self.is_still(*index)
                    && self.is(*index, &|column| column.filled() > 1)
            })
            .filter(|index| {
                times.binary_search(index).is_ok()
                    || self.is(*index, &is_in_time)
                    || self.are_called_alike(primary, *index)
            })
            .collect();
        let same = |index: usize| self.are_called_alike(primary, index);
        let values = |clocks: &[usize]| self.values(clocks);
        let of_clock =
            |index: &usize| self.is(*index, &|column| column.origin.unit == crate::origin::UnitOrigin::Clock);
        let clocks: Vec<usize> = further
            .iter()
            .copied()
            .filter(|index| same(*index) || self.increases(*index) || (inexact && times.binary_search(index).is_ok()))
            .filter(|index| same(*index) || !of_clock(index))
            .collect();
        let with = |others: &[usize]| {
            let mut all: Vec<usize> = others.iter().copied().chain([primary]).collect();
            sort(&mut all);
            all
        };
        let named = self.layout(&with(&clocks)).filter(|layout| layout.by_names);
        // A column before several times may be their independent variable: lengths and periods.
        let mut before = values(&with(&further));
        before.retain(|value| !self.is_still(*value));
        let leads = before.iter().all(|value| *value < primary && further.iter().all(|time| value < time));
        if inexact
            && named.is_none()
            && leads
            && !further.is_empty()
            && let [first, ..] = before[..]
        {
            return self.asked(vec![vec![first], vec![primary]], reason);
        }
        let last = values(&with(&clocks)).last().copied();
        let followed = |index: &usize| named.is_some() || last.is_some_and(|value| value > *index);
        let mut clocks: Vec<usize> = clocks.iter().copied().filter(followed).collect();
        let equal = |index: &usize| self.equals(primary, *index);
        let parallel = |index: &usize| {
            equal(index) || !inexact && self.is(primary, &|one| self.is(*index, &|other| are_parallel(one, other)))
        };
        let beside = |index: &usize| parallel(index) && index.checked_sub(1) == Some(primary) && named.is_none();
        // Equal times in another unit, or from another zero, are not a separate clock.
        clocks.retain(|index| !beside(index));
        if clocks.is_empty() {
            return self.single(primary, reason);
        }
        let found = self.layout(&with(&clocks));
        let alone = clocks.iter().copied().chain(values(&with(&clocks))).all(|index| self.covers(primary, index));
        let together = found.filter(|layout| is_complete(self.columns, &layout.owners));
        let surely = |index: &usize| {
            let short = self.columns.get(*index).and_then(|column| tag(&column.name));
            same(*index) || equal(index) || short.is_some_and(|tag| inexact || tag.chars().count() <= 2)
        };
        match together {
            Some(layout) if !alone || layout.by_names || clocks.iter().all(surely) => {
                Decision { clocks: with(&clocks), owners: layout.owners, reason, readings: Vec::new() }
            }
            Some(_) => self.asked(vec![vec![primary], with(&clocks)], reason),
            None => self.asked(with(&clocks).into_iter().map(|clock| vec![clock]).collect(), reason),
        }
    }

    /// Decision for a table in which no name or unit indicates a time.
    fn untimed(&self, first: usize) -> Decision {
        if !self.named {
            return self.unnamed();
        }
        let counter = (0..first).find(|index| self.numbers_rows(*index));
        let others: Vec<usize> = (first..self.columns.len())
            .filter(|index| self.is(*index, &|column| column.filled() > 1) && !self.is_error(*index))
            .filter(|index| !self.is_still(*index))
            .collect();
        let Some(counter) = counter.filter(|_| others.len() > 1) else {
            let clocks =
                self.all(&|column| self.is(first, &|first| !first.name.is_empty() && first.name == column.name));
            return match self.layout(&clocks).filter(|_| clocks.len() > 1) {
                Some(Layout { owners, .. }) => Decision { clocks, owners, reason: Reason::First, readings: Vec::new() },
                None => self.single(if others.is_empty() { 0 } else { counter.unwrap_or(first) }, Reason::First),
            };
        };
        let monotone: Vec<usize> = others.iter().copied().filter(|index| self.is_monotone(*index)).collect();
        let unit =
            |index: usize| self.columns.get(index).and_then(|column| column.unit.as_ref()).map(|unit| unit.dimension);
        match monotone[..] {
            [] => self.single(counter, Reason::Alone),
            [one] if unit(one).is_some() && others.iter().all(|other| *other == one || unit(*other) != unit(one)) => {
                self.single(one, Reason::Increases)
            }
            [..] => {
                let each = [counter].into_iter().chain(monotone).take(SHOWN);
                self.asked(each.map(|clock| vec![clock]).collect(), Reason::First)
            }
        }
    }

    /// Decision for a table without names: the first column, unless others may be clocks by their numbers.
    fn unnamed(&self) -> Decision {
        let of = |index: usize| self.columns.get(index).map(|column| column.values.as_slice()).unwrap_or_default();
        if self.is_still(0)
            && let Some(clock) = (1..self.columns.len()).find(|index| increase(of(*index)))
        {
            return self.single(clock, Reason::Increases);
        }
        // Behind values that go up and down, the only column that increases, and evenly, is the clock.
        let mut rising = (1..self.columns.len()).filter(|index| increase(of(*index)));
        if !self.is_monotone(0)
            && let (Some(clock), None) = (rising.next(), rising.next())
            && are_even(of(clock))
        {
            return self.single(clock, Reason::Increases);
        }
        let last = self.columns.len().saturating_sub(1);
        let even: Vec<usize> = (1..last).filter(|index| are_even(of(*index))).collect();
        if count(of(0)) && are_even(of(0)) && even.first() == Some(&1) && !self.equals(0, 1) {
            return self.asked(vec![vec![0], vec![1]], Reason::First);
        }
        let clocks: Vec<usize> = [0].into_iter().chain(even.into_iter().filter(|index| *index > 1)).collect();
        match self.layout(&clocks).filter(|layout| clocks.len() > 1 && is_complete(self.columns, &layout.owners)) {
            Some(Layout { owners, .. })
                if clocks.iter().skip(1).all(|index| self.equals(0, *index))
                    || !(0..=last).all(|index| self.covers(0, index)) =>
            {
                Decision { clocks, owners, reason: Reason::First, readings: Vec::new() }
            }
            Some(_) if increase(of(0)) => self.asked(vec![vec![0], clocks], Reason::First),
            _ => self.single(0, Reason::First),
        }
    }

    /// All columns against one clock.
    fn single(&self, clock: usize, reason: Reason) -> Decision {
        Decision { clocks: vec![clock], owners: vec![clock; self.columns.len()], reason, readings: Vec::new() }
    }

    /// Several readings, each given by its independent variables.
    fn asked(&self, mut readings: Vec<Vec<usize>>, reason: Reason) -> Decision {
        readings.truncate(SHOWN);
        let clocks = readings.first().cloned().unwrap_or_default();
        let first = clocks.first().copied().unwrap_or(0);
        Decision { readings, ..self.single(first, reason) }
    }

    fn layout(&self, clocks: &[usize]) -> Option<Layout> {
        layout(self.columns, clocks, &self.values(clocks))
    }

    /// Columns with measured values beside these clocks, which ascend.
    fn values(&self, clocks: &[usize]) -> Vec<usize> {
        let first = clocks.first().copied().unwrap_or(0);
        (0..self.columns.len())
            .filter(|index| {
                !(clocks.binary_search(index).is_ok()
                    || self.numbers_rows(*index)
                    || self.counts_frames(*index) && *index < first)
            })
            .filter(|index| !self.is_error(*index) && self.is(*index, &|column| column.filled() > 0))
            .collect()
    }

    /// First column that numbers rows or frames, except those in `but`.
    fn counter(&self, but: &[usize]) -> Option<usize> {
        (0..self.columns.len())
            .find(|index| !but.contains(index) && (self.numbers_rows(*index) || self.counts_frames(*index)))
    }

    fn numbers_rows(&self, index: usize) -> bool {
        let called = |column: &Column| if column.name.is_empty() { self.named } else { is_row_number(&column.name) };
        self.is(index, &|column| called(column) && column.unit.is_none() && count(&column.values))
    }

    fn counts_frames(&self, index: usize) -> bool {
        self.is(index, &|column| is_frame(&column.name) && super::numbers::are_whole(&column.values))
    }

    fn is_error(&self, index: usize) -> bool {
        self.errors.get(index).copied().unwrap_or(false)
    }

    fn increases(&self, index: usize) -> bool {
        self.is(index, &|column| increase(&column.values))
    }

    fn is_monotone(&self, index: usize) -> bool {
        self.is(index, &|column| are_monotone(&column.values))
    }

    fn equals(&self, one: usize, other: usize) -> bool {
        self.is(one, &|one| self.is(other, &|other| are_equal(one, other)))
    }

    fn covers(&self, clock: usize, index: usize) -> bool {
        self.is(clock, &|clock| self.is(index, &|column| super::numbers::covers(&clock.values, &column.values)))
    }

    fn are_called_alike(&self, one: usize, other: usize) -> bool {
        self.is(one, &|one| self.is(other, &|other| !one.name.is_empty() && one.name == other.name))
    }

    fn all(&self, wanted: &dyn Fn(&Column) -> bool) -> Vec<usize> {
        (0..self.columns.len()).filter(|index| !self.is_error(*index) && self.is(*index, wanted)).collect()
    }

    fn is(&self, index: usize, wanted: &dyn Fn(&Column) -> bool) -> bool {
        self.columns.get(index).is_some_and(wanted)
    }
}
