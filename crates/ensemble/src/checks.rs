//! Checks in lanes that nothing happens in an interval: no timed switch changes, no compared values allow an event or switch
//! between the ends, no event is due at the end, and all switches are the same there. Where one fails the engine looks itself.

use crate::body::Body;
use crate::grid::{Block, Grid, Mask, WIDTH, one};
use crate::steps::Steps;
use crate::width::{Lanewise, Width};
use engine::{CHECKS, certain_sign_changes, cubic_value, sign_changes};

/// Formulas of the checks.
#[derive(Clone, Debug)]
pub struct Checks {
    conditions: Body,
    switches: Body,
    timed: Body,
    compared: Body,
    slopes: Body,
    /// Rates of the states, for a method without continuous solution.
    motion: Body,
    /// 1 for each event that can fire, one row for each.
    armed: Grid,
    /// Held values of the switches.
    held: Grid,
    /// Compared values, then their rates of change, at the start of the interval.
    low: Grid,
    /// Rates of the states there.
    leaving: Grid,
    /// Compared values at the moments of [`CHECKS`].
    between: [Grid; 2],
    /// States at these moments.
    probe: Grid,
    /// Timed switches at the start, and times of the moments in the last row.
    times: Grid,
    /// The parameters, then the held values.
    inputs: Grid,
    /// True for the lanes whose held values, compared values and rates at the start are not up to date.
    stale: Vec<bool>,
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
    /// Conditions of events, true values of switches, timed switches, compared values, and these with their rates of change; `motion`:
    /// rates of the states, none for a method with a continuous solution.
    pub fn new([conditions, switches, timed, compared, slopes]: [Body; 5], motion: Body) -> Self {
        let [armed, held, low, leaving, first, second, probe, times, inputs] = std::array::from_fn(|_| Grid::default());
        let (between, stale) = ([first, second], Vec::new());
        Self {
            conditions,
            switches,
            timed,
            compared,
            slopes,
            motion,
            armed,
            held,
            low,
            leaving,
            between,
            probe,
            times,
            inputs,
            stale,
        }
    }

    /// The formulas.
    fn bodies(&mut self) -> [&mut Body; 6] {
        let Self { conditions, switches, timed, compared, slopes, motion, .. } = self;
        [conditions, switches, timed, compared, slopes, motion]
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
        self.leaving = Grid::new(self.motion.len(), blocks);
        self.stale = vec![false; blocks * WIDTH];
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
        self.stale.fill(true);
        self.evaluate_stale(&start, initial);
    }

    /// Sets the held values in all that depends on them.
    fn prepare(&mut self, rates: &mut Body, parameters: usize, initial: &Grid) {
        for row in 0..self.held.rows() {
            self.inputs.row_mut(parameters + row).copy_from_slice(self.held.row(row));
        }
        for body in [rates, &mut self.compared, &mut self.slopes, &mut self.motion] {
            body.prepare(&self.inputs, initial);
        }
    }

    /// Continues a lane in which events or switches may have acted, after [`Checks::refresh`].
    pub fn load(&mut self, lane: usize, armed: &[bool], held: &[f64]) {
        for (row, &armed) in armed.iter().enumerate() {
            self.armed.set(row, lane, f64::from(u8::from(armed)));
        }
        self.held.set_lane(lane, held);
        self.stale[lane] = true;
    }

    /// Brings all lanes of [`Checks::load`] up to date at once. `time` and `present` state reached; `initial`: initial values; both of
    /// all lanes.
    pub fn refresh(&mut self, rates: &mut Body, (time, present): (&Grid, &Grid), initial: &Grid) {
        if self.stale.contains(&true) {
            self.prepare(rates, self.inputs.rows() - self.held.rows(), initial);
            self.evaluate_stale(time, present);
        }
    }

    /// Computes what is known at the start of the intervals of stale lanes.
    fn evaluate_stale(&mut self, time: &Grid, present: &Grid) {
        for (body, known) in [(&mut self.slopes, &mut self.low), (&mut self.motion, &mut self.leaving)] {
            evaluate(body, time, 0, present);
            for (lane, _) in self.stale.iter().enumerate().filter(|(_, stale)| **stale) {
                (0..known.rows()).for_each(|row| known.set(row, lane, body.value(row, lane)));
            }
        }
        self.stale.fill(false);
    }

    /// True for each event of a lane that can fire.
    pub fn armed(&self, lane: usize) -> Vec<bool> {
        (0..self.armed.rows()).map(|row| self.armed.get(row, lane) != 0.0).collect()
    }

    /// Checks the intervals. Sets `failed` to 1 where something could happen; all other lanes have passed.
    /// `steps` made by a method with a continuous solution.
    pub fn check(&mut self, width: Width, steps: Option<&Steps>, interval: &Interval, failed: &mut [Block]) {
        width.call::<Check>((self, width, steps, interval, failed));
    }

    #[inline(always)]
    fn check_in((own, width, steps, interval, failed): (&mut Self, Width, Option<&Steps>, &Interval, &mut [Block])) {
        failed.fill(Block::of(0.0));
        evaluate(&mut own.motion, interval.to, 0, interval.next);
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
                let truth = truths[block];
                let now = Block::each(|lane| f64::from(u8::from(truth.0[lane] == 0.0)));
                *armed = passed[block].choose(now, *armed);
            }
        }
        take_over(&mut own.low, &own.slopes, &passed);
        take_over(&mut own.leaving, &own.motion, &passed);
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
    fn search(&mut self, width: Width, steps: Option<&Steps>, interval: &Interval, failed: &mut [Block]) {
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
            match steps {
                Some(steps) => steps.continuous_at(width, self.times.row(moment), &mut self.probe),
                None => interpolate(interval, (&self.leaving, &self.motion), self.times.row(moment), &mut self.probe),
            }
            evaluate(&mut self.compared, &self.times, moment, &self.probe);
            copy_values(&self.compared, between);
        }
        evaluate(&mut self.slopes, interval.to, 0, interval.next);
        for (block, failed) in failed.iter_mut().enumerate() {
            let (from, to) = (interval.from.row(0)[block], interval.to.row(0)[block]);
            let size = Block::each(|lane| to.0[lane] - from.0[lane]);
            let mut certain = Block::of(0.0);
            for number in 0..self.compared.len() {
                let ([low, leaving, high, arriving, first, second], sum) = (self.course(number, block), certain);
                certain = Block::each(|lane| {
                    let [leaving, arriving] = [size.0[lane] * leaving.0[lane], size.0[lane] * arriving.0[lane]];
                    let [low, high] = [low.0[lane], high.0[lane]];
                    sum.0[lane] + certain_sign_changes(low, high, leaving, arriving, first.0[lane], second.0[lane])
                });
            }
            for lane in 0..WIDTH {
                // Between two changes of sign there would be a moment to look at; the comparisons also cover NaN.
                let quiet = |changes: f64| changes <= 1.0;
                let due = interval.ready[block].0[lane] != 0.0 && failed.0[lane] == 0.0 && !quiet(certain.0[lane]);
                if due && !quiet(self.sign_changes(block, lane, size.0[lane])) {
                    failed.0[lane] = 1.0;
                }
            }
        }
    }

    /// A compared value in the lanes of a block: value and rate of change at the start, the same at the end, values at [`CHECKS`].
    #[inline(always)]
    fn course(&self, number: usize, block: usize) -> [Block; 6] {
        let rate = self.compared.len() + number;
        let arriving = |row: usize| self.slopes.grid().row(self.slopes.roots()[row] as usize)[block];
        let [first, second] = &self.between;
        [
            self.low.row(number)[block],
            self.low.row(rate)[block],
            arriving(number),
            arriving(rate),
            first.row(number)[block],
            second.row(number)[block],
        ]
    }

    /// Number of changes of sign of all compared values in an interval of a lane; NaN if the interval must be divided.
    fn sign_changes(&self, block: usize, lane: usize, size: f64) -> f64 {
        let changes = |number: usize| {
            let [low, leaving, high, arriving, first, second] = self.course(number, block).map(|block| block.0[lane]);
            sign_changes(low, high, size * leaving, size * arriving, first, second)
        };
        (0..self.compared.len()).map(changes).sum()
    }
}

/// The lanes that are ready and have not failed.
#[inline(always)]
pub fn passed(ready: &[Block], failed: &[Block]) -> Vec<Mask> {
    let passed = |(ready, failed): (&Block, &Block)| {
        let (ready, failed) = (*ready, *failed);
        Mask::each(|lane| ready.0[lane] != 0.0 && failed.0[lane] == 0.0)
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

/// States at a time of each lane, a row of `times`, by the interpolant of the states and rates at both ends of the intervals.
#[inline(always)]
fn interpolate(interval: &Interval, (leaving, motion): (&Grid, &Body), times: &[Block], out: &mut Grid) {
    for state in 0..out.rows() {
        let arriving = motion.grid().row(motion.roots()[state] as usize);
        for (block, out) in out.row_mut(state).iter_mut().enumerate() {
            let (from, to, time) = (interval.from.row(0)[block], interval.to.row(0)[block], times[block]);
            let (present, next) = (interval.present.row(state)[block], interval.next.row(state)[block]);
            let (leaving, arriving) = (leaving.row(state)[block], arriving[block]);
            *out = Block::each(|lane| {
                let size = to.0[lane] - from.0[lane];
                let slopes = [size * leaving.0[lane], size * arriving.0[lane]];
                let part = (time.0[lane] - from.0[lane]) / size;
                cubic_value([present.0[lane], next.0[lane]], slopes, part)
            });
        }
    }
}

/// Replaces known values by those of formulas in the lanes that have passed.
#[inline(always)]
fn take_over(known: &mut Grid, body: &Body, passed: &[Mask]) {
    for row in 0..known.rows() {
        let found = body.grid().row(body.roots()[row] as usize);
        for ((known, found), passed) in known.row_mut(row).iter_mut().zip(found).zip(passed) {
            *known = passed.choose(*found, *known);
        }
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
        *failed = Block::each(|lane| f64::from(u8::from(differs(a.0[lane], b.0[lane]) | (before.0[lane] != 0.0))));
    }
}

/// [`Checks::check_in`] for all features.
struct Check;

impl Lanewise for Check {
    type Arguments<'a> = (&'a mut Checks, Width, Option<&'a Steps>, &'a Interval<'a>, &'a mut [Block]);

    #[inline(always)]
    fn call(arguments: Self::Arguments<'_>) {
        Checks::check_in(arguments);
    }
}
