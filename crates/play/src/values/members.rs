//! What stands in lines, and the member of each family that the reader has chosen. The choice lasts as long as the page is open.

use super::lines::{Line, in_lines};
use program::{Model, Role};
use std::collections::BTreeMap;

/// What a readout shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReadoutKind {
    /// The independent variable.
    Independent,
    /// State of this number.
    State(usize),
    /// Quantity of this number.
    Quantity(usize),
}

/// A family in a line, and which of its members is shown.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Members {
    /// The family with its primes, `x'`: what [`Play::choose_member`] takes.
    pub name: String,
    /// The indices of the member shown; one or more.
    pub indices: Vec<Index>,
}

/// An index of the member shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Index {
    /// Its value.
    pub value: i64,
    /// The least that it can be beside the indices before it.
    pub least: i64,
    /// The greatest.
    pub greatest: i64,
}

/// What stands in lines, and which member of a family is shown in its line.
#[derive(Debug, Default)]
pub(crate) struct Lines {
    /// Of everything that can be read off, without the independent variable.
    pub readouts: Vec<Line<ReadoutKind>>,
    /// Of the states, which are set one by one.
    pub states: Vec<Line<usize>>,
    /// The indices chosen, by the name of the family without primes: x[3] and x[3]' belong to one body.
    pub chosen: BTreeMap<String, Vec<i64>>,
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

    /// Takes over what was chosen in another program.
    pub fn choose_as(&mut self, former: Self) {
        self.chosen = former.chosen;
    }

    /// The indices that were chosen for the family of a line.
    pub fn chosen_of<T>(&self, line: &Line<T>) -> Option<&[i64]> {
        self.chosen.get(&line.stem).map(Vec::as_slice)
    }

    /// The family of a line as the page shows it; `None` where there is nothing to choose.
    pub fn family<T>(&self, line: &Line<T>) -> Option<Members> {
        let member = line.member(self.chosen_of(line)).filter(|_| line.is_family())?;
        let index = |(place, &value): (usize, &i64)| {
            let (least, greatest) = line.range(&member.indices, place);
            Index { value, least, greatest }
        };
        Some(Members { name: line.name(), indices: member.indices.iter().enumerate().map(index).collect() })
    }

    /// The indices of the member that is shown when one index of the present one is given this value.
    pub fn moved<T>(&self, line: &Line<T>, place: usize, value: i64) -> Option<Vec<i64>> {
        let member = line.member(self.chosen_of(line))?;
        line.moved(&member.indices, place, value)
    }
}
