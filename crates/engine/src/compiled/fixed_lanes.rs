//! Runs of a fixed-step method side by side, in compiled code that makes each step for all of them.

use super::Compiled;
use super::lanes::{LanesLayout, Numbers};
use super::side_by_side::{LANES, SideBySide, Take};
use crate::{Routine, Stepper, rows_until};
use std::rc::Rc;

/// Number of steps in compiled code that take no longer than one in the interpreter, with what is done with their rows.
const FASTER: u64 = 8;

/// Runs of one model in compiled code.
#[derive(Debug)]
pub(crate) struct FixedLanes {
    /// Computes the registers of a run.
    stepper: Stepper,
    readings: Routine,
    code: Rc<dyn Compiled>,
    layout: LanesLayout,
    step: f64,
    /// Numbers of the row that is reached, of the last row that is taken, and of the last one.
    index: u64,
    taken: u64,
    all: u64,
    /// Number of runs.
    count: usize,
    numbers: Numbers,
    values: Vec<f64>,
    /// State of each run at the last row that is taken.
    last: Vec<Vec<f64>>,
}

impl FixedLanes {
    /// Runs with rows `step` apart (SI units), whose steps `code` makes.
    pub fn new(stepper: Stepper, readings: Routine, code: Rc<dyn Compiled>, layout: LanesLayout, step: f64) -> Self {
        let (numbers, values) = (Numbers::new(layout), vec![0.0; layout.values]);
        let [index, taken, all] = [0; 3];
        Self { stepper, readings, code, layout, step, index, taken, all, count: 0, numbers, values, last: Vec::new() }
    }

    /// State of a run.
    fn state(&self, run: usize) -> Vec<f64> {
        let steps = self.layout.steps;
        (steps.from()..steps.row(0)).map(|place| self.numbers.get(run, place)).collect()
    }

    /// Keeps the states if the last row that is taken is reached.
    fn keep_last(&mut self) {
        if self.index == self.taken {
            self.last = (0..self.count).map(|run| self.state(run)).collect();
        }
    }

    /// Makes so many steps, at most as many as there are rows in the block.
    fn step(&mut self, count: usize, take: Take) {
        let index = self.index as f64;
        (0..LANES).for_each(|run| self.numbers.set(run, self.layout.steps.first(), &[index]));
        self.numbers.run(&*self.code, count as u32);
        let takes = self.index < self.taken && self.layout.values > 0;
        for run in (0..self.count).filter(|_| takes) {
            for row in 0..count {
                self.numbers.copy(run, self.layout.row(row), &mut self.values);
                take(run, (self.index + row as u64 + 1) as f64 * self.step, &self.values);
            }
        }
        self.index += count as u64;
        self.keep_last();
    }
}

impl SideBySide for FixedLanes {
    fn begin(&mut self, runs: &[[Vec<f64>; 2]], until: f64, take: Take) {
        let Some(first) = runs.first() else { return };
        (self.index, self.count) = (0, runs.len());
        [self.taken, self.all] = rows_until(self.step, until);
        let (steps, readings) = (self.layout.steps, self.layout.readings());
        for run in 0..LANES {
            // Lanes without a run repeat the first one.
            let [parameters, initial] = runs.get(run).unwrap_or(first);
            self.stepper.begin(parameters.clone(), initial);
            self.readings.prepare(parameters, initial);
            self.numbers.set(run, 0, self.stepper.registers());
            self.numbers.set(run, readings, self.readings.registers());
            self.numbers.set(run, steps.spacing(), &[self.step, self.step]);
            self.numbers.set(run, steps.from(), initial);
            if run < self.count && !self.values.is_empty() {
                self.readings.evaluate(0.0, initial, &mut self.values);
                take(run, 0.0, &self.values);
            }
        }
        self.keep_last();
    }

    fn advance(&mut self, left: &mut u64, take: Take) -> bool {
        let work = (LANES as u64 * self.stepper.work_of_step() / FASTER).max(1);
        while self.index < self.all {
            if *left == 0 {
                return false;
            }
            let goal = if self.index < self.taken { self.taken } else { self.all };
            let count = (*left / work).clamp(1, self.layout.rows as u64).min(goal - self.index);
            self.step(count as usize, take);
            *left = left.saturating_sub(count * work);
        }
        true
    }

    fn end(&self, run: usize) -> Option<(f64, Vec<f64>)> {
        let finite = self.state(run).iter().all(|value| value.is_finite());
        finite.then(|| (self.taken as f64 * self.step, self.last[run].clone()))
    }
}
