//! The steps of the fixed-step methods. Each is the one of the engine (`methods/fixed.rs`) with the same operations in the
//! same order.

use crate::body::Body;
use crate::sink::lists::ranges;
use crate::sink::rows::Origin;
use crate::sink::{Local, Sink};
use crate::states::States;
use crate::{lanes, runs, window};
use engine::tableau::STAGES;
use engine::{LANES, LanesListing, Listing, Method, WindowLayout, WindowListing};

/// Number of operations of a step, about.
pub(crate) fn operations(listing: &Listing) -> usize {
    let (stages, sums) = match listing.method {
        Method::Euler => (1, 2),
        Method::EulerRichardson => (2, 4),
        Method::VelocityVerlet => (2, 8),
        Method::RungeKutta4 => (4, 14),
        Method::DormandPrince | Method::Rosenbrock => (STAGES - 1, 84),
    };
    let moving = listing.still.iter().filter(|still| still.is_none()).count();
    // Conditions are evaluated once, and compared values two times.
    let of_checks = |window: &WindowListing| {
        let lines = window.formulas.each_ref().map(|formulas| formulas.lines.len());
        lines.iter().sum::<usize>() + lines[2] + lines[3] + 12 * listing.states.len()
    };
    let checks = listing.window.as_ref().map_or(0, of_checks);
    stages * listing.lines.len() + sums * moving + stages * (listing.states.len() - moving) + checks
}

/// Number of operations and loops of the functions for a step with lists in memory, about.
pub(crate) fn loops(listing: &Listing) -> usize {
    let formulas = listing.window.iter().flat_map(|window| &window.formulas).map(|formulas| formulas.lines.len());
    // Lists in the order of the model are loaded and stored number by number: states, and the records of steps with control.
    let lists = if listing.window.is_some() { WindowLayout::OWN } else { 2 };
    runs::count(&listing.lines) + formulas.sum::<usize>() + lists * listing.states.len()
}

/// Emits the loop over the steps.
pub(crate) fn steps(listing: &Listing, sink: &mut Sink) {
    if let Some(window) = &listing.window {
        return window::intervals(listing, window, sink);
    }
    let layout = listing.layout;
    let step = Step::load(listing, sink);
    sink.repeat(&step.states, |sink| {
        step.make(sink);
        sink.store_lists(&step.order.rows, &step.order.index, Origin::Row, &[(layout.row(0), &step.states)]);
    });
}

/// Emits the loop over the steps of runs side by side.
pub(crate) fn steps_side_by_side(listing: &LanesListing, sink: &mut Sink) {
    if let Some(window) = &listing.steps.window {
        return lanes::rounds(listing, window, sink);
    }
    let layout = listing.layout;
    sink.repeat_for_pairs(LANES / 2, layout.places(), layout.values, |sink| {
        let step = Step::load(&listing.steps, sink);
        step.make(sink);
        for (k, &state) in step.states.iter().enumerate() {
            sink.store(layout.steps.from() + k, state);
        }
        let values = sink.locals(layout.values);
        let readings = Body::of_formulas(&listing.readings, &step.order.index, layout.readings(), sink);
        sink.get(step.first);
        sink.made();
        sink.constant(1.0);
        sink.add();
        sink.add();
        sink.get(step.spacing);
        sink.multiply();
        sink.set(step.time);
        readings.evaluate_at(sink, step.time, &step.states, &values);
        for (number, &value) in values.iter().enumerate() {
            sink.address(Origin::Row);
            sink.store_at(layout.row(0) + number, value);
        }
    });
}

/// A step: its start, its rates, and the states, which it changes.
struct Step<'a> {
    listing: &'a Listing,
    body: Body<'a>,
    order: States,
    /// Number of the first step, and distance of the times at which steps begin.
    first: Local,
    spacing: Local,
    time: Local,
    size: Local,
    states: Vec<Local>,
    /// Rates of each stage.
    rates: Vec<Vec<Local>>,
}

impl<'a> Step<'a> {
    /// Loads the states at the start.
    fn load(listing: &'a Listing, sink: &mut Sink) -> Self {
        let layout = listing.layout;
        let order = States::of(listing, sink.in_block());
        let body = Body::of_rates(listing, &order, sink);
        let [first, spacing, size, time] = std::array::from_fn(|_| sink.local());
        for (local, place) in [(first, layout.first()), (spacing, layout.spacing()), (size, layout.size())] {
            sink.load(place);
            sink.set(local);
        }
        let states = sink.load_list(&order.rows, &order.index, layout.from());
        let stages = match listing.method {
            Method::Euler => 1,
            Method::EulerRichardson | Method::VelocityVerlet => 2,
            Method::RungeKutta4 | Method::DormandPrince | Method::Rosenbrock => 4,
        };
        let rates = (0..stages).map(|_| sink.list(layout.states)).collect();
        Self { listing, body, order, first, spacing, time, size, states, rates }
    }

    /// Makes the step.
    fn make(&self, sink: &mut Sink) {
        sink.get(self.first);
        sink.made();
        sink.add();
        sink.get(self.spacing);
        sink.multiply();
        sink.set(self.time);
        match self.listing.method {
            Method::Euler => self.euler(sink),
            Method::EulerRichardson => self.euler_richardson(sink),
            Method::VelocityVerlet => self.velocity_verlet(sink, &self.listing.pairs),
            // Listings of the Dormand-Prince method have a window, and those of the stiff method do not exist.
            Method::RungeKutta4 | Method::DormandPrince | Method::Rosenbrock => self.runge_kutta(sink),
        }
    }

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
        let places = &self.order.places;
        let mut velocities = vec![None; places.len()];
        pairs.iter().for_each(|&(position, velocity)| velocities[places[position]] = Some(places[velocity]));
        let in_turn = velocities.iter().enumerate();
        let pairs: Vec<_> = in_turn.filter_map(|(position, velocity)| Some((position, (*velocity)?))).collect();
        let pairs_in_turn = ranges(pairs.len(), |a, b| (pairs[a].0 + 1, pairs[a].1 + 1) == pairs[b]);
        sink.each(&pairs_in_turn, |sink, pair| {
            let (position, velocity) = pairs[pair];
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
        });
        self.evaluate(sink, Some(self.size), 1);
        sink.each(&pairs_in_turn, |sink, pair| {
            let (position, velocity) = pairs[pair];
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
        });
    }

    fn runge_kutta(&self, sink: &mut Sink) {
        let half = self.scaled_size(sink, 0.5);
        let sixth = sink.local();
        sink.get(self.size);
        sink.constant(6.0);
        sink.divide();
        sink.set(sixth);
        self.evaluate_at_start(sink);
        for (stage, part) in [(1, half), (2, half), (3, self.size)] {
            self.advance(sink, part, stage - 1);
            self.evaluate(sink, Some(part), stage);
        }
        sink.each(&self.order.all, |sink, k| {
            // from + sixth * (k_1 + 2.0 * k_2 + 2.0 * k_3 + k_4)
            sink.get(self.states[k]);
            if let Some(zero) = self.order.still[k] {
                sink.constant(zero);
                sink.add();
                sink.set(self.states[k]);
                return;
            }
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
            sink.set(self.states[k]);
        });
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
        sink.each(&self.order.all, |sink, k| {
            sink.get(self.states[k]);
            sink.set(self.body.state(k));
        });
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
        // Constant states are set in the first stage.
        let set = if stage == 0 { &self.order.all } else { &self.order.moving };
        sink.each(set, |sink, k| {
            self.moved(sink, self.states[k], size, (stage, k));
            sink.set(self.body.state(k));
        });
    }

    /// Sets the states to states + size * rates of a stage.
    fn finish(&self, sink: &mut Sink, size: Local, stage: usize) {
        sink.each(&self.order.all, |sink, k| {
            self.moved(sink, self.states[k], size, (stage, k));
            sink.set(self.states[k]);
        });
    }

    /// Pushes state + size * rate of state `k` at a stage.
    fn moved(&self, sink: &mut Sink, state: Local, size: Local, (stage, k): (usize, usize)) {
        if let Some(zero) = self.order.still[k] {
            sink.get(state);
            sink.constant(zero);
            sink.add();
        } else {
            multiply_add(sink, state, size, self.rates[stage][k]);
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
