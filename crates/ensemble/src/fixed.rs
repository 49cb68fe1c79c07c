//! Steps of fixed-step methods in lanes, with the operations of the engine in its order.

use crate::body::Body;
use crate::grid::{Block, Grid, one};
use crate::width::{Lanewise, Width};
use program::Method;

/// A fixed-step method with the states of all lanes.
#[derive(Clone, Debug)]
pub struct Fixed {
    method: Method,
    /// For velocity Verlet, the indices of each position and its velocity.
    pairs: Vec<(usize, usize)>,
    /// Where the rate of each state is.
    sources: Vec<Source>,
    /// States at the start of a step, one row for each.
    pub states: Grid,
    /// Sums of rates, or the rates of an earlier stage.
    sums: Grid,
    /// Rates that are themselves states which are overwritten before they are used.
    copies: Grid,
}

/// Register of a rate.
#[derive(Clone, Copy, Debug)]
enum Source {
    /// A result.
    Computed(usize),
    /// The register of a state that is overwritten later, behind that of the own state.
    Later(usize),
    /// The independent variable or the register of another state, which is copied.
    Copied(usize),
}

/// What follows from a rate besides the next state.
#[derive(Clone, Copy, PartialEq)]
enum Kept {
    Nothing,
    /// The sum of rates.
    Sum,
    /// The state, as the start of the next step.
    Start,
}

impl Fixed {
    /// A method without lanes, for these rates.
    pub fn new(method: Method, pairs: Vec<(usize, usize)>, rates: &Body) -> Self {
        let (states, roots) = (rates.states(), rates.roots());
        let source = |(number, &root): (usize, &u32)| {
            let later = states[number + 1..].contains(&root) && root > states[number];
            match root as usize {
                root if root > states.len() => Source::Computed(root),
                root if later => Source::Later(root),
                root => Source::Copied(root),
            }
        };
        let sources = roots.iter().enumerate().map(source).collect();
        let [states, sums, copies] = std::array::from_fn(|_| Grid::default());
        Self { method, pairs, sources, states, sums, copies }
    }

    /// Makes room for so many blocks of lanes.
    pub fn resize(&mut self, blocks: usize) {
        let states = self.sources.len();
        for grid in [&mut self.states, &mut self.sums, &mut self.copies] {
            *grid = Grid::new(states, blocks);
        }
    }

    /// Begins all lanes with these states, SI units.
    #[inline(always)]
    pub fn begin(&mut self, rates: &mut Body, states: &Grid) {
        self.states.clone_from(states);
        rates.set_states(states);
    }

    /// Makes one step of `size` from `time`, SI units, with these features.
    pub fn step(&mut self, width: Width, rates: &mut Body, time: f64, size: f64) {
        width.call::<Step>((self, rates, time, size));
    }

    #[inline(always)]
    fn step_in((own, rates, time, size): (&mut Self, &mut Body, f64, f64)) {
        let half = 0.5 * size;
        own.evaluate(rates, time);
        match own.method {
            Method::Euler => own.each(rates, Kept::Start, |[from, _], rate| [from + size * rate, 0.0]),
            Method::EulerRichardson => {
                own.each(rates, Kept::Nothing, |[from, _], rate| [from + half * rate, 0.0]);
                own.evaluate(rates, time + half);
                own.each(rates, Kept::Start, |[from, _], rate| [from + size * rate, 0.0]);
            }
            Method::VelocityVerlet => own.verlet(rates, time, size),
            // The adaptive methods are not handled here.
            Method::RungeKutta4 | Method::DormandPrince | Method::Rosenbrock => {
                let sixth = size / 6.0;
                own.each(rates, Kept::Sum, |[from, _], rate| [from + half * rate, rate]);
                own.evaluate(rates, time + half);
                own.each(rates, Kept::Sum, |[from, sum], rate| [from + half * rate, sum + 2.0 * rate]);
                own.evaluate(rates, time + half);
                own.each(rates, Kept::Sum, |[from, sum], rate| [from + size * rate, sum + 2.0 * rate]);
                own.evaluate(rates, time + size);
                own.each(rates, Kept::Start, |[from, sum], rate| [from + sixth * (sum + rate), 0.0]);
            }
        }
    }

    /// Continues a lane with these states, SI units.
    pub fn load(&mut self, rates: &mut Body, lane: usize, states: &[f64]) {
        self.states.set_lane(lane, states);
        for (number, state) in states.iter().enumerate() {
            let register = rates.states()[number] as usize;
            rates.grid_mut().set(register, lane, *state);
        }
    }

    /// True for a lane in which a state is not finite; it is then not finite after any further steps either.
    pub fn is_wrong(&self, lane: usize) -> bool {
        (0..self.states.rows()).any(|state| !self.states.get(state, lane).is_finite())
    }

    /// Evaluates the rates at `time` and the states in the registers.
    #[inline(always)]
    fn evaluate(&mut self, rates: &mut Body, time: f64) {
        if rates.reads_time() {
            rates.grid_mut().fill(0, time);
        }
        rates.evaluate();
        for (number, source) in self.sources.iter().enumerate() {
            if let Source::Copied(root) = *source {
                self.copies.row_mut(number).copy_from_slice(rates.grid().row(root));
            }
        }
    }

    /// Computes a state and a sum from the state at the start, the sum so far and the rate. The state goes to the registers.
    #[inline(always)]
    fn each(&mut self, rates: &mut Body, kept: Kept, operation: impl Fn([f64; 2], f64) -> [f64; 2]) {
        let blocks = self.states.blocks();
        for (number, source) in self.sources.iter().enumerate() {
            let register = rates.states()[number] as usize;
            let (first, rate) = match *source {
                Source::Computed(root) | Source::Later(root) => {
                    let (before, rate) = rates.grid_mut().split(root);
                    (before, &rate[..blocks])
                }
                Source::Copied(_) => (rates.grid_mut().split(register + 1).0, self.copies.row(number)),
            };
            let present = &mut first[register * blocks..][..blocks];
            let (start, sums) = (self.states.row_mut(number), self.sums.row_mut(number));
            for (((start, sum), present), rate) in start.iter_mut().zip(sums).zip(present).zip(rate) {
                let (from, before, rate) = (*start, *sum, *rate);
                let computed = |lane: usize| operation([from.0[lane], before.0[lane]], rate.0[lane]);
                let state = Block::each(|lane| computed(lane)[0]);
                *present = state;
                match kept {
                    Kept::Nothing => {}
                    Kept::Sum => *sum = Block::each(|lane| computed(lane)[1]),
                    Kept::Start => *start = state,
                }
            }
        }
    }

    #[inline(always)]
    fn verlet(&mut self, rates: &mut Body, time: f64, size: f64) {
        // Rates at the start, and then the predicted states.
        for (number, &root) in rates.roots().iter().enumerate() {
            self.sums.row_mut(number).copy_from_slice(rates.grid().row(root as usize));
        }
        for &(position, velocity) in &self.pairs {
            for block in 0..self.states.blocks() {
                let acceleration = self.sums.row(velocity)[block];
                let [x, v] = [position, velocity].map(|state| self.states.row(state)[block]);
                let predicted = [
                    Block::each(|lane| x.0[lane] + size * (v.0[lane] + 0.5 * size * acceleration.0[lane])),
                    Block::each(|lane| v.0[lane] + size * acceleration.0[lane]),
                ];
                for (state, predicted) in [position, velocity].into_iter().zip(predicted) {
                    let register = rates.states()[state] as usize;
                    rates.grid_mut().row_mut(register)[block] = predicted;
                }
            }
        }
        for &(position, _) in &self.pairs {
            let register = rates.states()[position] as usize;
            one(self.states.row_mut(position), rates.grid().row(register), |x| x);
        }
        rates.grid_mut().fill(0, time + size);
        rates.evaluate();
        for &(_, velocity) in &self.pairs {
            let end = rates.grid().row(rates.roots()[velocity] as usize);
            let (start, state) = (self.sums.row(velocity), self.states.row_mut(velocity));
            for ((state, start), end) in state.iter_mut().zip(start).zip(end) {
                let (before, start, end) = (*state, *start, *end);
                *state = Block::each(|lane| before.0[lane] + 0.5 * size * (start.0[lane] + end.0[lane]));
            }
        }
        rates.set_states(&self.states);
    }
}

/// [`Fixed::step_in`] for all features.
struct Step;

impl Lanewise for Step {
    type Arguments<'a> = (&'a mut Fixed, &'a mut Body, f64, f64);

    #[inline(always)]
    fn call(arguments: Self::Arguments<'_>) {
        Fixed::step_in(arguments);
    }
}
