//! States in the order in which code computes them.

use crate::sink::lists::ranges;
use crate::sink::rows::{Row, rows};
use engine::{Listing, Register};
use std::ops::Range;

/// The states of a listing: that of the model where lists are local variables, and that of their registers where lists are in the block.
#[derive(Debug)]
pub(crate) struct States {
    /// Index of each state in the model.
    pub index: Vec<usize>,
    /// Register of each state.
    pub registers: Vec<Register>,
    /// Register of the rate of each state.
    pub rates: Vec<Register>,
    /// For each state its rate if that is the constant 0 or -0, which all sums of its rates are then, too.
    pub still: Vec<Option<f64>>,
    /// All states. In a range the rates are all of them constant and equal, or none is.
    pub all: Vec<Range<usize>>,
    /// States whose rates are not constant.
    pub moving: Vec<Range<usize>>,
    /// All states, as they follow one another in the model.
    pub rows: Vec<Row>,
    /// States whose rates are not constant, as they follow one another in the model.
    pub moving_rows: Vec<Row>,
    /// Place of each state of the model.
    pub places: Vec<usize>,
}

impl States {
    /// `by_registers`: states in the order of their registers.
    pub fn of(listing: &Listing, by_registers: bool) -> Self {
        // Registers of states follow that of the independent variable.
        let place = |k: usize| if by_registers { listing.states[k] as usize - 1 } else { k };
        let places: Vec<usize> = (0..listing.states.len()).map(place).collect();
        let mut index = vec![0; places.len()];
        places.iter().enumerate().for_each(|(k, &place)| index[place] = k);
        let in_order = |list: &[Register]| -> Vec<Register> { index.iter().map(|&k| list[k]).collect() };
        let (registers, rates) = (in_order(&listing.states), in_order(&listing.rates));
        let still: Vec<Option<f64>> = index.iter().map(|&k| listing.still[k]).collect();
        let bits = |k: usize| still[k].map(f64::to_bits);
        let all = ranges(index.len(), |a, b| bits(a) == bits(b) && registers[a] + 1 == registers[b]);
        let moving = all.iter().filter(|range| still[range.start].is_none()).cloned().collect();
        let moving_rows = rows(&places, |k| still[k].is_none());
        let rows = rows(&places, |_| true);
        Self { index, registers, rates, still, all, moving, rows, moving_rows, places }
    }

    /// Ranges of all states for which a condition holds.
    pub fn all_that(&self, condition: impl Fn(usize) -> bool) -> Vec<Range<usize>> {
        let some = self.all.iter().flat_map(|range| {
            let parts = ranges(range.len(), |a, b| condition(range.start + a) == condition(range.start + b));
            parts.into_iter().map(|part| range.start + part.start..range.start + part.end)
        });
        some.filter(|range| condition(range.start)).collect()
    }
}
