//! Values of all seats.

use super::grid::Grid;
use super::hash::hash;
use super::seat::{BLOCK, Seat};
use std::collections::BTreeSet;
use units::split_mix::{GOLDEN, SplitMix64, scramble};

/// Maximum number of draws of a block that contains a seat equal to an earlier one. Few values can make it unavoidable.
const DRAWS: u32 = 64;

/// Draws of all assigned parameters of a document.
#[derive(Debug)]
pub(crate) struct Draws<'a> {
    /// Hash of assignment and name, and values, one per assigned parameter.
    parameters: Vec<(u64, &'a Grid)>,
}

impl<'a> Draws<'a> {
    pub fn new(assignment: &str, assigned: impl Iterator<Item = (&'a str, &'a Grid)>) -> Self {
        Self { parameters: assigned.map(|(name, grid)| (hash(&[assignment, name]), grid)).collect() }
    }

    /// Indices of the values of the eight seats of a block, one per parameter. `draw` counts the draws of this block.
    pub(super) fn block(&self, block: u32, draw: u32) -> Vec<Vec<u32>> {
        let mut seats = vec![Vec::with_capacity(self.parameters.len()); BLOCK as usize];
        for (key, grid) in &self.parameters {
            let place = u64::from(block) << 32 | u64::from(draw);
            let mut numbers = SplitMix64::new(scramble(key ^ scramble(place.wrapping_add(GOLDEN))));
            let mut below = |count: u32| ((u128::from(numbers.bits()) * u128::from(count)) >> 64) as u32;
            let mut eighths: Vec<u32> = (0..BLOCK).collect();
            for last in (1..BLOCK).rev() {
                eighths.swap(last as usize, below(last + 1) as usize);
            }
            for (seat, eighth) in seats.iter_mut().zip(eighths) {
                let values = grid.eighth(eighth);
                seat.push(values.start + below(values.end - values.start));
            }
        }
        seats
    }

    /// Indices of the values of the first seats, in whole blocks. Two seats are equal only where [`DRAWS`] draws did not avoid
    /// it.
    pub fn seats(&self, blocks: u32) -> Vec<Vec<u32>> {
        let mut taken = BTreeSet::new();
        let mut all = Vec::new();
        for block in 0..blocks {
            let is_new = |seats: &Vec<Vec<u32>>| seats.iter().all(|seat| !taken.contains(seat));
            let found = (0..DRAWS).map(|draw| self.block(block, draw)).find(is_new);
            let seats = found.unwrap_or_else(|| self.block(block, 0));
            taken.extend(seats.iter().cloned());
            all.extend(seats);
        }
        all
    }

    /// Indices of the values of one seat.
    pub fn seat(&self, seat: Seat) -> Vec<u32> {
        let (block, place) = seat.place();
        let mut seats = if seat.number() > Seat::MOST { self.block(block, 0) } else { self.seats(block + 1) };
        let from = seats.len() - BLOCK as usize;
        seats.swap_remove(from + place)
    }
}
