//! Lines of values, and the member selected in each family. The selection lasts as long as the page is open.

use super::lines::{Line, in_lines};
use program::{Model, Role};
use std::collections::BTreeMap;

/// Kind of value shown by a readout.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReadoutKind {
    /// Independent variable.
    Independent,
    /// State with this index.
    State(usize),
    /// Quantity with this index.
    Quantity(usize),
}

/// A family in a line, and the member shown.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Members {
    /// Name of the family with its primes, `x'`: the argument of [`crate::Values::choose_member`].
    pub name: String,
    /// Indices of the member shown; at least one.
    pub indices: Vec<Index>,
}

/// One index of the member shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Index {
    /// Present value.
    pub value: i64,
    /// Least value for the given preceding indices.
    pub least: i64,
    /// Greatest value for the given preceding indices.
    pub greatest: i64,
}

/// All lines, and the selected member of each family.
#[derive(Debug, Default)]
pub(crate) struct Lines {
    /// Lines of all readouts except the independent variable.
    pub(super) readouts: Vec<Line<ReadoutKind>>,
    /// Lines of the states, which are set individually.
    pub(super) states: Vec<Line<usize>>,
    /// Selected indices by the name of the family without primes: x[3] and x[3]' belong to one body.
    chosen: BTreeMap<String, Vec<i64>>,
}

impl Lines {
    pub fn of(model: &Model) -> Self {
        let states = || model.states.iter().enumerate().filter(|(_, state)| state.role == Role::Own);
        let quantities = model.quantities.iter().enumerate();
        let shown = quantities.filter(|(_, quantity)| !quantity.remembered && !quantity.hidden);
        let readouts = states()
            .map(|(index, state)| (ReadoutKind::State(index), state.name(), state.unit.text.clone()))
            .chain(shown.map(|(index, quantity)| {
                (ReadoutKind::Quantity(index), quantity.name.clone(), quantity.value.unit.text.clone())
            }));
        let states = states().map(|(index, state)| (index, state.name(), String::new()));
        Self { readouts: in_lines(readouts, true), states: in_lines(states, false), chosen: BTreeMap::new() }
    }

    /// Takes over the selection from another program.
    pub fn choose_as(&mut self, former: Self) {
        self.chosen = former.chosen;
    }

    /// Selects the member of a family whose index at position `place` is `value`, or the next one in the direction of the
    /// change. Returns false if there is none.
    pub fn choose(&mut self, family: &str, place: usize, value: i64) -> bool {
        let readout = self.readouts.iter().find(|line| line.is_family() && line.name() == family);
        let state = || self.states.iter().find(|line| line.is_family() && line.name() == family);
        let found = match readout {
            Some(line) => self.moved(line, place, value).map(|indices| (line.stem.clone(), indices)),
            None => state().and_then(|line| Some((line.stem.clone(), self.moved(line, place, value)?))),
        };
        let Some((stem, indices)) = found else { return false };
        self.chosen.insert(stem, indices);
        true
    }

    /// Selected indices for the family of a line; `None` if nothing has been selected.
    pub fn chosen_of<T>(&self, line: &Line<T>) -> Option<&[i64]> {
        self.chosen.get(&line.stem).map(Vec::as_slice)
    }

    /// Family of a line for display; `None` for a line with a single member.
    pub fn family<T>(&self, line: &Line<T>) -> Option<Members> {
        let member = line.member(self.chosen_of(line)).filter(|_| line.is_family())?;
        let index = |(place, &value): (usize, &i64)| {
            let (least, greatest) = line.range(&member.indices, place);
            Index { value, least, greatest }
        };
        Some(Members { name: line.name(), indices: member.indices.iter().enumerate().map(index).collect() })
    }

    /// Indices of the member shown after setting the index at position `place` of the present one to `value`.
    fn moved<T>(&self, line: &Line<T>, place: usize, value: i64) -> Option<Vec<i64>> {
        let member = line.member(self.chosen_of(line))?;
        line.moved(&member.indices, place, value)
    }
}
