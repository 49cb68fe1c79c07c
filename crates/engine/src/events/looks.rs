//! Moments within a step at which conditions are evaluated, so that no change is missed that is undone before the end of
//! the step.
//!
//! Values compared in conditions ([`program::Compared`]) and their rates of change are known at both ends of a step, which
//! gives a cubic interpolant. The interpolant is checked at two interior points against the continuous solution; if the
//! error is too large, the interval is divided. No condition changes between two neighbouring zeros of all interpolants, so
//! one evaluation there is enough. If the limit of divisions is reached, a change may be missed, and a doubt is recorded.

use super::interpolant::{CHECKS, ceases, is_right, worse};
use crate::Routine;
use crate::methods::cubic::Cubic;
use program::{Held, Model, NodeId};
use units::order::sort_numbers;

/// Values compared in conditions, and search for the moments at which to evaluate the conditions.
#[derive(Clone, Debug)]
pub(crate) struct Looks {
    /// The compared values.
    values: Routine,
    /// The compared values, then their rates of change.
    slopes: Routine,
    /// Rates of the states, for the interpolant of a method without continuous solution.
    motion: Routine,
    /// Index of the event that compares each value; `None` for a switch of the equations.
    events: Vec<Option<usize>>,
    ends: [End; 2],
    /// Times of both ends, SI units.
    span: [f64; 2],
    probe: Vec<f64>,
    found: Vec<f64>,
    zeros: Vec<f64>,
    moments: Vec<f64>,
    divisions: usize,
    evaluations: u64,
    doubt: Option<Doubt>,
}

/// Continuous solution of the method at any time of a step (absolute, SI units); `None` if it has none.
pub(crate) type Dense<'a> = Option<&'a dyn Fn(f64, &mut [f64])>;

/// Record that a change may have been missed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Doubt {
    /// Time from which on this holds, SI units.
    pub time: f64,
    /// Index of the event; `None` for a switch of the equations.
    pub event: Option<usize>,
}

/// State, rates and compared values at one end of a step.
#[derive(Clone, Debug, Default)]
struct End {
    point: Point,
    state: Vec<f64>,
    motion: Vec<f64>,
}

/// Compared values at one moment, then their rates of change.
#[derive(Clone, Debug, Default)]
struct Point {
    time: f64,
    values: Vec<f64>,
}

impl Looks {
    /// Maximum depth of bisection of a step.
    const DEEPEST: usize = 9;
    /// Maximum number of divisions of a step in total.
    const DIVISIONS: usize = 256;
    /// Intervals shorter than this multiple of the rounding error of the time are not divided.
    const ROUNDINGS: f64 = 8.0;
    /// Distance from the zero of one value at which the others are evaluated, as a fraction of the interval.
    const BESIDE: f64 = 1e-6;

    /// Returns `None` if no condition depends on states.
    pub fn new(model: &Model, held: Option<&Held>) -> Option<Self> {
        let compared = model.compared(held)?;
        let slopes: Vec<NodeId> = compared.values.iter().chain(&compared.rates).copied().collect();
        let rates: Vec<NodeId> = compared.model.states.iter().map(|state| state.derivative).collect();
        Some(Self {
            values: Routine::compile(&compared.model, &compared.values),
            slopes: Routine::compile(&compared.model, &slopes),
            motion: Routine::compile(&compared.model, &rates),
            ends: [End::default(), End::default()],
            span: [0.0; 2],
            probe: vec![0.0; rates.len()],
            found: vec![0.0; compared.values.len()],
            events: compared.events,
            zeros: Vec::new(),
            moments: Vec::new(),
            divisions: 0,
            evaluations: 0,
            doubt: None,
        })
    }

    /// Sets parameters (SI), followed by the held values of the switches, and initial values (SI, one per state).
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        for routine in [&mut self.values, &mut self.slopes, &mut self.motion] {
            routine.prepare(parameters, initial);
        }
        self.ends = [End::default(), End::default()];
    }

    /// Approximate number of floating-point operations so far.
    pub fn work(&self) -> u64 {
        self.evaluations * self.slopes.work()
    }

    /// Compared values and their rates of change at `time` and `state` (SI), if the last step ended there.
    pub fn values_at(&self, time: f64, state: &[f64]) -> Option<&[f64]> {
        let [_, End { point, state: known, .. }] = &self.ends;
        (point.time == time && known == state).then_some(&point.values)
    }

    /// Computes the values of [`Looks::values_at`] where no step ended.
    pub fn find_values_at(&mut self, time: f64, state: &[f64]) {
        self.arrive(1, (time, state), false);
    }

    /// Continues after intervals that were searched elsewhere; the last one ended at `time` and `state` with these values.
    pub fn continue_at(&mut self, time: f64, state: &[f64], values: &[f64]) {
        let [_, end] = &mut self.ends;
        end.state.clear();
        end.state.extend_from_slice(state);
        end.point.time = time;
        end.point.values.clear();
        end.point.values.extend_from_slice(values);
    }

    /// Counts the evaluations of intervals without divisions that were searched elsewhere.
    pub fn count(&mut self, intervals: u64) {
        self.evaluations += 4 * intervals;
    }

    /// Rates of the states, for the interpolant of a method without continuous solution.
    pub fn motion(&self) -> &Routine {
        &self.motion
    }

    /// The compared values, and then the same with their rates of change.
    pub fn routines(&self) -> [&Routine; 2] {
        [&self.values, &self.slopes]
    }

    /// First moment from which on a change may have been missed.
    pub fn doubt(&self) -> Option<Doubt> {
        self.doubt
    }

    /// Drops a doubt at `time` or later.
    pub fn go_back_to(&mut self, time: f64) {
        self.doubt = self.doubt.filter(|doubt| doubt.time < time);
    }

    /// Finds the moments at which to evaluate conditions between two states of a step, and returns their number. `dense` is
    /// the continuous solution of the method, if it has one.
    pub fn find(&mut self, dense: Dense, from: (f64, &[f64]), to: (f64, &[f64])) -> usize {
        let is_start = |end: &End| end.point.time == from.0 && end.state == from.1;
        if is_start(&self.ends[1]) {
            self.ends.swap(0, 1);
        } else if !is_start(&self.ends[0]) {
            self.arrive(0, from, dense.is_none());
        }
        self.arrive(1, to, dense.is_none());
        self.span = [from.0, to.0];
        self.zeros.clear();
        self.moments.clear();
        self.divisions = 0;
        let [low, high] = [0, 1].map(|end| std::mem::take(&mut self.ends[end].point));
        self.search(dense, &low, &high, 0);
        self.ends[0].point = low;
        self.ends[1].point = high;
        sort_numbers(&mut self.zeros);
        let between = self.zeros.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        self.moments.extend(between.filter(|&moment| moment > from.0 && moment < to.0));
        self.moments.len()
    }

    /// The moment of this index, SI units, ascending.
    pub fn moment(&self, number: usize) -> Option<f64> {
        self.moments.get(number).copied()
    }

    /// Stores a state as an end of the step; with `motion` also its rates.
    fn arrive(&mut self, number: usize, (time, state): (f64, &[f64]), motion: bool) {
        let end = &mut self.ends[number];
        end.state.clear();
        end.state.extend_from_slice(state);
        end.point.time = time;
        end.point.values.resize(self.slopes.len(), 0.0);
        self.slopes.evaluate(time, state, &mut end.point.values);
        end.motion.resize(state.len(), 0.0);
        if motion {
            self.motion.evaluate(time, state, &mut end.motion);
        }
        self.evaluations += 2;
    }

    /// Writes the continuous solution at `time` to `probe`.
    fn interpolate(&mut self, dense: Dense, time: f64) {
        self.evaluations += 1;
        if let Some(dense) = dense {
            return dense(time, &mut self.probe);
        }
        let [from, to] = &self.ends;
        let [start, end] = self.span;
        let (size, part) = (end - start, (time - start) / (end - start));
        for (k, value) in self.probe.iter_mut().enumerate() {
            let slopes = [size * from.motion[k], size * to.motion[k]];
            *value = Cubic::new([from.state[k], to.state[k]], slopes).at(part);
        }
    }

    /// Compared values and their rates at a moment between the ends.
    fn point(&mut self, dense: Dense, time: f64) -> Point {
        self.interpolate(dense, time);
        let mut values = vec![0.0; self.slopes.len()];
        self.slopes.evaluate(time, &self.probe, &mut values);
        Point { time, values }
    }

    /// Finds the zeros of the compared values between two moments; divides the interval where the interpolant is wrong.
    fn search(&mut self, dense: Dense, low: &Point, high: &Point, depth: usize) {
        let size = high.time - low.time;
        let count = self.found.len();
        let cubic = |number: usize| {
            let slopes = [low, high].map(|point| size * point.values[count + number]);
            Cubic::new([low.values[number], high.values[number]], slopes)
        };
        let mut wrong: Vec<f64> = (low.values.iter().zip(&high.values).take(count))
            .map(|(&low, &high)| if ceases(low, high) { f64::INFINITY } else { 0.0 })
            .collect();
        for part in CHECKS {
            let time = low.time + part * size;
            self.interpolate(dense, time);
            self.values.evaluate(time, &self.probe, &mut self.found);
            for (number, (wrong, found)) in wrong.iter_mut().zip(&self.found).enumerate() {
                *wrong = worse(*wrong, *found, cubic(number).at(part));
            }
        }
        let is_right = |number: usize, wrong: f64| is_right(cubic(number), wrong);
        let nothing_between = size <= Self::ROUNDINGS * f64::EPSILON * high.time.abs();
        let doubtful = wrong.iter().enumerate().position(|(number, &wrong)| !is_right(number, wrong));
        let doubtful = doubtful.filter(|_| !nothing_between);
        if let Some(doubtful) = doubtful {
            if depth < Self::DEEPEST && self.divisions < Self::DIVISIONS {
                self.divisions += 1;
                // A value may jump at the zero of another one, as a remainder does: the interval is then divided on both
                // sides of that zero.
                let others = (0..count).filter(|&number| is_right(number, wrong[number]));
                let zero = others.filter_map(|number| beside(cubic(number))).next();
                let [left, right] = zero.map_or([0.5, 0.5], |zero| [zero - Self::BESIDE, zero + Self::BESIDE]);
                let time = |part: f64| low.time + part * size;
                self.zeros.extend(zero.map(time));
                let middle = (left > 0.0).then(|| self.point(dense, time(left)));
                if let Some(middle) = &middle {
                    self.search(dense, low, middle, depth + 1);
                }
                let middle = if zero.is_some() { None } else { middle };
                if right < 1.0 {
                    let middle = middle.unwrap_or_else(|| self.point(dense, time(right)));
                    self.search(dense, &middle, high, depth + 1);
                }
                return;
            }
            // The place where a value becomes undefined is known well enough, unless the divisions are used up.
            if self.doubt.is_none() && (wrong[doubtful].is_finite() || self.divisions >= Self::DIVISIONS) {
                self.doubt = Some(Doubt { time: low.time, event: self.events.get(doubtful).copied().flatten() });
            }
        }
        for (number, wrong) in wrong.iter().enumerate() {
            if wrong.is_infinite() {
                self.zeros.extend([low.time, high.time]);
            }
            cubic(number).zeros(|zero| self.zeros.push(low.time + zero * size));
        }
    }
}

/// A zero inside the interval or at one of its ends, as a fraction of the interval.
fn beside(cubic: Cubic) -> Option<f64> {
    let (least, greatest) = cubic.range();
    let nothing = 0.1 * Looks::BESIDE * greatest.max(-least);
    if let Some(end) = [0.0, 1.0].into_iter().find(|&end| cubic.at(end).abs() < nothing) {
        return Some(end);
    }
    let mut found = None;
    cubic.zeros(|zero| {
        if zero > 2.0 * Looks::BESIDE && zero < 1.0 - 2.0 * Looks::BESIDE {
            found.get_or_insert(zero);
        }
    });
    found
}
