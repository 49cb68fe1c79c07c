//! Ensembles: preparation, and what does not depend on the method.

use crate::alone::{Alone, LastRow};
use crate::body::Body;
use crate::checks::Checks;
use crate::fixed::Fixed;
use crate::grid::{Grid, WIDTH};
use crate::reason::NoLanes;
use crate::steps::Steps;
use crate::width::{Features, Width};
use engine::{Interpreted, Listing, ROUNDING, Routine, RunError, Setup, Stepper, WindowListing, rows_until};
use program::{Model, NodeId};
use std::sync::Arc;

/// Greatest number of runs in an ensemble.
pub const LANES: usize = 64;

/// Registers of so many numbers stay in the caches of a processor.
pub(crate) const NUMBERS: usize = 1 << 16;

/// Runs of one model side by side, each with its own parameters. Every run has the bits of a single one.
#[derive(Clone, Debug)]
pub struct Ensemble {
    pub(crate) method: Method,
    pub(crate) rates: Body,
    pub(crate) readings: Body,
    initial: Body,
    /// The state to start from, if it is not that of the model.
    start: Option<Vec<f64>>,
    pub(crate) grid: Times,
    pub(crate) width: Width,
    pub(crate) lanes: Lanes,
    /// Number of steps attempted in the last runs, each in all lanes.
    pub(crate) attempts: u64,
}

/// The method with the states of its lanes.
#[derive(Clone, Debug)]
pub(crate) enum Method {
    Fixed(Fixed),
    Adaptive(Box<Steps>, Option<Box<Checks>>),
}

/// The times of the rows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Times {
    /// Distance of the rows, SI units.
    pub step: f64,
    /// End of the runs, SI units.
    pub until: f64,
    /// Last time at which rows are taken.
    pub last: f64,
    /// Index of the last row that is taken, and of the last row that is computed.
    pub taken: u64,
    pub all: u64,
}

impl Times {
    fn new(step: f64, until: f64) -> Self {
        let [taken, all] = rows_until(step, until);
        Self { step, until, last: until * (1.0 + ROUNDING), taken, all }
    }

    /// Time of a row, SI units.
    #[inline(always)]
    pub fn at(&self, index: u64) -> f64 {
        index as f64 * self.step
    }
}

/// What is known of each lane.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lanes {
    /// Number of blocks for which there is room.
    pub blocks: usize,
    /// Parameters and initial values, one row for each.
    pub parameters: Grid,
    pub initial: Grid,
    /// True while a lane is computed.
    pub running: Vec<bool>,
    /// Index of the last row reached.
    pub index: Vec<u64>,
    /// Number of steps since that row.
    pub steps: Vec<usize>,
    pub last: Vec<LastRow>,
    pub errors: Vec<Option<RunError>>,
    pub values: Vec<f64>,
}

impl Lanes {
    /// Parameters and initial values of a lane.
    pub fn begun(&self, lane: usize) -> [Vec<f64>; 2] {
        [&self.parameters, &self.initial].map(|grid| {
            let mut values = vec![0.0; grid.rows()];
            grid.lane(lane, &mut values);
            values
        })
    }

    /// Ends a lane.
    pub fn end(&mut self, lane: usize, result: Result<(), RunError>) {
        self.running[lane] = false;
        self.errors[lane] = result.err();
    }
}

/// End of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Ended {
    /// The last row at or before the end of the run.
    pub last: LastRow,
    /// Initial values, one per state, SI units.
    pub initial: Vec<f64>,
}

impl Ensemble {
    /// Runs of `model` with this setup but other parameters, up to `until` (SI units). `readings` are evaluated at each row.
    ///
    /// # Errors
    /// The reason why runs of this model can only be made one by one.
    pub fn new(model: &Model, setup: &Setup, until: f64, readings: &[NodeId]) -> Result<Self, NoLanes> {
        if !setup.presses.is_empty() {
            return Err(NoLanes::Presses);
        }
        let drawn = model.with_drawings(&setup.drawings);
        let model = drawn.as_ref().unwrap_or(model);
        let stepper = Stepper::new(model, setup).map_err(NoLanes::Refused)?;
        let listing = stepper.listing().map_err(NoLanes::Interpreted)?;
        let system = NoLanes::Interpreted(Interpreted::LinearSystem);
        let (preparation, preparations) = stepper.preparations().ok_or(system.clone())?;
        let states = model.states.len();
        let interpolations: Arc<[_]> = listing.interpolations.clone().into();
        let Listing { lines, states: registers, rates, .. } = listing.clone();
        let rates = Body::new((lines, preparation), (registers, rates), interpolations.clone());
        let method = match (stepper.step_control(), &listing.window) {
            (Some(control), Some(window)) => {
                let checks = checks(&stepper, window, preparations, states, &interpolations)?;
                Method::Adaptive(Box::new(Steps::new(control)), checks.map(Box::new))
            }
            _ if !stepper.is_smooth() => return Err(NoLanes::EventsBetweenFixedSteps),
            _ => Method::Fixed(Fixed::new(listing.method, listing.pairs.clone(), &rates)),
        };
        let initial: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
        let routine = |nodes: &[NodeId]| Body::of_routine(&Routine::compile(model, nodes), states);
        let ensemble = Self {
            method,
            rates,
            readings: routine(readings).ok_or(system.clone())?,
            initial: routine(&initial).ok_or(system)?,
            start: setup.start.clone(),
            grid: Times::new(setup.step, until),
            width: Width::default(),
            lanes: Lanes::default(),
            attempts: 0,
        };
        Ok(ensemble)
    }

    /// Greatest number of runs that are made together.
    pub fn lanes(&self) -> usize {
        let registers = self.rates.registers() + self.readings.registers();
        (NUMBERS / (WIDTH * registers.max(1))).clamp(1, LANES / WIDTH) * WIDTH
    }

    /// Computes with at most these processor features.
    pub fn use_features(&mut self, features: Features) {
        self.width = Width::new(features);
        // The bodies take over the features.
        self.lanes.blocks = 0;
    }

    /// Makes runs with these parameters, at most [`Ensemble::lanes`] of them: for each run one value per parameter, SI units. `take`
    /// gets the index of a run, a time (SI units), and what is read there: at each row of the run up to its end, in the order of
    /// time, if anything is read at all. `alone` is for runs of the same model with the same setup and readings.
    ///
    /// # Errors
    /// For each run, its error. An event that ends it is none.
    pub fn run(
        &mut self,
        alone: &mut Alone,
        parameters: &[Vec<f64>],
        take: &mut dyn FnMut(usize, f64, &[f64]),
    ) -> Vec<Result<Ended, RunError>> {
        self.compute(alone, parameters, take);
        let end = |lane: usize| {
            let mut initial = Vec::new();
            let last = self.end(lane, &mut initial)?.clone();
            Ok(Ended { last, initial })
        };
        (0..parameters.len()).map(end).collect()
    }

    /// [`Ensemble::run`], after which [`Ensemble::end`] gives the ends.
    pub fn compute(&mut self, alone: &mut Alone, parameters: &[Vec<f64>], take: &mut dyn FnMut(usize, f64, &[f64])) {
        self.attempts = 0;
        self.begin(alone, parameters, take);
        match self.method {
            Method::Fixed(_) => self.advance_fixed(alone, take),
            Method::Adaptive(..) => self.advance_adaptive(alone, take),
        }
    }

    /// The last row of a run at or before its end. `initial` becomes its initial values, one per state, SI units.
    ///
    /// # Errors
    /// The error of the run. An event that ends it is none.
    pub fn end(&self, lane: usize, initial: &mut Vec<f64>) -> Result<&LastRow, RunError> {
        if let Some(error) = &self.lanes.errors[lane] {
            return Err(error.clone());
        }
        initial.resize(self.lanes.initial.rows(), 0.0);
        self.lanes.initial.lane(lane, initial);
        Ok(&self.lanes.last[lane])
    }

    /// Number of operations in all lanes of the last runs.
    pub fn work(&self) -> u64 {
        let operations = self.rates.operations() + self.rates.states().len();
        self.attempts * (operations * self.lanes.running.len()) as u64
    }

    /// Makes room for so many runs.
    fn resize(&mut self, parameters: usize, states: usize, runs: usize) {
        let blocks = runs.div_ceil(WIDTH);
        let width = self.width;
        if self.lanes.blocks != blocks {
            for body in [&mut self.rates, &mut self.readings, &mut self.initial] {
                body.resize(blocks, width);
            }
            match &mut self.method {
                Method::Fixed(fixed) => fixed.resize(blocks),
                Method::Adaptive(steps, checks) => {
                    steps.resize(states, blocks);
                    if let Some(checks) = checks {
                        checks.resize(states, parameters, (blocks, width));
                    }
                }
            }
            self.lanes = Lanes {
                blocks,
                parameters: Grid::new(parameters, blocks),
                initial: Grid::new(states, blocks),
                values: vec![0.0; self.readings.len()],
                ..Lanes::default()
            };
        }
        let lanes = &mut self.lanes;
        let count = blocks * WIDTH;
        lanes.running.clear();
        lanes.running.extend((0..count).map(|lane| lane < runs));
        lanes.index.clear();
        lanes.index.resize(count, 0);
        lanes.steps.clear();
        lanes.steps.resize(count, 0);
        lanes.errors.clear();
        lanes.errors.resize(count, None);
        lanes.last.resize(count, LastRow::default());
        lanes.last.iter_mut().for_each(|last| last.set(0.0, &[]));
    }

    /// Sets parameters and initial values, and takes the first rows.
    fn begin(&mut self, alone: &Alone, parameters: &[Vec<f64>], take: &mut dyn FnMut(usize, f64, &[f64])) {
        let states = self.rates.states().len();
        let first = parameters.first().map_or(&[][..], Vec::as_slice);
        self.resize(first.len(), states, parameters.len());
        let lanes = &mut self.lanes;
        for lane in 0..lanes.blocks * WIDTH {
            lanes.parameters.set_lane(lane, parameters.get(lane).map_or(first, Vec::as_slice));
        }
        match &self.start {
            Some(start) => start.iter().enumerate().for_each(|(row, &value)| lanes.initial.fill(row, value)),
            None => {
                self.initial.prepare(&lanes.parameters, &lanes.initial);
                self.initial.evaluate();
                for row in 0..states {
                    let values = self.initial.grid().row(self.initial.roots()[row] as usize);
                    lanes.initial.row_mut(row).copy_from_slice(values);
                }
            }
        }
        for (lane, parameters) in parameters.iter().enumerate() {
            let initial = |row: usize| lanes.initial.get(row, lane);
            let finite =
                parameters.iter().all(|value| value.is_finite()) && (0..states).all(|row| initial(row).is_finite());
            if let Some(error) = (!finite).then(|| alone.refusal(parameters)).flatten() {
                lanes.end(lane, Err(error));
            }
        }
        self.readings.prepare(&lanes.parameters, &lanes.initial);
        if self.grid.last >= 0.0 {
            let times = Grid::new(1, lanes.blocks);
            let running = lanes.running.clone();
            let initial = lanes.initial.clone();
            self.read(&times, &initial, &running, take);
            for lane in 0..running.len() {
                self.keep(lane, 0.0, &initial);
            }
        }
    }

    /// Reads the rows of the `chosen` lanes at these times and states.
    pub(crate) fn read(
        &mut self,
        times: &Grid,
        states: &Grid,
        chosen: &[bool],
        take: &mut dyn FnMut(usize, f64, &[f64]),
    ) {
        if self.readings.is_empty() {
            return;
        }
        self.readings.set_time(times, 0);
        self.readings.set_states(states);
        self.readings.evaluate();
        let values = &mut self.lanes.values;
        for lane in (0..chosen.len()).filter(|&lane| chosen[lane]) {
            values.iter_mut().enumerate().for_each(|(number, value)| *value = self.readings.value(number, lane));
            take(lane, times.get(0, lane), values);
        }
    }

    /// Keeps the state of a lane as that of its last row.
    pub(crate) fn keep(&mut self, lane: usize, time: f64, states: &Grid) {
        let last = &mut self.lanes.last[lane];
        last.time = time;
        last.state.resize(states.rows(), 0.0);
        states.lane(lane, &mut last.state);
    }
}

/// The checks of a window; `None` if nothing can happen between two rows.
fn checks(
    stepper: &Stepper,
    window: &WindowListing,
    preparations: [engine::Preparation; 5],
    states: usize,
    interpolations: &Arc<[Arc<program::Interpolation>]>,
) -> Result<Option<Checks>, NoLanes> {
    if stepper.is_smooth() {
        return Ok(None);
    }
    if window.formulas.iter().all(|formulas| formulas.roots.is_empty()) {
        return Err(NoLanes::ChangesInTime);
    }
    let bodies = window.formulas.iter().zip(preparations).map(|(formulas, preparation)| {
        Body::of_formulas(formulas.clone(), preparation, states, interpolations.clone())
    });
    let bodies: Vec<Body> = bodies.collect();
    Ok(bodies.try_into().ok().map(Checks::new))
}
