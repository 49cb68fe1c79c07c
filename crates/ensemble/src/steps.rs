//! Steps of the Dormand-Prince method in lanes, each with its own time and step size, as the engine makes them: the same operations
//! in the same order.

use crate::body::Body;
use crate::clock::Clock;
use crate::grid::{Block, Grid, Mask, WIDTH};
use crate::width::{Lanewise, Width};
use engine::tableau::{DENSE_WEIGHTS, ERROR_WEIGHTS, NODES, STAGE_WEIGHTS, STAGES};
use engine::{LastStep, StepControl};

/// The last steps of all lanes.
#[derive(Clone, Debug)]
pub struct Steps {
    control: StepControl,
    clocks: Vec<Clock>,
    /// States at the end of the last step.
    pub to: Grid,
    peaks: Grid,
    /// Rates of all stages, for each state and block.
    stages: Vec<[Block; STAGES]>,
    /// Coefficients of the continuous solution, for each state and block.
    dense: Vec<[Block; 5]>,
    /// True if the rates of the first stage must be computed.
    unknown: Vec<bool>,
}

impl Steps {
    /// Steps without lanes.
    pub fn new(control: StepControl) -> Self {
        Self {
            control,
            clocks: Vec::new(),
            to: Grid::default(),
            peaks: Grid::default(),
            stages: Vec::new(),
            dense: Vec::new(),
            unknown: Vec::new(),
        }
    }

    /// Replaces the settings of the step control, before lanes begin.
    pub fn set_control(&mut self, control: StepControl) {
        self.control = control;
    }

    /// Makes room for so many states and blocks of lanes.
    pub fn resize(&mut self, states: usize, blocks: usize) {
        self.to = Grid::new(states, blocks);
        self.peaks = Grid::new(states, blocks);
        self.stages = vec![[Block::of(0.0); STAGES]; states * blocks];
        self.dense = vec![[Block::of(0.0); 5]; states * blocks];
        self.unknown = vec![true; blocks * WIDTH];
    }

    /// Begins all lanes at 0 with these states, SI units.
    pub fn begin(&mut self, states: &Grid) {
        self.clocks.clear();
        self.clocks.resize(states.blocks(), Clock::begin(&self.control));
        self.to.clone_from(states);
        for row in 0..states.rows() {
            let (peaks, states) = (self.peaks.row_mut(row), states.row(row));
            peaks.iter_mut().zip(states).for_each(|(peak, state)| peak.0 = state.0.map(f64::abs));
        }
        self.unknown.fill(true);
    }

    /// Continues a lane after a step that was made elsewhere.
    pub fn load(&mut self, lane: usize, last: &LastStep) {
        let (block, within) = (lane / WIDTH, lane % WIDTH);
        self.clocks[block].load(within, last);
        self.to.set_lane(lane, &last.to);
        self.peaks.set_lane(lane, &last.peaks);
        for state in 0..last.to.len() {
            let dense = &mut self.dense[state * self.to.blocks() + block];
            dense.iter_mut().zip(&last.dense).for_each(|(to, from)| to.0[within] = from[state]);
        }
        self.unknown[lane] = true;
    }

    /// The last step of a lane.
    pub fn last(&self, lane: usize) -> LastStep {
        let states = self.to.rows();
        let list = |grid: &Grid| (0..states).map(|state| grid.get(state, lane)).collect::<Vec<f64>>();
        let (block, within) = (lane / WIDTH, lane % WIDTH);
        let dense = std::array::from_fn(|degree| {
            (0..states).map(|state| self.dense[state * self.to.blocks() + block][degree].0[within]).collect()
        });
        let [from, ..]: &[Vec<f64>; 5] = &dense;
        let clock = &self.clocks[block];
        LastStep {
            start: clock.start.0[within],
            size: clock.size.0[within],
            end: clock.end.0[within],
            from: from.clone(),
            to: list(&self.to),
            proposed: clock.proposed.0[within],
            error: clock.error.0[within],
            peaks: list(&self.peaks),
            dense,
        }
    }

    /// End of the last step of a lane, SI units.
    #[inline(always)]
    pub fn end(&self, lane: usize) -> f64 {
        self.clocks[lane / WIDTH].end.0[lane % WIDTH]
    }

    /// True if the last attempt of a lane was accepted.
    #[inline(always)]
    pub fn is_accepted(&self, lane: usize) -> bool {
        self.clocks[lane / WIDTH].accepted.has(lane % WIDTH)
    }

    /// Makes one attempt of a step in all lanes in which `active` holds, and accepts or shortens it. Returns true for the lanes in which the
    /// step cannot be made shorter.
    pub fn attempt(&mut self, width: Width, rates: &mut Body, active: &[bool], stalled: &mut [bool]) {
        width.call::<Attempt>((self, rates, active, stalled));
    }

    #[inline(always)]
    fn attempt_in((own, rates, active, stalled): (&mut Self, &mut Body, &[bool], &mut [bool])) {
        own.find_first(rates, active);
        let longest = own.control.longest;
        for clock in &mut own.clocks {
            let Clock { proposed, rejected, attempt, .. } = *clock;
            clock.attempt = Block::each(|lane| {
                let wanted = proposed.0[lane].min(longest);
                if rejected.0[lane] == 0.0 { wanted } else { attempt.0[lane] }
            });
        }
        own.stage::<1>(rates);
        own.stage::<2>(rates);
        own.stage::<3>(rates);
        own.stage::<4>(rates);
        own.stage::<5>(rates);
        own.stage::<6>(rates);
        own.find_error(rates);
        own.judge(active, stalled);
        own.accept(rates);
        for (lane, unknown) in own.unknown.iter_mut().enumerate() {
            *unknown &= !own.clocks[lane / WIDTH].accepted.has(lane % WIDTH);
        }
    }

    /// Computes the rates of the first stage where they are not known from the step before.
    fn find_first(&mut self, rates: &mut Body, active: &[bool]) {
        if !self.unknown.iter().zip(active).any(|(unknown, active)| *unknown && *active) {
            return;
        }
        rates.set_states(&self.to);
        rates.set_times(self.clocks.iter().map(|clock| clock.end));
        rates.evaluate();
        let blocks = self.to.blocks();
        for (state, &root) in rates.roots().iter().enumerate() {
            for (lane, &unknown) in self.unknown.iter().enumerate() {
                if unknown {
                    let stages = &mut self.stages[state * blocks + lane / WIDTH];
                    stages[0].0[lane % WIDTH] = rates.grid().get(root as usize, lane);
                }
            }
        }
    }

    /// Computes the rates of a stage.
    #[inline(always)]
    fn stage<const STAGE: usize>(&mut self, rates: &mut Body) {
        let blocks = self.to.blocks();
        for state in 0..self.to.rows() {
            let register = rates.states()[state] as usize;
            let to = rates.grid_mut().row_mut(register);
            let stages = &self.stages[state * blocks..][..blocks];
            for (((to, from), clock), stages) in to.iter_mut().zip(self.to.row(state)).zip(&self.clocks).zip(stages) {
                let sum = weighted::<STAGE>(STAGE_WEIGHTS[STAGE], stages);
                let (from, size) = (*from, clock.attempt);
                *to = Block::each(|lane| from.0[lane] + size.0[lane] * sum.0[lane]);
            }
        }
        rates.set_times(self.clocks.iter().map(|clock| {
            let Clock { end, attempt, .. } = *clock;
            Block::each(|lane| end.0[lane] + NODES[STAGE] * attempt.0[lane])
        }));
        rates.evaluate();
        for (state, &root) in rates.roots().iter().enumerate() {
            let stages = &mut self.stages[state * blocks..][..blocks];
            for (stages, rate) in stages.iter_mut().zip(rates.grid().row(root as usize)) {
                stages[STAGE] = *rate;
            }
        }
    }

    /// Error in units of the allowed error: root mean square over the states.
    #[inline(always)]
    fn find_error(&mut self, rates: &Body) {
        let (blocks, states) = (self.to.blocks(), self.to.rows());
        let StepControl { tolerance, floors, below_peak, .. } = &self.control;
        for clock in &mut self.clocks {
            clock.found = Block::of(0.0);
        }
        for (state, &floor) in floors.iter().enumerate() {
            let results = rates.grid().row(rates.states()[state] as usize);
            let (from, peaks) = (self.to.row(state), self.peaks.row(state));
            for block in 0..blocks {
                let error = weighted::<STAGES>(&ERROR_WEIGHTS, &self.stages[state * blocks + block]);
                let (from, peak, result) = (from[block], peaks[block], results[block]);
                let Clock { attempt, found, .. } = self.clocks[block];
                let (tolerance, below_peak) = (*tolerance, *below_peak);
                let square = Block::each(|lane| {
                    let magnitude = greater(from.0[lane].abs(), result.0[lane].abs());
                    let scale = tolerance * greater(greater(magnitude, below_peak * peak.0[lane]), floor);
                    let ratio = (error.0[lane] * attempt.0[lane]) / scale;
                    ratio * ratio
                });
                // A condition around the division would be compiled to branches.
                let finite = Mask::each(|lane| result.0[lane].is_finite());
                let square = finite.choose(square, Block::of(f64::NAN));
                self.clocks[block].found = Block::each(|lane| found.0[lane] + square.0[lane]);
            }
        }
        let count = states.max(1) as f64;
        for clock in &mut self.clocks {
            let sum = clock.found;
            clock.found = Block::each(|lane| (sum.0[lane] / count).sqrt());
        }
    }

    /// Accepts attempts, or shortens the next ones.
    #[inline(always)]
    fn judge(&mut self, active: &[bool], stalled: &mut [bool]) {
        let lanes = active.chunks(WIDTH).zip(stalled.chunks_mut(WIDTH));
        // A closure of an iterator would be compiled without the features.
        for (clock, (active, stalled)) in self.clocks.iter_mut().zip(lanes) {
            clock.judge(active, stalled);
        }
    }

    /// Takes over the accepted attempts.
    #[inline(always)]
    fn accept(&mut self, rates: &Body) {
        let blocks = self.to.blocks();
        for state in 0..self.to.rows() {
            let results = rates.grid().row(rates.states()[state] as usize);
            for (block, &result) in results.iter().enumerate() {
                let place = state * blocks + block;
                let Clock { accepted, attempt: size, .. } = self.clocks[block];
                let (stages, dense) = (&mut self.stages[place], &mut self.dense[place]);
                let highest = weighted::<STAGES>(&DENSE_WEIGHTS, stages);
                let (first, last) = (stages[0], stages[STAGES - 1]);
                let from = self.to.row(state)[block];
                let change = Block::each(|lane| result.0[lane] - from.0[lane]);
                let bend = Block::each(|lane| size.0[lane] * first.0[lane] - change.0[lane]);
                let third = Block::each(|lane| change.0[lane] - size.0[lane] * last.0[lane] - bend.0[lane]);
                let fourth = Block::each(|lane| highest.0[lane] * size.0[lane]);
                let new = [from, change, bend, third, fourth];
                for (degree, dense) in dense.iter_mut().enumerate() {
                    *dense = accepted.choose(new[degree], *dense);
                }
                stages[0] = accepted.choose(last, first);
                self.to.row_mut(state)[block] = accepted.choose(result, from);
                let peak = self.peaks.row(state)[block];
                let greatest = Block::each(|lane| greater(result.0[lane].abs(), peak.0[lane]));
                self.peaks.row_mut(state)[block] = accepted.choose(greatest, peak);
            }
        }
        for clock in &mut self.clocks {
            clock.accept();
        }
    }

    /// States at a time of each lane, a row of `times`: those at the end of the last step if it is there, and otherwise the continuous
    /// solution over it.
    pub fn states_at(&self, width: Width, times: &[Block], out: &mut Grid) {
        width.call::<States>((self, times, out));
    }

    #[inline(always)]
    fn states_in<const KEEPS_END: bool>((own, times, out): (&Self, &[Block], &mut Grid)) {
        let blocks = own.to.blocks();
        for state in 0..own.to.rows() {
            let to = own.to.row(state);
            for (block, out) in out.row_mut(state).iter_mut().enumerate() {
                let (time, to) = (times[block], to[block]);
                let [c_0, c_1, c_2, c_3, c_4] = &own.dense[state * blocks + block];
                let (c_0, c_1, c_2, c_3, c_4) = (*c_0, *c_1, *c_2, *c_3, *c_4);
                let Clock { start, size, end, .. } = own.clocks[block];
                *out = Block::each(|lane| {
                    let part = (time.0[lane] - start.0[lane]) / size.0[lane];
                    let between = continuous([c_0.0[lane], c_1.0[lane], c_2.0[lane], c_3.0[lane], c_4.0[lane]], part);
                    if KEEPS_END && time.0[lane] == end.0[lane] { to.0[lane] } else { between }
                });
            }
        }
    }

    /// Continuous solution over the last step at a time of each lane, a row of `times`.
    pub fn continuous_at(&self, width: Width, times: &[Block], out: &mut Grid) {
        width.call::<Continuous>((self, times, out));
    }

    /// A state of a lane at `time`, as [`Steps::states_at`].
    pub fn state_at(&self, lane: usize, time: f64, state: usize) -> f64 {
        let clock = &self.clocks[lane / WIDTH];
        let [start, size, end] = [&clock.start, &clock.size, &clock.end].map(|block| block.0[lane % WIDTH]);
        if time == end {
            return self.to.get(state, lane);
        }
        let dense = &self.dense[state * self.to.blocks() + lane / WIDTH];
        continuous(dense.each_ref().map(|coefficient| coefficient.0[lane % WIDTH]), (time - start) / size)
    }
}

/// The greater one of two numbers that are not NaN.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Continuous solution at `part` of a step, 0 to 1.
#[inline(always)]
fn continuous([c_0, c_1, c_2, c_3, c_4]: [f64; 5], part: f64) -> f64 {
    let rest = 1.0 - part;
    c_0 + part * (c_1 + rest * (c_2 + part * (c_3 + rest * c_4)))
}

/// weights . rates of the first stages, summed from the left.
#[inline(always)]
fn weighted<const COUNT: usize>(weights: &[f64], stages: &[Block; STAGES]) -> Block {
    let mut sum = Block::of(0.0);
    for (weight, stage) in weights.iter().zip(stages).take(COUNT) {
        let (before, stage) = (sum, *stage);
        sum = Block::each(|lane| before.0[lane] + weight * stage.0[lane]);
    }
    sum
}

/// [`Steps::attempt_in`] for all features.
struct Attempt;

impl Lanewise for Attempt {
    type Arguments<'a> = (&'a mut Steps, &'a mut Body, &'a [bool], &'a mut [bool]);

    #[inline(always)]
    fn call(arguments: Self::Arguments<'_>) {
        Steps::attempt_in(arguments);
    }
}

/// [`Steps::states_at`] for all features.
struct States;

impl Lanewise for States {
    type Arguments<'a> = (&'a Steps, &'a [Block], &'a mut Grid);

    #[inline(always)]
    fn call(arguments: Self::Arguments<'_>) {
        Steps::states_in::<true>(arguments);
    }
}

/// [`Steps::continuous_at`] for all features.
struct Continuous;

impl Lanewise for Continuous {
    type Arguments<'a> = (&'a Steps, &'a [Block], &'a mut Grid);

    #[inline(always)]
    fn call(arguments: Self::Arguments<'_>) {
        Steps::states_in::<false>(arguments);
    }
}
