//! The steps of the methods. Each is the one of the engine (`methods/fixed.rs`, `methods/dormand_prince.rs`) with the same
//! operations in the same order.

use crate::body::Body;
use crate::sink::{Local, Sink};
use engine::tableau::{DENSE_WEIGHTS, ERROR_WEIGHTS, NODES, STAGE_WEIGHTS, STAGES};
use engine::{Listing, Method};

/// Number of operations of a step, about.
pub(crate) fn operations(listing: &Listing) -> usize {
    let (stages, sums) = match listing.method {
        Method::Euler => (1, 2),
        Method::EulerRichardson => (2, 4),
        Method::VelocityVerlet => (2, 8),
        Method::RungeKutta4 => (4, 14),
        Method::DormandPrince | Method::Rosenbrock => (STAGES - 1, 84),
    };
    stages * listing.lines.len() + sums * listing.states.len()
}

/// Emits the loop over the steps.
pub(crate) fn steps(listing: &Listing, sink: &mut Sink) {
    let layout = listing.layout;
    let body = Body::new(listing, sink);
    let [first, spacing, size, time] = std::array::from_fn(|_| sink.local());
    for (local, place) in [(first, layout.first()), (spacing, layout.spacing()), (size, layout.size())] {
        sink.load(place);
        sink.set(local);
    }
    let states = sink.locals(layout.states);
    for (k, &state) in states.iter().enumerate() {
        sink.load(layout.from() + k);
        sink.set(state);
    }
    let stages = match listing.method {
        Method::Euler => 1,
        Method::EulerRichardson | Method::VelocityVerlet => 2,
        Method::RungeKutta4 => 4,
        Method::DormandPrince | Method::Rosenbrock => STAGES,
    };
    let rates = (0..stages).map(|_| sink.locals(layout.states)).collect();
    let step = Step { body, time, size, states: states.clone(), rates };
    sink.repeat(&states, |sink| {
        sink.get(first);
        sink.made();
        sink.add();
        sink.get(spacing);
        sink.multiply();
        sink.set(time);
        match listing.method {
            Method::Euler => step.euler(sink),
            Method::EulerRichardson => step.euler_richardson(sink),
            Method::VelocityVerlet => step.velocity_verlet(sink, &listing.pairs),
            Method::RungeKutta4 => step.runge_kutta(sink),
            // Listings of the stiff method do not exist.
            Method::DormandPrince | Method::Rosenbrock => step.dormand_prince(sink, listing),
        }
        for (k, &state) in states.iter().enumerate() {
            sink.store_in_row(layout.row(0) + k, state);
        }
    });
}

/// A step: local variables of its start, of its rates, and of the states, which it changes.
struct Step<'a> {
    body: Body<'a>,
    time: Local,
    size: Local,
    states: Vec<Local>,
    /// Rates of each stage.
    rates: Vec<Vec<Local>>,
}

impl Step<'_> {
    fn euler(&self, sink: &mut Sink) {
        self.evaluate_at_start(sink);
        self.finish(sink, self.size, 0);
    }

    fn euler_richardson(&self, sink: &mut Sink) {
        let half = self.scaled_size(sink, 0.5);
        self.evaluate_at_start(sink);
        self.advance(sink, half, 0);
        self.evaluate(sink, Some(half), 1);
        self.finish(sink, self.size, 1);
    }

    fn velocity_verlet(&self, sink: &mut Sink, pairs: &[(usize, usize)]) {
        let half = self.scaled_size(sink, 0.5);
        self.evaluate_at_start(sink);
        let [start, end] = [&self.rates[0], &self.rates[1]];
        for (k, &state) in self.states.iter().enumerate() {
            sink.get(state);
            sink.set(self.body.state(k));
        }
        for &(position, velocity) in pairs {
            let (from, to) = (&self.states, |k: usize| self.body.state(k));
            // from[position] + size * (from[velocity] + 0.5 * size * acceleration)
            for local in [from[position], self.size, from[velocity], half, start[velocity]] {
                sink.get(local);
            }
            sink.multiply();
            sink.add();
            sink.multiply();
            sink.add();
            sink.set(to(position));
            // from[velocity] + size * acceleration
            multiply_add(sink, from[velocity], self.size, start[velocity]);
            sink.set(to(velocity));
        }
        self.evaluate(sink, Some(self.size), 1);
        for &(position, velocity) in pairs {
            sink.get(self.body.state(position));
            sink.set(self.states[position]);
            // from[velocity] + 0.5 * size * (start[velocity] + end[velocity])
            for local in [self.states[velocity], half, start[velocity], end[velocity]] {
                sink.get(local);
            }
            sink.add();
            sink.multiply();
            sink.add();
            sink.set(self.states[velocity]);
        }
    }

    fn runge_kutta(&self, sink: &mut Sink) {
        let half = self.scaled_size(sink, 0.5);
        let sixth = sink.local();
        sink.instructions().local_get(self.size).f64_const(6.0.into()).f64_div().local_set(sixth);
        self.evaluate_at_start(sink);
        for (stage, part) in [(1, half), (2, half), (3, self.size)] {
            self.advance(sink, part, stage - 1);
            self.evaluate(sink, Some(part), stage);
        }
        for (k, &state) in self.states.iter().enumerate() {
            // from + sixth * (k_1 + 2.0 * k_2 + 2.0 * k_3 + k_4)
            sink.get(state);
            sink.get(sixth);
            sink.get(self.rates[0][k]);
            for stage in [1, 2] {
                sink.constant(2.0);
                sink.get(self.rates[stage][k]);
                sink.multiply();
                sink.add();
            }
            sink.get(self.rates[3][k]);
            sink.add();
            sink.multiply();
            sink.add();
            sink.set(state);
        }
    }

    /// One attempt; the rates of the first stage are given in the block, those of the last one, the error and the
    /// coefficients of the continuous solution are stored there.
    fn dormand_prince(&self, sink: &mut Sink, listing: &Listing) {
        let layout = listing.layout;
        for (k, &rate) in self.rates[0].iter().enumerate() {
            sink.load(layout.first_rates() + k);
            sink.set(rate);
        }
        for stage in 1..STAGES {
            for k in 0..self.states.len() {
                sink.get(self.states[k]);
                sink.get(self.size);
                self.weighted(sink, STAGE_WEIGHTS[stage], k);
                sink.multiply();
                sink.add();
                sink.set(self.body.state(k));
            }
            sink.instructions().local_get(self.time).f64_const(NODES[stage].into()).local_get(self.size);
            sink.multiply();
            sink.add();
            sink.set(self.body.time());
            self.body.evaluate(sink, &self.rates[stage]);
        }
        let [result, change, bend] = std::array::from_fn(|_| sink.local());
        for (k, &state) in self.states.iter().enumerate() {
            let [first, last] = [self.rates[0][k], self.rates[STAGES - 1][k]];
            sink.store(layout.last_rates() + k, last);
            self.weighted(sink, &ERROR_WEIGHTS, k);
            sink.get(self.size);
            sink.multiply();
            sink.set(result);
            sink.store(layout.error() + k, result);
            sink.store(layout.dense(0) + k, state);
            // The last stage is evaluated at the result.
            let to = self.body.state(k);
            sink.instructions().local_get(to).local_get(state).f64_sub().local_set(change);
            sink.store(layout.dense(1) + k, change);
            sink.instructions().local_get(self.size).local_get(first).f64_mul().local_get(change).f64_sub();
            sink.set(bend);
            sink.store(layout.dense(2) + k, bend);
            // change - size * last - bend
            sink.instructions().local_get(change).local_get(self.size).local_get(last).f64_mul().f64_sub();
            sink.instructions().local_get(bend).f64_sub().local_set(result);
            sink.store(layout.dense(3) + k, result);
            self.weighted(sink, &DENSE_WEIGHTS, k);
            sink.get(self.size);
            sink.multiply();
            sink.set(result);
            sink.store(layout.dense(4) + k, result);
            sink.get(to);
            sink.set(state);
        }
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

    /// A local variable with `part * size`.
    fn scaled_size(&self, sink: &mut Sink, part: f64) -> Local {
        let local = sink.local();
        sink.constant(part);
        sink.get(self.size);
        sink.multiply();
        sink.set(local);
        local
    }

    /// Evaluates the rates of the first stage at the start of the step.
    fn evaluate_at_start(&self, sink: &mut Sink) {
        for (k, &state) in self.states.iter().enumerate() {
            sink.get(state);
            sink.set(self.body.state(k));
        }
        self.evaluate(sink, None, 0);
    }

    /// Evaluates the rates of `stage` at the arguments of the right-hand side, `since` after the start of the step.
    fn evaluate(&self, sink: &mut Sink, since: Option<Local>, stage: usize) {
        sink.get(self.time);
        if let Some(since) = since {
            sink.get(since);
            sink.add();
        }
        sink.set(self.body.time());
        self.body.evaluate(sink, &self.rates[stage]);
    }

    /// Sets the arguments of the right-hand side to states + size * rates of a stage.
    fn advance(&self, sink: &mut Sink, size: Local, stage: usize) {
        for (k, &state) in self.states.iter().enumerate() {
            multiply_add(sink, state, size, self.rates[stage][k]);
            sink.set(self.body.state(k));
        }
    }

    /// Sets the states to states + size * rates of a stage.
    fn finish(&self, sink: &mut Sink, size: Local, stage: usize) {
        for (k, &state) in self.states.iter().enumerate() {
            multiply_add(sink, state, size, self.rates[stage][k]);
            sink.set(state);
        }
    }
}

/// Pushes start + a * b.
fn multiply_add(sink: &mut Sink, start: Local, a: Local, b: Local) {
    sink.get(start);
    sink.get(a);
    sink.get(b);
    sink.multiply();
    sink.add();
}
