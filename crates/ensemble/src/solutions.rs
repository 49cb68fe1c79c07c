//! Solutions of smooth equations at given times, in lanes. Each lane has parameters and times of its own.

use crate::LANES;
use crate::body::Body;
use crate::ensemble::NUMBERS;
use crate::grid::{Grid, WIDTH};
use crate::reason::NoLanes;
use crate::steps::Steps;
use crate::width::{Features, Width};
use engine::tableau::STAGES;
use engine::{Interpreted, Routine, Setup, StepControl, Stepper};
use program::{Model, NodeId};

/// Greatest number of attempts of a step in one solution: the engine decides about longer ones.
const ATTEMPTS: u64 = Stepper::STEP_LIMIT as u64 / 2;

/// A solution that is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Sought<'a> {
    /// One value per parameter, SI units.
    pub parameters: &'a [f64],
    /// Times at which values are read, SI units: ascending, at least 0.
    pub times: &'a [f64],
}

/// Solver of the equations of motion of one model by the method of Dormand and Prince for many sets of parameters side by side.
/// Every solution has the bits of [`Stepper::advance_to`] with [`Stepper::allow_of_peak`].
#[derive(Clone, Debug)]
pub struct Solutions {
    control: StepControl,
    /// Number of floating-point operations of an evaluation of the rates.
    work: u64,
    steps: Steps,
    rates: Body,
    readings: Body,
    initial: Body,
    width: Width,
    blocks: usize,
}

/// Progress of a lane.
#[derive(Clone, Copy, Debug, Default)]
struct Lane {
    /// True while the lane is computed.
    running: bool,
    /// True if it has failed.
    failed: bool,
    /// Number of rows read.
    rows: usize,
    /// Number of attempts of a step.
    attempts: u64,
}

impl Solutions {
    /// Solver for `model` with this setup but other parameters; initial values are those of the model. `readings` are evaluated
    /// at each time.
    ///
    /// # Errors
    /// The reason why the equations can only be solved one by one.
    pub fn new(model: &Model, setup: &Setup, readings: &[NodeId]) -> Result<Self, NoLanes> {
        let mut stepper = Stepper::new(model, setup).map_err(NoLanes::Refused)?;
        stepper.allow_of_peak(setup.tolerance);
        let listing = stepper.listing().map_err(NoLanes::Interpreted)?;
        let control = stepper.step_control().ok_or(NoLanes::Interpreted(Interpreted::Method(listing.method)))?;
        if !stepper.is_smooth() {
            return Err(NoLanes::NotSmooth);
        }
        let system = NoLanes::Interpreted(Interpreted::LinearSystem);
        let (preparation, _) = stepper.preparations().ok_or(system.clone())?;
        let states = model.states.len();
        let interpolations = listing.interpolations.into();
        let rates = Body::new((listing.lines, preparation), (listing.states, listing.rates), interpolations);
        let initial: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
        let routine = |nodes: &[NodeId]| Body::of_routine(&Routine::compile(model, nodes), states);
        Ok(Self {
            work: stepper.evaluation_work(),
            steps: Steps::new(control.clone()),
            control,
            rates,
            readings: routine(readings).ok_or(system.clone())?,
            initial: routine(&initial).ok_or(system)?,
            width: Width::default(),
            blocks: 0,
        })
    }

    /// Greatest number of solutions that are computed together.
    pub fn lanes(&self) -> usize {
        let registers = self.rates.registers() + self.readings.registers();
        (NUMBERS / (WIDTH * registers.max(1))).clamp(1, LANES / WIDTH) * WIDTH
    }

    /// Computes with at most these processor features.
    pub fn use_features(&mut self, features: Features) {
        self.width = Width::new(features);
        // The bodies take over the features.
        self.blocks = 0;
    }

    /// Computes at most [`Solutions::lanes`] solutions with the error tolerance `tolerance` of each step, relative to the greatest
    /// value of each state so far. `take` gets the index of a solution, the index of a time, and what is read there, in the order of time.
    /// Returns the number of floating-point operations of each solution, as [`Stepper::work`] counts them; `None` if the engine must
    /// compute it: a value is not finite, or the solution needs very many steps.
    pub fn solve(
        &mut self,
        tolerance: f64,
        sought: &[Sought],
        take: &mut dyn FnMut(usize, usize, &[f64]),
    ) -> Vec<Option<u64>> {
        let mut lanes = self.begin(tolerance, sought);
        let blocks = self.blocks;
        let (mut active, mut stalled) = (vec![false; lanes.len()], vec![false; lanes.len()]);
        let (mut times, mut states) = (Grid::new(1, blocks), Grid::new(self.rates.states().len(), blocks));
        loop {
            while self.find_rows(sought, &mut lanes, &mut times, &mut active) {
                self.steps.states_at(self.width, times.row(0), &mut states);
                self.readings.set_time(&times, 0);
                self.readings.set_states(&states);
                self.readings.evaluate();
                self.take_rows(&mut lanes, &active, take);
            }
            active.iter_mut().zip(&lanes).for_each(|(active, lane)| *active = lane.running);
            if !active.contains(&true) {
                break;
            }
            stalled.fill(false);
            self.steps.attempt(self.width, &mut self.rates, &active, &mut stalled);
            for (lane, stalled) in lanes.iter_mut().zip(&stalled).filter(|(lane, _)| lane.running) {
                lane.attempts += 1;
                lane.failed = *stalled || lane.attempts > ATTEMPTS;
                lane.running = !lane.failed;
            }
        }
        let evaluations = |lane: &Lane| match lane.attempts {
            0 => 0,
            attempts => 1 + (STAGES as u64 - 1) * attempts,
        };
        let work = |lane: &Lane| (!lane.failed).then(|| evaluations(lane) * self.work);
        lanes[..sought.len()].iter().map(work).collect()
    }

    /// Begins all lanes at their initial values.
    fn begin(&mut self, tolerance: f64, sought: &[Sought]) -> Vec<Lane> {
        let states = self.rates.states().len();
        let blocks = sought.len().div_ceil(WIDTH);
        self.control.tolerance = tolerance.max(Setup::LEAST_TOLERANCE);
        self.steps.set_control(self.control.clone());
        if self.blocks != blocks {
            for body in [&mut self.rates, &mut self.readings, &mut self.initial] {
                body.resize(blocks, self.width);
            }
            self.steps.resize(states, blocks);
            self.blocks = blocks;
        }
        let first = sought.first().map_or(&[][..], |sought| sought.parameters);
        let mut parameters = Grid::new(first.len(), blocks);
        for lane in 0..blocks * WIDTH {
            parameters.set_lane(lane, sought.get(lane).map_or(first, |sought| sought.parameters));
        }
        let mut initial = Grid::new(states, blocks);
        // Initial values do not depend on states.
        self.initial.prepare(&parameters, &initial);
        self.initial.evaluate();
        for row in 0..states {
            let values = self.initial.grid().row(self.initial.roots()[row] as usize);
            initial.row_mut(row).copy_from_slice(values);
        }
        self.readings.prepare(&parameters, &initial);
        self.rates.prepare(&parameters, &initial);
        self.steps.begin(&initial);
        let lane = |lane: usize| {
            let begins = sought.get(lane).is_some_and(|sought| sought.parameters.iter().all(|value| value.is_finite()));
            let running = begins && (0..states).all(|row| initial.get(row, lane).is_finite());
            Lane { running, failed: !running, ..Lane::default() }
        };
        (0..blocks * WIDTH).map(lane).collect()
    }

    /// Sets `active` and the next time for each lane whose last step has reached it, and ends the lanes that have read all. False if
    /// no lane has reached its next time.
    fn find_rows(&self, sought: &[Sought], lanes: &mut [Lane], times: &mut Grid, active: &mut [bool]) -> bool {
        let mut any = false;
        for (number, (lane, active)) in lanes.iter_mut().zip(active).enumerate() {
            *active = false;
            let next = sought.get(number).and_then(|sought| sought.times.get(lane.rows));
            lane.running &= next.is_some();
            if let Some(&next) = next.filter(|next| lane.running && **next <= self.steps.end(number)) {
                times.set(0, number, next);
                *active = true;
                any = true;
            }
        }
        any
    }

    fn take_rows(&self, lanes: &mut [Lane], active: &[bool], take: &mut dyn FnMut(usize, usize, &[f64])) {
        let mut values = vec![0.0; self.readings.len()];
        for (number, lane) in lanes.iter_mut().enumerate().filter(|(number, _)| active[*number]) {
            values.iter_mut().enumerate().for_each(|(root, value)| *value = self.readings.value(root, number));
            take(number, lane.rows, &values);
            lane.rows += 1;
        }
    }
}
