//! Where within a step to look, so that nothing is skipped that is over before its end.
//!
//! What conditions compare ([`program::Compared`]) is known at both ends of a step, with its rate of change: a cubic leads
//! from one to the other. The cubic is checked at two moments in between, on the continuous solution, and where it is wrong the
//! interval is divided. Between two neighbouring zeros of all cubics no condition changes, so one look there is enough.
//! Where the divisions allowed are not enough something may be missed, and that is noted.

use crate::Routine;
use crate::methods::cubic::Cubic;
use program::{Held, Model, NodeId};

/// What is compared, and where to look.
#[derive(Clone, Debug)]
pub(crate) struct Looks {
    /// The numbers that are compared.
    values: Routine,
    /// The same, and behind them their rates of change.
    slopes: Routine,
    /// The rates of the states, for the continuous solution of a method without one of its own.
    motion: Routine,
    /// By number, the event that compares it.
    events: Vec<Option<usize>>,
    ends: [End; 2],
    /// Their times.
    span: [f64; 2],
    probe: Vec<f64>,
    found: Vec<f64>,
    zeros: Vec<f64>,
    moments: Vec<f64>,
    divisions: usize,
    evaluations: u64,
    doubt: Option<Doubt>,
}

/// The continuous solution at any time of a step, if the method has one.
pub(crate) type Dense<'a> = Option<&'a dyn Fn(f64, &mut [f64])>;

/// That something may have been missed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Doubt {
    /// From when on.
    pub time: f64,
    /// Of which event; none where it is a switch of the equations.
    pub event: Option<usize>,
}

/// One end of a step.
#[derive(Clone, Debug, Default)]
struct End {
    point: Point,
    state: Vec<f64>,
    motion: Vec<f64>,
}

/// What is compared at one moment, and behind it the rates of change.
#[derive(Clone, Debug, Default)]
struct Point {
    time: f64,
    values: Vec<f64>,
}

impl Looks {
    /// A step is divided so often in halves of halves.
    const DEEPEST: usize = 9;
    /// And no oftener in all.
    const DIVISIONS: usize = 256;
    /// Where the cubic is checked: at no simple fractions, lest what swings with the step be taken to be at rest.
    const CHECKS: [f64; 2] = [0.29, 0.62];
    /// A cubic that is wrong by less than this part of its greatest value is right.
    const EXACTNESS: f64 = 1e-3;
    /// Within so many roundings of the time there is nothing but rounding to look at.
    const ROUNDINGS: f64 = 8.0;
    /// Beside the zero of one number others are taken to be so far away, in parts of the interval.
    const BESIDE: f64 = 1e-6;

    /// `None` where no condition depends on states.
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

    /// Sets parameters, behind them the values at which the switches are held, and initial values.
    pub fn prepare(&mut self, parameters: &[f64], initial: &[f64]) {
        for routine in [&mut self.values, &mut self.slopes, &mut self.motion] {
            routine.prepare(parameters, initial);
        }
        self.ends = [End::default(), End::default()];
    }

    /// About how many floating-point operations all of it took.
    pub fn work(&self) -> u64 {
        self.evaluations * self.slopes.work()
    }

    /// The first moment from which on something may have been missed.
    pub fn doubt(&self) -> Option<Doubt> {
        self.doubt
    }

    /// Forgets what is not earlier than `time`.
    pub fn go_back_to(&mut self, time: f64) {
        self.doubt = self.doubt.filter(|doubt| doubt.time < time);
    }

    /// How many moments to look at there are between two states of a step; `dense` is the continuous solution, if the method
    /// has one.
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
        self.zeros.sort_unstable_by(f64::total_cmp);
        let between = self.zeros.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        self.moments.extend(between.filter(|&moment| moment > from.0 && moment < to.0));
        self.moments.len()
    }

    /// A moment found.
    pub fn moment(&self, number: usize) -> Option<f64> {
        self.moments.get(number).copied()
    }

    /// Notes a state as an end of the step.
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

    /// The continuous solution at a moment, to `probe`.
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

    /// What is compared at a moment between the ends.
    fn point(&mut self, dense: Dense, time: f64) -> Point {
        self.interpolate(dense, time);
        let mut values = vec![0.0; self.slopes.len()];
        self.slopes.evaluate(time, &self.probe, &mut values);
        Point { time, values }
    }

    /// Finds the zeros between two moments.
    fn search(&mut self, dense: Dense, low: &Point, high: &Point, depth: usize) {
        let size = high.time - low.time;
        let count = self.found.len();
        let cubic = |number: usize| {
            let slopes = [low, high].map(|point| size * point.values[count + number]);
            Cubic::new([low.values[number], high.values[number]], slopes)
        };
        // Where only one of two values is a number, it begins or ceases to be one between them. Comparing NaN would hide that.
        let ceases = |a: f64, b: f64| a.is_finite() != b.is_finite();
        let mut wrong: Vec<f64> = (low.values.iter().zip(&high.values).take(count))
            .map(|(&low, &high)| if ceases(low, high) { f64::INFINITY } else { 0.0 })
            .collect();
        for part in Self::CHECKS {
            let time = low.time + part * size;
            self.interpolate(dense, time);
            self.values.evaluate(time, &self.probe, &mut self.found);
            for (number, (wrong, found)) in wrong.iter_mut().zip(&self.found).enumerate() {
                let expected = cubic(number).at(part);
                *wrong = if ceases(*found, expected) { f64::INFINITY } else { wrong.max((found - expected).abs()) };
            }
        }
        let is_right = |number: usize, wrong: f64| {
            let (least, greatest) = cubic(number).range();
            if !(least.is_finite() && greatest.is_finite()) {
                // No number at either end, nor in between.
                return wrong.is_finite();
            }
            let nearest = if least > 0.0 { least } else { -greatest };
            wrong <= Self::EXACTNESS * greatest.abs().max(least.abs()) || 4.0 * wrong < nearest
        };
        let nothing_between = size <= Self::ROUNDINGS * f64::EPSILON * high.time.abs();
        let doubtful = wrong.iter().enumerate().position(|(number, &wrong)| !is_right(number, wrong));
        let doubtful = doubtful.filter(|_| !nothing_between);
        if let Some(doubtful) = doubtful {
            if depth < Self::DEEPEST && self.divisions < Self::DIVISIONS {
                self.divisions += 1;
                // One number may jump where another is zero, as a remainder does: then its sides are looked at.
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
            // Where a value ceases to be a number, the place is known well enough, unless the divisions are used up.
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

/// A zero inside the interval, or at one of its ends.
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
