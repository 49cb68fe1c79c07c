//! Runs of a fixed-step method side by side, in compiled code that makes each step for all of them.

use super::Compiled;
use super::layout::Layout;
use super::listing::{Formulas, Listing};
use super::side_by_side::{LANES, SideBySide, Take};
use crate::{Routine, Setup, Stepper, rows_until};
use program::{Method, Model, NodeId};
use std::rc::Rc;

/// Number of runs whose numbers stand together.
const TOGETHER: usize = 2;

/// Maximum number of steps that are made at once.
const MOST_ROWS: usize = 256;

/// Maximum number of values in the rows of these steps, for a run.
const MOST_VALUES: usize = 512;

/// Number of steps in compiled code that take no longer than one in the interpreter, with what is done with their rows.
const FASTER: u64 = 8;

/// Steps of a fixed-step method for [`LANES`] runs, and what is read at each row.
#[derive(Clone, Debug, PartialEq)]
pub struct LanesListing {
    /// The steps. Its own layout is that of a single run.
    pub steps: Listing,
    /// Formulas that are read at each row; their interpolations follow those of the steps in the list that both share.
    pub readings: Formulas,
    /// The block of a pair of runs.
    pub layout: LanesLayout,
}

/// Indices into the numbers of a pair of runs. At each place stand two numbers, one for each run; the numbers of one pair follow
/// those of the pair before. SI units; states are in the order of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LanesLayout {
    /// Registers, settings and states of the steps; states are replaced by those after the last step.
    pub steps: Layout,
    /// Number of registers of what is read.
    registers: usize,
    /// Number of values that are read at a row.
    pub values: usize,
    /// Maximum number of rows.
    rows: usize,
}

impl LanesLayout {
    fn new(steps: Layout, readings: &Formulas) -> Self {
        let values = readings.roots.len();
        let rows = (MOST_VALUES / values.max(1)).clamp(1, MOST_ROWS);
        Self { steps, registers: readings.registers, values, rows }
    }

    /// First register of what is read.
    pub const fn readings(self) -> usize {
        self.steps.row(0)
    }

    /// First value at row `k`: the one after step `k`.
    pub const fn row(self, k: usize) -> usize {
        self.readings() + self.registers + k * self.values
    }

    /// Number of places.
    pub const fn places(self) -> usize {
        self.row(self.rows)
    }
}

/// Runs of one model in compiled code.
#[derive(Debug)]
struct Lanes {
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
    numbers: Vec<f64>,
    values: Vec<f64>,
    /// State of each run at the last row that is taken.
    last: Vec<Vec<f64>>,
}

/// Prepares runs of `model` with this setup but other parameters and without presses; `nodes` are read at each row. `compile` makes
/// their code. `None` if the runs must be made one by one: steps of other methods and those that can end early are not made side by
/// side, nor is what `compile` has no code for.
pub fn side_by_side(
    model: &Model,
    setup: &Setup,
    nodes: &[NodeId],
    compile: impl FnOnce(&LanesListing) -> Option<Rc<dyn Compiled>>,
) -> Option<Box<dyn SideBySide>> {
    if !setup.presses.is_empty() || setup.method == Method::DormandPrince {
        return None;
    }
    let drawn = model.with_drawings(&setup.drawings);
    let model = drawn.as_ref().unwrap_or(model);
    let stepper = Stepper::new(model, setup).ok()?;
    let mut steps = stepper.listing().ok().filter(|_| stepper.is_smooth())?;
    let readings = Routine::compile(model, nodes);
    let formulas = readings.formulas(&mut steps.interpolations)?;
    let layout = LanesLayout::new(steps.layout, &formulas);
    let code = compile(&LanesListing { steps, readings: formulas, layout })?;
    let (numbers, values) = (vec![0.0; LANES * layout.places()], vec![0.0; nodes.len()]);
    let (step, [index, taken, all]) = (setup.step, [0; 3]);
    let lanes =
        Lanes { stepper, readings, code, layout, step, index, taken, all, count: 0, numbers, values, last: Vec::new() };
    Some(Box::new(lanes))
}

impl Lanes {
    /// Index of a number of a run.
    fn at(&self, run: usize, place: usize) -> usize {
        (run / TOGETHER * self.layout.places() + place) * TOGETHER + run % TOGETHER
    }

    /// Sets numbers of a run from a place on.
    fn set(&mut self, run: usize, place: usize, numbers: impl IntoIterator<Item = f64>) {
        for (place, number) in (place..).zip(numbers) {
            let at = self.at(run, place);
            self.numbers[at] = number;
        }
    }

    /// State of a run.
    fn state(&self, run: usize) -> Vec<f64> {
        let steps = self.layout.steps;
        (steps.from()..steps.row(0)).map(|place| self.numbers[self.at(run, place)]).collect()
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
        (0..LANES).for_each(|run| self.set(run, self.layout.steps.first(), [index]));
        self.code.run(&mut self.numbers, count as u32);
        let takes = self.index < self.taken && self.layout.values > 0;
        for run in (0..self.count).filter(|_| takes) {
            for row in 0..count {
                let first = self.at(run, self.layout.row(row));
                let values = self.numbers[first..].iter().step_by(TOGETHER);
                self.values.iter_mut().zip(values).for_each(|(value, number)| *value = *number);
                take(run, (self.index + row as u64 + 1) as f64 * self.step, &self.values);
            }
        }
        self.index += count as u64;
        self.keep_last();
    }
}

impl SideBySide for Lanes {
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
            let numbers = [self.stepper.registers(), self.readings.registers()].map(<[f64]>::to_vec);
            for (place, numbers) in [0, readings].into_iter().zip(numbers) {
                self.set(run, place, numbers);
            }
            self.set(run, steps.spacing(), [self.step, self.step]);
            self.set(run, steps.from(), initial.iter().copied());
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
