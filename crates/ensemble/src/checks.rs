//! Checks in lanes that nothing happens in an interval: no timed switch changes, no compared values allow an event or switch
//! between the ends, no event is due at the end, and all switches are the same there. Where one fails the engine looks itself.

use crate::body::Body;
use crate::grid::{Block, Grid, WIDTH, one};
use crate::steps::Steps;
use crate::width::{Lanewise, Width};
use engine::{CHECKS, sign_changes};

/// Formulas of the checks.
#[derive(Clone, Debug)]
pub struct Checks {
    conditions: Body,
    switches: Body,
    timed: Body,
    compared: Body,
    slopes: Body,
    /// 1 for each event that can fire, one row for each.
    armed: Grid,
    /// Held values of the switches.
    held: Grid,
    /// Compared values, then their rates of change, at the start of the interval.
    low: Grid,
    /// Compared values at the moments of [`CHECKS`].
    between: [Grid; 2],
    /// States at these moments.
    probe: Grid,
    /// Timed switches at the start, and times of the moments in the last row.
    times: Grid,
    /// The parameters, then the held values.
    inputs: Grid,
}

/// An interval of each lane: rows of one block each.
#[derive(Clone, Copy, Debug)]
pub struct Interval<'a> {
    /// Times reached.
    pub from: &'a Grid,
    /// Times of the ends.
    pub to: &'a Grid,
    /// States at the start, one row for each.
    pub present: &'a Grid,
    /// States at the end.
    pub next: &'a Grid,
    /// 1 for each lane that has an interval.
    pub ready: &'a [Block],
}

impl Checks {
    /// Conditions of events, true values of switches, timed switches, compared values, and these with their rates of change.
    pub fn new([conditions, switches, timed, compared, slopes]: [Body; 5]) -> Self {
        let grid = Grid::default;
        let (between, times) = ([grid(), grid()], grid());
        let [armed, held, low, probe, inputs] = [grid(), grid(), grid(), grid(), grid()];
        Self { conditions, switches, timed, compared, slopes, armed, held, low, between, probe, times, inputs }
    }

    /// The formulas.
    pub fn bodies(&mut self) -> [&mut Body; 5] {
        [&mut self.conditions, &mut self.switches, &mut self.timed, &mut self.compared, &mut self.slopes]
    }

    /// Makes room for so many states, parameters and blocks of lanes.
    pub fn resize(&mut self, states: usize, parameters: usize, (blocks, width): (usize, Width)) {
        self.bodies().into_iter().for_each(|body| body.resize(blocks, width));
        self.armed = Grid::new(self.conditions.len(), blocks);
        self.held = Grid::new(self.switches.len(), blocks);
        self.low = Grid::new(self.slopes.len(), blocks);
        self.between = std::array::from_fn(|_| Grid::new(self.compared.len(), blocks));
        self.probe = Grid::new(states, blocks);
        self.times = Grid::new(self.timed.len() + 1, blocks);
        self.inputs = Grid::new(parameters + self.switches.len(), blocks);
    }

    /// Takes over the parameters and initial values of all lanes, whose runs begin; sets the inputs of the equations.
    pub fn begin(&mut self, rates: &mut Body, parameters: &Grid, initial: &Grid) {
        for body in [&mut self.conditions, &mut self.switches, &mut self.timed] {
            body.prepare(parameters, initial);
        }
        for row in 0..parameters.rows() {
            self.inputs.row_mut(row).copy_from_slice(parameters.row(row));
        }
        let start = Grid::new(1, initial.blocks());
        if !self.switches.is_empty() {
            evaluate(&mut self.switches, &start, 0, initial);
            copy_values(&self.switches, &mut self.held);
        }
        self.prepare(rates, parameters.rows(), initial);
        evaluate(&mut self.conditions, &start, 0, initial);
        self.pass();
        evaluate(&mut self.slopes, &start, 0, initial);
        copy_values(&self.slopes, &mut self.low);
    }

    /// Sets the held values in all that depends on them.
    fn prepare(&mut self, rates: &mut Body, parameters: usize, initial: &Grid) {
        for row in 0..self.held.rows() {
            self.inputs.row_mut(parameters + row).copy_from_slice(self.held.row(row));
        }
        for body in [rates, &mut self.compared, &mut self.slopes] {
            body.prepare(&self.inputs, initial);
        }
    }

    /// Continues a lane in which events or switches may have acted. `time` and `state` reached; `initial`: initial values of all
    /// lanes.
    pub fn load(
        &mut self,
        lane: usize,
        rates: &mut Body,
        (armed, held): (&[bool], &[f64]),
        (time, present): (&Grid, &Grid),
        initial: &Grid,
    ) {
        for (row, &armed) in armed.iter().enumerate() {
            self.armed.set(row, lane, f64::from(u8::from(armed)));
        }
        self.held.set_lane(lane, held);
        self.prepare(rates, self.inputs.rows() - self.held.rows(), initial);
        evaluate(&mut self.slopes, time, 0, present);
        for row in 0..self.low.rows() {
            self.low.set(row, lane, self.slopes.value(row, lane));
        }
    }

    /// True for each event of a lane that can fire.
    pub fn armed(&self, lane: usize) -> Vec<bool> {
        (0..self.armed.rows()).map(|row| self.armed.get(row, lane) != 0.0).collect()
    }

    /// Checks the intervals. Sets `failed` to 1 where something could happen; all other lanes have passed.
    pub fn check(&mut self, width: Width, steps: &Steps, interval: &Interval, failed: &mut [Block]) {
        width.call::<Check>((self, width, steps, interval, failed));
    }

    #[inline(always)]
    fn check_in((own, width, steps, interval, failed): (&mut Self, Width, &Steps, &Interval, &mut [Block])) {
        failed.fill(Block::of(0.0));
        own.check_timed(interval, failed);
        own.search(width, steps, interval, failed);
        evaluate(&mut own.conditions, interval.to, 0, interval.next);
        evaluate(&mut own.switches, interval.to, 0, interval.next);
        for row in 0..own.armed.rows() {
            let truths = own.conditions.grid().row(own.conditions.roots()[row] as usize);
            mark(failed, own.armed.row(row), truths, |armed, truth| armed != 0.0 && truth != 0.0);
        }
        for row in 0..own.held.rows() {
            let truths = own.switches.grid().row(own.switches.roots()[row] as usize);
            mark(failed, own.held.row(row), truths, |held, found| held != found);
        }
        let passed = passed(interval.ready, failed);
        for row in 0..own.armed.rows() {
            let truths = own.conditions.grid().row(own.conditions.roots()[row] as usize);
            for (block, armed) in own.armed.row_mut(row).iter_mut().enumerate() {
                let (truth, before) = (truths[block], *armed);
                *armed = Block::each(|lane| {
                    let now = f64::from(u8::from(truth.0[lane] == 0.0));
                    if passed[block].0[lane] != 0.0 { now } else { before.0[lane] }
                });
            }
        }
        for row in 0..own.low.rows() {
            let high = own.slopes.grid().row(own.slopes.roots()[row] as usize);
            for (block, low) in own.low.row_mut(row).iter_mut().enumerate() {
                let (high, before) = (high[block], *low);
                *low = Block::each(|lane| if passed[block].0[lane] != 0.0 { high.0[lane] } else { before.0[lane] });
            }
        }
    }

    /// Arms the events whose conditions are false.
    fn pass(&mut self) {
        for row in 0..self.armed.rows() {
            let truths = self.conditions.grid().row(self.conditions.roots()[row] as usize);
            one(self.armed.row_mut(row), truths, |truth| f64::from(u8::from(truth == 0.0)));
        }
    }

    #[inline(always)]
    fn check_timed(&mut self, interval: &Interval, failed: &mut [Block]) {
        if self.timed.is_empty() {
            return;
        }
        evaluate(&mut self.timed, interval.from, 0, interval.present);
        copy_values(&self.timed, &mut self.times);
        evaluate(&mut self.timed, interval.to, 0, interval.present);
        for row in 0..self.timed.len() {
            let after = self.timed.grid().row(self.timed.roots()[row] as usize);
            mark(failed, self.times.row(row), after, |before, after| before != after);
        }
    }

    /// Marks lanes in which compared values change their signs more than once, or must be searched in parts of the interval.
    #[inline(always)]
    fn search(&mut self, width: Width, steps: &Steps, interval: &Interval, failed: &mut [Block]) {
        if self.slopes.is_empty() {
            return;
        }
        let (blocks, moment) = (failed.len(), self.timed.len());
        for (part, between) in CHECKS.into_iter().zip(&mut self.between) {
            for block in 0..blocks {
                let (from, to) = (interval.from.row(0)[block], interval.to.row(0)[block]);
                let times = Block::each(|lane| from.0[lane] + part * (to.0[lane] - from.0[lane]));
                self.times.row_mut(moment)[block] = times;
            }
            steps.continuous_at(width, self.times.row(moment), &mut self.probe);
            evaluate(&mut self.compared, &self.times, moment, &self.probe);
            copy_values(&self.compared, between);
        }
        evaluate(&mut self.slopes, interval.to, 0, interval.next);
        let count = self.compared.len();
        for (block, failed) in failed.iter_mut().enumerate() {
            for lane in 0..WIDTH {
                let place = block * WIDTH + lane;
                let size = interval.to.get(0, place) - interval.from.get(0, place);
                let mut changes = 0.0;
                for number in 0..count {
                    let [low, leaving] = [number, count + number].map(|row| self.low.get(row, place));
                    let [high, arriving] = [number, count + number].map(|row| self.slopes.value(row, place));
                    let [first, second] = self.between.each_ref().map(|grid| grid.get(number, place));
                    changes += sign_changes(low, high, size * leaving, size * arriving, first, second);
                }
                // Between two changes of sign there would be a moment to look at; the comparison also covers NaN.
                let quiet = changes <= 1.0;
                failed.0[lane] = if quiet { failed.0[lane] } else { 1.0 };
            }
        }
    }
}

/// 1 for the lanes that are ready and have not failed.
#[inline(always)]
pub fn passed(ready: &[Block], failed: &[Block]) -> Vec<Block> {
    let passed = |(ready, failed): (&Block, &Block)| {
        let (ready, failed) = (*ready, *failed);
        Block::each(|lane| if ready.0[lane] != 0.0 && failed.0[lane] == 0.0 { 1.0 } else { 0.0 })
    };
    ready.iter().zip(failed).map(passed).collect()
}

/// Evaluates formulas at the times in a row of `times` and at these states.
#[inline(always)]
fn evaluate(body: &mut Body, times: &Grid, row: usize, states: &Grid) {
    if !body.is_empty() {
        body.set_time(times, row);
        body.set_states(states);
        body.evaluate();
    }
}

/// Copies the values of formulas, one row for each.
#[inline(always)]
fn copy_values(body: &Body, out: &mut Grid) {
    for (row, &root) in body.roots().iter().enumerate() {
        out.row_mut(row).copy_from_slice(body.grid().row(root as usize));
    }
}

/// Marks the lanes in which `differs` holds of the numbers of two rows.
#[inline(always)]
fn mark(failed: &mut [Block], a: &[Block], b: &[Block], differs: impl Fn(f64, f64) -> bool) {
    for ((failed, a), b) in failed.iter_mut().zip(a).zip(b) {
        let (before, a, b) = (*failed, *a, *b);
        *failed = Block::each(|lane| if differs(a.0[lane], b.0[lane]) { 1.0 } else { before.0[lane] });
    }
}

/// [`Checks::check_in`] for all features.
struct Check;

impl Lanewise for Check {
    type Arguments<'a> = (&'a mut Checks, Width, &'a Steps, &'a Interval<'a>, &'a mut [Block]);

    #[inline(always)]
    fn call(arguments: Self::Arguments<'_>) {
        Checks::check_in(arguments);
    }
}
