//! Steps of the Dormand-Prince method with step control and continuous solution, as the engine makes them
//! (`engine/methods/adaptive.rs`, `engine/methods/dormand_prince.rs`), with the same operations in the same order.

use crate::body::Body;
use crate::function::Function;
use crate::sink::{Local, Sink};
use engine::tableau::{DENSE_WEIGHTS, ERROR_WEIGHTS, NODES, STAGE_WEIGHTS, STAGES};
use engine::{Listing, WindowLayout};

/// The steps: local variables of the last one, of the state, and of the attempt that is made.
pub(crate) struct Step<'a> {
    body: Body<'a>,
    moving: Vec<usize>,
    /// Time reached, and the state there.
    pub time: Local,
    pub present: Vec<Local>,
    /// Start, size and end of the last step.
    start: Local,
    size: Local,
    pub end: Local,
    proposed: Local,
    error: Local,
    longest: Local,
    tolerance: Local,
    below_peak: Local,
    attempts: Local,
    /// Number of steps made.
    pub steps: Local,
    /// State at the end of the last step.
    to: Vec<Local>,
    peaks: Vec<Local>,
    floors: Vec<Local>,
    errors: Vec<Local>,
    /// Coefficients of the continuous solution, by degree.
    dense: [Vec<Local>; 5],
    /// Rates of each stage.
    rates: Vec<Vec<Local>>,
}

impl<'a> Step<'a> {
    pub fn load(listing: &'a Listing, layout: WindowLayout, sink: &mut Sink) -> Self {
        let (record, states) = (layout.record(0), layout.states);
        let moving: Vec<usize> = (0..states).filter(|&k| listing.still[k].is_none()).collect();
        let body = Body::of_rates(listing, sink);
        let mut load = |place: usize| {
            let local = sink.local();
            sink.load(place);
            sink.set(local);
            local
        };
        let mut list = |place: usize| -> Vec<Local> { (0..states).map(|k| load(place + k)).collect() };
        let (present, floors) = (list(layout.present()), list(layout.floors()));
        let (to, peaks) = (list(record + layout.to()), list(record + layout.peaks()));
        let first = list(record + layout.rates());
        let dense = std::array::from_fn(|degree| list(record + layout.dense(degree)));
        let [start, size, end, proposed, error] = std::array::from_fn(|place| load(record + place));
        let [time, longest, tolerance, below_peak] =
            [layout.time(), layout.longest(), layout.tolerance(), layout.below_peak()].map(load);
        let mut rates = vec![first];
        rates.extend((1..STAGES).map(|_| sink.locals(states)));
        let errors = sink.locals(states);
        let [attempts, steps] = std::array::from_fn(|_| sink.local());
        Self {
            body,
            moving,
            time,
            present,
            start,
            size,
            end,
            proposed,
            error,
            longest,
            tolerance,
            below_peak,
            attempts,
            steps,
            to,
            peaks,
            floors,
            errors,
            dense,
            rates,
        }
    }

    /// Makes a step from the end of the last one, or the single attempt of the size given.
    pub fn make(&self, sink: &mut Sink, layout: WindowLayout) {
        let [most, growth, found] = std::array::from_fn(|_| sink.local());
        sink.count();
        sink.begin_if();
        sink.get(self.steps);
        sink.constant(layout.steps as f64);
        sink.instructions().f64_ge();
        sink.leave_if();
        sink.instructions().local_get(self.proposed).local_get(self.longest).f64_min().local_set(self.size);
        sink.end();
        sink.constant(10.0);
        sink.set(most);
        sink.begin_block();
        let accepted = sink.label();
        sink.begin_repeat();
        let again = sink.label();
        sink.increase(self.attempts);
        self.attempt(sink);
        sink.count();
        sink.instructions().i32_eqz();
        sink.branch_if(accepted);
        self.error_norm(sink, found);
        sink.instructions().local_get(found).f64_const(1.0.into()).f64_le();
        sink.begin_if();
        sink.get(self.error);
        sink.get(found);
        sink.call(Function::Growth);
        sink.instructions().f64_const(0.2.into()).f64_max().local_get(most).f64_min().local_set(growth);
        sink.instructions().local_get(found).f64_const(1e-4.into()).f64_max().local_set(self.error);
        sink.branch(accepted);
        sink.end();
        self.shrink(sink, found);
        sink.constant(1.0);
        sink.set(most);
        sink.branch(again);
        sink.end();
        sink.end();
        self.accept(sink, layout, growth);
    }

    /// Reduces the size after an error that is not allowed. Leaves if it is too small.
    fn shrink(&self, sink: &mut Sink, found: Local) {
        let [smallest, shrinkage] = std::array::from_fn(|_| sink.local());
        sink.constant(16.0 * f64::EPSILON);
        sink.instructions().local_get(self.end).f64_abs().f64_const((f64::MIN_POSITIVE / f64::EPSILON).into());
        sink.instructions().f64_max().f64_mul().local_set(smallest);
        sink.instructions().local_get(self.size).local_get(smallest).f64_le();
        sink.leave_if();
        sink.get(found);
        sink.call(Function::Shrinkage);
        sink.set(shrinkage);
        sink.instructions().local_get(self.size).local_get(shrinkage).f64_const(0.2.into()).local_get(shrinkage);
        sink.instructions().f64_const(0.2.into()).f64_gt().select().f64_mul();
        sink.instructions().local_get(smallest).f64_max().local_set(self.size);
    }

    /// One attempt: the result in the arguments of the right-hand side, and its error.
    fn attempt(&self, sink: &mut Sink) {
        for (k, &to) in self.to.iter().enumerate() {
            // The sum of rates of a constant state is 0.
            sink.get(to);
            sink.constant(0.0);
            sink.add();
            sink.set(self.body.state(k));
        }
        for stage in 1..STAGES {
            for &k in &self.moving {
                sink.get(self.to[k]);
                sink.get(self.size);
                self.weighted(sink, STAGE_WEIGHTS[stage], k);
                sink.multiply();
                sink.add();
                sink.set(self.body.state(k));
            }
            sink.instructions().local_get(self.end).f64_const(NODES[stage].into()).local_get(self.size);
            sink.multiply();
            sink.add();
            sink.set(self.body.time());
            self.body.evaluate(sink, &self.rates[stage]);
        }
        for &k in &self.moving {
            self.weighted(sink, &ERROR_WEIGHTS, k);
            sink.get(self.size);
            sink.multiply();
            sink.set(self.errors[k]);
        }
    }

    /// Error in units of the allowed error: root mean square over the states. That of a constant state is 0.
    fn error_norm(&self, sink: &mut Sink, norm: Local) {
        let [ratio, result] = std::array::from_fn(|_| sink.local());
        sink.constant(0.0);
        for &k in &self.moving {
            sink.get(self.body.state(k));
            sink.set(result);
            sink.get(self.errors[k]);
            sink.get(self.tolerance);
            sink.instructions().local_get(self.to[k]).f64_abs().local_get(result).f64_abs().f64_max();
            sink.instructions().local_get(self.below_peak).local_get(self.peaks[k]).f64_mul().f64_max();
            sink.instructions().local_get(self.floors[k]).f64_max().f64_mul().f64_div().local_set(ratio);
            sink.instructions().local_get(ratio).local_get(ratio).f64_mul().f64_const(f64::NAN.into());
            // x - x is 0 for finite numbers only.
            sink.instructions().local_get(result).local_get(result).f64_sub().f64_const(0.0.into()).f64_eq().select();
            sink.add();
        }
        sink.constant(self.to.len().max(1) as f64);
        sink.instructions().f64_div().f64_sqrt().local_set(norm);
    }

    /// Accepts the attempt, and stores it as the next record.
    fn accept(&self, sink: &mut Sink, layout: WindowLayout, growth: Local) {
        let record = layout.record(0);
        let [from, change, bend, first, ..] = std::array::from_fn::<Local, 4, _>(|_| sink.local());
        sink.increase(self.steps);
        sink.next_record(layout.record_len());
        sink.get(self.end);
        sink.set(self.start);
        sink.instructions().local_get(self.start).local_get(self.size).f64_add().local_set(self.end);
        sink.instructions().local_get(self.size).local_get(growth).f64_mul().local_set(self.proposed);
        for (k, &to) in self.to.iter().enumerate() {
            sink.get(to);
            sink.set(self.dense[0][k]);
            sink.get(self.body.state(k));
            sink.set(to);
        }
        for &k in &self.moving {
            let [_, c_1, c_2, c_3, c_4] = self.dense.each_ref().map(|list| list[k]);
            let last = self.rates[STAGES - 1][k];
            sink.get(self.dense[0][k]);
            sink.set(from);
            sink.get(self.rates[0][k]);
            sink.set(first);
            sink.instructions().local_get(self.to[k]).local_get(from).f64_sub().local_tee(change).local_set(c_1);
            sink.instructions().local_get(self.size).local_get(first).f64_mul().local_get(change).f64_sub();
            sink.instructions().local_tee(bend).local_set(c_2);
            // change - size * last - bend
            sink.instructions().local_get(change).local_get(self.size).local_get(last).f64_mul().f64_sub();
            sink.instructions().local_get(bend).f64_sub().local_set(c_3);
            self.weighted(sink, &DENSE_WEIGHTS, k);
            sink.instructions().local_get(self.size).f64_mul().local_set(c_4);
            sink.get(last);
            sink.set(self.rates[0][k]);
            sink.instructions().local_get(self.peaks[k]).local_get(self.to[k]).f64_abs().f64_max();
            sink.set(self.peaks[k]);
            for (degree, list) in self.dense.iter().enumerate() {
                sink.store_in_record(record + layout.dense(degree) + k, list[k]);
            }
            sink.store_in_record(record + layout.to() + k, self.to[k]);
            sink.store_in_record(record + layout.peaks() + k, self.peaks[k]);
            sink.store_in_record(record + layout.rates() + k, last);
        }
        let numbers = [self.start, self.size, self.end, self.proposed, self.error, self.attempts];
        for (place, local) in numbers.into_iter().enumerate() {
            sink.store_in_record(record + place, local);
        }
        sink.count();
        sink.instructions().i32_eqz();
        sink.begin_if();
        for &k in &self.moving {
            sink.store(layout.error() + k, self.errors[k]);
        }
        sink.leave();
        sink.end();
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
        sink.instructions().local_get(time).local_get(self.end).f64_eq();
        sink.begin_if();
        for (&to, &state) in self.to.iter().zip(state) {
            sink.get(to);
            sink.set(state);
        }
        sink.otherwise();
        self.state_at(sink, time, state);
        sink.end();
    }

    /// Sets `state` to the continuous solution at `time`.
    pub fn state_at(&self, sink: &mut Sink, time: Local, state: &[Local]) {
        let [part, rest] = std::array::from_fn(|_| sink.local());
        sink.instructions().local_get(time).local_get(self.start).f64_sub().local_get(self.size).f64_div();
        sink.set(part);
        sink.instructions().f64_const(1.0.into()).local_get(part).f64_sub().local_set(rest);
        for (k, &state) in state.iter().enumerate() {
            let [c_0, c_1, c_2, c_3, c_4] = self.dense.each_ref().map(|list| list[k]);
            if self.moving.binary_search(&k).is_err() {
                // All other coefficients of a constant state are 0.
                sink.instructions().local_get(c_0).f64_const(0.0.into()).f64_add().local_set(state);
                continue;
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
            sink.set(state);
        }
    }
}
