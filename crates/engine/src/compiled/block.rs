//! Compiled code with the numbers that it works on.

use super::layout::Layout;
use super::{Compiled, copy};
use std::rc::Rc;

/// Compiled code with its block of numbers, and the rows that it has computed in advance.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    code: Rc<dyn Compiled>,
    layout: Layout,
    numbers: Vec<f64>,
    ahead: Ahead,
}

/// Rows of the grid in the block, computed from the state and the registers in force.
#[derive(Clone, Copy, Debug, Default)]
struct Ahead {
    /// Index of the grid point at which the next of them begins.
    index: u64,
    /// Number of rows already taken.
    taken: usize,
    /// Number of rows.
    count: usize,
    /// Evaluations of the right-hand side for a row.
    stages: u64,
}

impl Block {
    pub fn new(code: Rc<dyn Compiled>, layout: Layout) -> Self {
        Self { code, layout, numbers: vec![0.0; layout.len()], ahead: Ahead::default() }
    }

    /// Takes over the registers after a change of parameters, held values or initial values.
    pub fn load(&mut self, registers: &[f64]) {
        self.numbers[..registers.len()].copy_from_slice(registers);
        self.forget();
    }

    /// Makes one step of a fixed-step method: from the state `from` at `time` (SI) over `size` (SI) to the state `to`.
    pub fn step(&mut self, time: f64, size: f64, from: &[f64], to: &mut [f64]) {
        self.forget();
        self.run([time, 1.0, size], from, 1);
        to.copy_from_slice(self.states(self.layout.row(0)));
    }

    /// Computes rows from grid point `index` on by a fixed-step method with `stages` evaluations of the right-hand side.
    pub fn begin(&mut self, stages: u64, index: u64, step: f64, state: &[f64]) {
        let rows = self.layout.rows as u32;
        let count = self.run([index as f64, step, step], state, rows);
        self.ahead = Ahead { index, taken: 0, count, stages };
    }

    /// Moves the state from grid point `index` to the next one, if that row is computed, and returns the number of evaluations
    /// of the right-hand side for it; 0 if there is none.
    #[inline(always)]
    pub fn take_row(&mut self, index: u64, state: &mut [f64]) -> u64 {
        let Ahead { index: next, taken, count, stages } = &mut self.ahead;
        if *next != index || *taken >= *count {
            return 0;
        }
        let first = self.layout.row(*taken);
        *next += 1;
        *taken += 1;
        copy(&self.numbers[first..first + self.layout.states], state);
        *stages
    }

    /// Discards the rows that are computed.
    pub fn forget(&mut self) {
        self.ahead = Ahead::default();
    }

    fn run(&mut self, settings: [f64; 3], from: &[f64], count: u32) -> usize {
        let layout = self.layout;
        self.numbers[layout.first()..layout.from()].copy_from_slice(&settings);
        self.numbers[layout.from()..layout.row(0)].copy_from_slice(from);
        (self.code.run(&mut self.numbers, count) as usize).min(layout.rows)
    }

    fn states(&self, first: usize) -> &[f64] {
        &self.numbers[first..first + self.layout.states]
    }
}
