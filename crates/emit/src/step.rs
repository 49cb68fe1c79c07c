//! Steps of the Dormand-Prince method with step control and continuous solution, as the engine makes them
//! (`engine/methods/adaptive.rs`, `engine/methods/dormand_prince.rs`), with the same operations in the same order.

use crate::arithmetic::Where;
use crate::body::Body;
use crate::function::Function;
use crate::sink::{Local, Sink, Values};
use crate::states::States;
use engine::tableau::{DENSE_WEIGHTS, ERROR_WEIGHTS, NODES, STAGE_WEIGHTS, STAGES};
use engine::{Listing, WindowLayout};
use std::ops::Range;

/// The steps: the last one, the state, and the attempt that is made.
pub(crate) struct Step<'a> {
    body: Body<'a>,
    pub order: States,
    /// Time reached, and the state there.
    pub time: Local,
    pub present: Vec<Local>,
    /// Start, size and end of the last step.
    start: Local,
    /// In an attempt, its size.
    pub size: Local,
    pub end: Local,
    pub proposed: Local,
    /// Error of the last step, and of the attempt.
    error: Local,
    pub found: Local,
    /// Factor by which the step after the attempt may grow.
    growth: Local,
    pub longest: Local,
    tolerance: Local,
    below_peak: Local,
    /// State at the end of the last step.
    pub to: Vec<Local>,
    pub peaks: Vec<Local>,
    floors: Vec<Local>,
    /// Estimated errors of the attempt.
    pub errors: Vec<Local>,
    /// Coefficients of the continuous solution, by degree.
    pub dense: [Vec<Local>; 5],
    /// Rates of each stage. After a step the first and the last ones are equal.
    pub rates: Vec<Vec<Local>>,
}

impl<'a> Step<'a> {
    pub fn load(listing: &'a Listing, layout: WindowLayout, sink: &mut Sink) -> Self {
        let (record, states) = (layout.record(0), layout.states);
        let order = States::of(listing, sink.in_block());
        let body = Body::of_rates(listing, &order, sink);
        let mut list = |first: usize| sink.load_list(&order.rows, &order.index, first);
        let (present, floors) = (list(layout.present()), list(layout.floors()));
        let (to, peaks) = (list(record + layout.to()), list(record + layout.peaks()));
        let first = list(record + layout.rates());
        let dense = std::array::from_fn(|degree| list(record + layout.dense(degree)));
        let mut load = |place: usize| {
            let local = sink.local();
            sink.load(place);
            sink.set(local);
            local
        };
        let [start, size, end, proposed, error] = std::array::from_fn(|place| load(record + place));
        let [time, longest, tolerance, below_peak] =
            [layout.time(), layout.longest(), layout.tolerance(), layout.below_peak()].map(load);
        let mut rates = vec![first];
        rates.extend((1..STAGES).map(|_| sink.list(states)));
        let errors = sink.list(states);
        let [found, growth] = std::array::from_fn(|_| sink.local());
        Self {
            body,
            order,
            time,
            present,
            start,
            size,
            end,
            proposed,
            error,
            found,
            growth,
            longest,
            tolerance,
            below_peak,
            to,
            peaks,
            floors,
            errors,
            dense,
            rates,
        }
    }

    /// Sets the error of an attempt in units of the allowed error, and the factor by which the step after it may grow, at most `most`.
    pub fn find_growth(&self, sink: &mut Sink, most: Local) {
        sink.call_at(Function::Growth, &[self.error, self.found]);
        sink.constant(0.2);
        sink.maximum();
        sink.get(most);
        sink.minimum();
        sink.set(self.growth);
    }

    /// Reduces the size where an error is not allowed. `stall` pops the condition that it is as small as it can be.
    pub fn shrink(&self, sink: &mut Sink, condition: Where, stall: impl FnOnce(&mut Sink)) {
        let [smallest, shrinkage] = std::array::from_fn(|_| sink.local());
        sink.constant(16.0 * f64::EPSILON);
        sink.get(self.end);
        sink.absolute();
        sink.constant(f64::MIN_POSITIVE / f64::EPSILON);
        sink.maximum();
        sink.multiply();
        sink.set(smallest);
        sink.get(self.size);
        sink.get(smallest);
        sink.less_or_equal();
        stall(sink);
        sink.call_at(Function::Shrinkage, &[self.found]);
        sink.set(shrinkage);
        sink.get(self.size);
        sink.get(shrinkage);
        sink.constant(0.2);
        sink.get(shrinkage);
        sink.constant(0.2);
        sink.greater();
        sink.choose();
        sink.multiply();
        sink.get(smallest);
        sink.maximum();
        sink.assign(self.size, condition);
    }

    /// One attempt: the result in the arguments of the right-hand side, and its error.
    pub fn attempt(&self, sink: &mut Sink) {
        sink.each(&self.order.all, |sink, k| {
            // The sum of rates of a constant state is 0.
            sink.get(self.to[k]);
            sink.constant(0.0);
            sink.add();
            sink.set(self.body.state(k));
        });
        for stage in 1..STAGES {
            sink.each(&self.order.moving, |sink, k| {
                sink.get(self.to[k]);
                sink.get(self.size);
                self.weighted(sink, STAGE_WEIGHTS[stage], k);
                sink.multiply();
                sink.add();
                sink.set(self.body.state(k));
            });
            sink.get(self.end);
            sink.constant(NODES[stage]);
            sink.get(self.size);
            sink.multiply();
            sink.add();
            sink.set(self.body.time());
            self.body.evaluate(sink, &self.rates[stage]);
        }
        sink.each(&self.order.moving, |sink, k| {
            self.weighted(sink, &ERROR_WEIGHTS, k);
            sink.get(self.size);
            sink.multiply();
            sink.set(self.errors[k]);
        });
    }

    /// Sets the error in units of the allowed error: root mean square over the states. That of a constant state is 0.
    pub fn find_error(&self, sink: &mut Sink) {
        let sum = sink.local();
        sink.constant(0.0);
        sink.set(sum);
        sink.each_row(&self.order.moving_rows, |sink, states| {
            let squares: Vec<Local> = states.iter().map(|&k| self.square(sink, k)).collect();
            sink.add_in_turn(sum, &squares);
        });
        sink.get(sum);
        sink.constant(self.to.len().max(1) as f64);
        sink.divide();
        sink.square_root();
        sink.set(self.found);
    }

    /// A local variable with the square of the error of state `k` in units of the allowed error.
    fn square(&self, sink: &mut Sink, k: usize) -> Local {
        let [ratio, result] = std::array::from_fn(|_| sink.local());
        sink.get(self.body.state(k));
        sink.set(result);
        sink.get(self.errors[k]);
        sink.get(self.tolerance);
        sink.get(self.to[k]);
        sink.absolute();
        sink.get(result);
        sink.absolute();
        sink.magnitude();
        sink.get(self.below_peak);
        sink.get(self.peaks[k]);
        sink.multiply();
        sink.magnitude();
        sink.get(self.floors[k]);
        sink.magnitude();
        sink.multiply();
        sink.divide();
        sink.set(ratio);
        sink.get(ratio);
        sink.get(ratio);
        sink.multiply();
        sink.constant(f64::NAN);
        // x - x is 0 for finite numbers only.
        sink.get(result);
        sink.get(result);
        sink.subtract();
        sink.constant(0.0);
        sink.equal();
        sink.choose();
        sink.set(ratio);
        ratio
    }

    /// Accepts the attempt.
    pub fn accept(&self, sink: &mut Sink, condition: Where) {
        sink.get(self.end);
        sink.assign(self.start, condition);
        sink.get(self.start);
        sink.get(self.size);
        sink.add();
        sink.assign(self.end, condition);
        sink.get(self.size);
        sink.get(self.growth);
        sink.multiply();
        sink.assign(self.proposed, condition);
        sink.get(self.found);
        sink.constant(1e-4);
        sink.maximum();
        sink.assign(self.error, condition);
        sink.each(&self.order.all, |sink, k| {
            sink.get(self.to[k]);
            sink.assign(self.dense[0][k], condition);
            sink.get(self.body.state(k));
            sink.assign(self.to[k], condition);
        });
        sink.each(&self.order.moving, |sink, k| {
            let [change, bend] = std::array::from_fn(|_| sink.local());
            let [from, c_1, c_2, c_3, c_4] = self.dense.each_ref().map(|list| list[k]);
            let [first, last] = [self.rates[0][k], self.rates[STAGES - 1][k]];
            sink.get(self.to[k]);
            sink.get(from);
            sink.subtract();
            sink.set(change);
            sink.get(change);
            sink.assign(c_1, condition);
            sink.get(self.size);
            sink.get(first);
            sink.multiply();
            sink.get(change);
            sink.subtract();
            sink.set(bend);
            sink.get(bend);
            sink.assign(c_2, condition);
            // change - size * last - bend
            sink.get(change);
            sink.get(self.size);
            sink.get(last);
            sink.multiply();
            sink.subtract();
            sink.get(bend);
            sink.subtract();
            sink.assign(c_3, condition);
            self.weighted(sink, &DENSE_WEIGHTS, k);
            sink.get(self.size);
            sink.multiply();
            sink.assign(c_4, condition);
            sink.get(last);
            sink.assign(first, condition);
            sink.get(self.peaks[k]);
            sink.get(self.to[k]);
            sink.absolute();
            sink.magnitude();
            sink.assign(self.peaks[k], condition);
        });
    }

    /// Numbers of the last step, in the order of a record.
    pub fn clock(&self) -> [Local; 5] {
        [self.start, self.size, self.end, self.proposed, self.error]
    }

    /// Pushes weights . rates of state `k`, summed from the left, starting with 0.
    fn weighted(&self, sink: &mut Sink, weights: &[f64], k: usize) {
        sink.constant(0.0);
        for (&weight, rates) in weights.iter().zip(&self.rates) {
            sink.constant(weight);
            sink.get(rates[k]);
            sink.multiply();
            sink.add();
        }
    }

    /// Sets `state` to the state at the end of the last step if that is at `time`, and to the continuous solution otherwise.
    pub fn state_at_end_or(&self, sink: &mut Sink, time: Local, state: &[Local]) {
        let is_at_end = |sink: &mut Sink| {
            sink.get(time);
            sink.get(self.end);
            sink.equal();
        };
        let at_end = |sink: &mut Sink, condition: Where| {
            sink.each(&self.order.all, |sink, k| {
                sink.get(self.to[k]);
                sink.assign(state[k], condition);
            });
        };
        match sink.values() {
            Values::Numbers => {
                is_at_end(sink);
                sink.begin_if();
                at_end(sink, None);
                sink.otherwise();
                self.state_at(sink, time, state, &self.order.all);
                sink.end();
            }
            Values::Pairs => {
                self.state_at(sink, time, state, &self.order.all);
                let condition = sink.local();
                is_at_end(sink);
                sink.set(condition);
                at_end(sink, Some(condition));
            }
        }
    }

    /// Sets `state` to the continuous solution at `time`, in these ranges.
    pub fn state_at(&self, sink: &mut Sink, time: Local, state: &[Local], ranges: &[Range<usize>]) {
        let [part, rest] = std::array::from_fn(|_| sink.local());
        sink.get(time);
        sink.get(self.start);
        sink.subtract();
        sink.get(self.size);
        sink.divide();
        sink.set(part);
        sink.constant(1.0);
        sink.get(part);
        sink.subtract();
        sink.set(rest);
        sink.each(ranges, |sink, k| {
            let [c_0, c_1, c_2, c_3, c_4] = self.dense.each_ref().map(|list| list[k]);
            if self.order.still[k].is_some() {
                // All other coefficients of a constant state are 0.
                sink.get(c_0);
                sink.constant(0.0);
                sink.add();
                sink.set(state[k]);
                return;
            }
            // c_0 + part * (c_1 + rest * (c_2 + part * (c_3 + rest * c_4)))
            for (coefficient, factor) in [(c_0, part), (c_1, rest), (c_2, part), (c_3, rest)] {
                sink.get(coefficient);
                sink.get(factor);
            }
            sink.get(c_4);
            for _ in 0..4 {
                sink.multiply();
                sink.add();
            }
            sink.set(state[k]);
        });
    }
}
