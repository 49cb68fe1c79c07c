//! Windows of the Dormand-Prince method in compiled form: steps and rows computed in advance, taken one by one.

use super::window_layout::WindowLayout;
use super::{Compiled, copy};
use crate::methods::last_step::LastStep;
use crate::methods::tableau::STAGES;
use std::rc::Rc;

/// Compiled code with its block of numbers, and what it has computed in advance.
#[derive(Clone, Debug)]
pub(crate) struct Window {
    code: Rc<dyn Compiled>,
    layout: WindowLayout,
    /// True if the code checks all that could happen in a step.
    checks: bool,
    /// Indices of the states whose rates are not the constant 0.
    moving: Vec<usize>,
    numbers: Vec<f64>,
    /// Index of the grid point before the next row.
    index: u64,
    /// Number of rows, and of those that were taken.
    rows: usize,
    taken: usize,
    /// Number of steps, and the number of the record in force.
    steps: usize,
    position: usize,
    /// Evaluations of the right-hand side at the start of the first step that are not counted yet.
    uncounted: u64,
}

/// Amounts that a row or step, when it is taken, adds to the counters.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Taken {
    /// Attempts of steps.
    pub attempts: u64,
    /// Other evaluations of the right-hand side.
    pub evaluations: u64,
    /// Intervals at whose ends conditions were evaluated.
    pub intervals: u64,
}

impl Taken {
    /// All evaluations of the right-hand side.
    pub fn stages(self) -> u64 {
        (STAGES as u64 - 1) * self.attempts + self.evaluations
    }
}

/// Where a window begins, and the accuracy of its steps; SI units, one number per state, event, switch or compared value.
#[derive(Debug)]
pub(crate) struct Begin<'a> {
    /// Time reached, index of the grid point before the next row, distance of the rows, upper bound of the step, tolerance,
    /// lower bound of the magnitude as a fraction of the peak.
    pub settings: [f64; 6],
    pub floors: &'a [f64],
    pub state: &'a [f64],
    pub armed: &'a [bool],
    pub held: &'a [f64],
    /// Compared values and their rates of change.
    pub values: &'a [f64],
    pub last: &'a LastStep,
    /// Rates at the end of the last step.
    pub rates: &'a [f64],
    /// True if the evaluation of these rates is not counted yet.
    pub uncounted: bool,
}

impl Begin<'_> {
    /// Writes the numbers to their places.
    pub fn write(&self, layout: &WindowLayout, mut put: impl FnMut(usize, &[f64])) {
        let record = layout.record(0);
        put(layout.time(), &self.settings);
        put(layout.floors(), self.floors);
        put(layout.present(), self.state);
        for (number, &armed) in self.armed.iter().enumerate() {
            put(layout.armed() + number, &[f64::from(u8::from(armed))]);
        }
        put(layout.held(), self.held);
        put(layout.values(), self.values);
        let last = self.last;
        put(record, &[last.start, last.size, last.end, last.proposed, last.error, 0.0]);
        put(record + layout.to(), &last.to);
        put(record + layout.peaks(), &last.peaks);
        put(record + layout.rates(), self.rates);
        for (degree, coefficients) in last.dense.iter().enumerate() {
            put(record + layout.dense(degree), coefficients);
        }
    }
}

impl Window {
    /// `still`: see [`Listing::still`](crate::Listing::still).
    pub fn new(code: Rc<dyn Compiled>, layout: WindowLayout, checks: bool, still: &[Option<f64>]) -> Self {
        let moving = (0..layout.states).filter(|&k| still[k].is_none()).collect();
        let numbers = vec![0.0; layout.len()];
        Self { code, layout, checks, moving, numbers, index: 0, rows: 0, taken: 0, steps: 0, position: 0, uncounted: 0 }
    }

    /// True if windows can be computed although the model has events or switches.
    pub fn checks(&self) -> bool {
        self.checks
    }

    /// Takes over the registers of the right-hand side after a change of parameters, held values or initial values.
    pub fn load(&mut self, registers: &[f64]) {
        self.numbers[..registers.len()].copy_from_slice(registers);
        self.forget();
    }

    /// Takes over the registers of the formulas.
    pub fn load_formulas(&mut self, formulas: [&[f64]; 5]) {
        for (number, registers) in formulas.into_iter().enumerate() {
            self.put(self.layout.formula(number), registers);
        }
        self.forget();
    }

    /// Discards what was computed in advance.
    pub fn forget(&mut self) {
        (self.rows, self.taken, self.steps, self.position) = (0, 0, 0, 0);
    }

    /// Makes one attempt of a step. `rates` at its start, which are given, and at its end.
    pub fn attempt(
        &mut self,
        [time, size]: [f64; 2],
        from: &[f64],
        to: &mut [f64],
        error: &mut [f64],
        [first, last]: [&mut [f64]; 2],
    ) {
        self.forget();
        let layout = self.layout;
        let (before, after) = (layout.record(0), layout.record(1));
        self.numbers[layout.time()] = time;
        self.put(before, &[time, size, time]);
        self.put(before + layout.to(), from);
        self.put(before + layout.rates(), first);
        self.code.run(&mut self.numbers, 0);
        for (k, (to, from)) in to.iter_mut().zip(from).enumerate() {
            // The sums of rates of a constant state are 0.
            *to = from + 0.0;
            error[k] = 0.0;
            last[k] = 0.0;
        }
        for &k in &self.moving {
            to[k] = self.numbers[after + layout.to() + k];
            error[k] = self.numbers[layout.error() + k];
            last[k] = self.numbers[after + layout.rates() + k];
        }
    }

    /// Coefficients of the continuous solution over the step of the last attempt from the state `from`: five lists of one
    /// per state. Those of constant states stay 0.
    pub fn dense(&self, from: &[f64], coefficients: &mut [Vec<f64>; 5]) {
        self.dense_of(1, from, coefficients);
    }

    fn dense_of(&self, record: usize, from: &[f64], coefficients: &mut [Vec<f64>; 5]) {
        let [value, bends @ ..] = coefficients;
        copy(from, value);
        for (degree, coefficients) in (1..).zip(bends) {
            let first = self.layout.record(record) + self.layout.dense(degree);
            for &k in &self.moving {
                coefficients[k] = self.numbers[first + k];
            }
        }
    }

    /// Computes steps and rows.
    pub fn begin(&mut self, begin: &Begin) {
        let layout = self.layout;
        begin.write(&layout, |place, numbers| self.put(place, numbers));
        self.rows = (self.code.run(&mut self.numbers, layout.rows as u32) as usize).min(layout.rows);
        self.steps = (self.numbers[layout.made()] as usize).min(layout.steps);
        self.index = begin.settings[1] as u64;
        (self.taken, self.position, self.uncounted) = (0, 0, u64::from(begin.uncounted));
    }

    /// True if the row after this grid point is computed.
    #[inline]
    pub fn has_row(&self, index: u64) -> bool {
        self.taken < self.rows && self.index == index
    }

    /// Counters of the next row.
    #[inline]
    pub fn next_row(&self) -> Taken {
        let row = self.layout.row(self.taken);
        let before = if self.taken > 0 { self.numbers[self.layout.row(self.taken - 1) + 1] } else { 0.0 };
        let intervals = (self.numbers[row + 1] - before) as u64;
        Taken { intervals, ..self.until(self.numbers[row] as usize) }
    }

    /// Takes the next row.
    #[inline]
    pub fn take_row(&mut self, state: &mut [f64]) {
        let row = self.layout.row(self.taken);
        let first = row + self.layout.row_states();
        copy(&self.numbers[first..first + self.layout.states], state);
        let position = (self.numbers[row] as usize).min(self.steps);
        self.uncounted = if position > self.position { 0 } else { self.uncounted };
        self.position = position;
        self.index += 1;
        self.taken += 1;
    }

    /// Counters of the steps up to that of a record.
    fn until(&self, record: usize) -> Taken {
        let attempts = |record: usize| self.numbers[self.layout.record(record) + 5] as u64;
        let attempts = attempts(record.min(self.steps)) - attempts(self.position);
        Taken { attempts, evaluations: if record > self.position { self.uncounted } else { 0 }, intervals: 0 }
    }

    /// True if the next step is computed.
    pub fn has_step(&self) -> bool {
        self.position < self.steps
    }

    /// True if rows were taken since the last call of [`Window::end`].
    pub fn is_ahead(&self) -> bool {
        self.taken > 0
    }

    /// Compared values and their rates of change at the row taken last.
    pub fn values(&self) -> &[f64] {
        let first = self.layout.row(self.taken.saturating_sub(1)) + 2;
        &self.numbers[first..first + 2 * self.layout.compared]
    }

    /// Brings the last step up to the row taken last. True if it is another step than that before the window.
    pub fn bring(&self, last: &mut LastStep) -> bool {
        if self.position > 0 {
            if self.position > 1 {
                // A constant state lost the sign of its zero in the first step.
                last.to.iter_mut().for_each(|value| *value += 0.0);
            }
            self.copy_step(last);
        }
        self.position > 0
    }

    /// Discards the rows. Steps beyond the row taken last can still be taken.
    pub fn end(&mut self) {
        (self.rows, self.taken) = (0, 0);
    }

    /// Rates at the end of the last step taken: one per state.
    pub fn rates(&self) -> &[f64] {
        let first = self.layout.record(self.position) + self.layout.rates();
        &self.numbers[first..first + self.layout.states]
    }

    /// Takes the step after `last`, if it was computed.
    pub fn take_step(&mut self, last: &mut LastStep) -> Option<Taken> {
        let record = self.layout.record(self.position);
        let same = |place: usize, value: f64| self.numbers[record + place].to_bits() == value.to_bits();
        if self.position >= self.steps || !same(2, last.end) || !same(3, last.proposed) || !same(4, last.error) {
            return None;
        }
        let taken = self.until(self.position + 1);
        self.position += 1;
        self.uncounted = 0;
        self.copy_step(last);
        Some(taken)
    }

    /// Copies the record in force; `last` is the step before it, of which the states that move may be those of any step.
    fn copy_step(&self, last: &mut LastStep) {
        let layout = self.layout;
        let record = layout.record(self.position);
        let at = |place: usize| self.numbers[record + place];
        (last.start, last.size, last.end, last.proposed, last.error) = (at(0), at(1), at(2), at(3), at(4));
        last.from.clone_from(&last.to);
        for value in &mut last.to {
            *value += 0.0;
        }
        for &k in &self.moving {
            last.from[k] = at(layout.dense(0) + k);
            last.to[k] = at(layout.to() + k);
            last.peaks[k] = at(layout.peaks() + k);
        }
        let LastStep { from, dense, .. } = last;
        self.dense_of(self.position, from, dense);
    }

    fn put(&mut self, first: usize, values: &[f64]) {
        copy(values, &mut self.numbers[first..first + values.len()]);
    }
}
