//! Ensembles: preparation, and what does not depend on the method.

use crate::alone::{Alone, LastRow};
use crate::body::Body;
use crate::checks::Checks;
use crate::ends::Ends;
use crate::fixed::Fixed;
use crate::grid::{Grid, WIDTH};
use crate::intervals::Intervals;
use crate::lanes::Lanes;
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
    /// Checks of events and switches; `None` if the model has none.
    pub(crate) checks: Option<Box<Checks>>,
    pub(crate) rates: Body,
    pub(crate) readings: Body,
    initial: Body,
    ends: Ends,
    /// The state to start from, if it is not that of the model.
    start: Option<Vec<f64>>,
    pub(crate) grid: Times,
    pub(crate) width: Width,
    pub(crate) lanes: Lanes,
    pub(crate) intervals: Intervals,
    /// Number of steps attempted in the last runs, each in all lanes.
    pub(crate) attempts: u64,
}

/// The method with the states of its lanes.
#[derive(Clone, Debug)]
pub(crate) enum Method {
    Fixed(Fixed),
    Adaptive(Box<Steps>),
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
        // Processors convert signed integers faster.
        index as i64 as f64 * self.step
    }

    /// Index of the last row at or before a time, SI units, at least `index` and at most that of the last row that is computed.
    #[inline(always)]
    pub fn reached(&self, index: u64, time: f64) -> u64 {
        // The quotient is rounded: it may be one row too far, or one too near.
        let mut reached = ((time / self.step) as i64 as u64 + 1).min(self.all);
        while reached > index && self.at(reached) > time {
            reached -= 1;
        }
        reached.max(index)
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
        let mut listing = stepper.listing().map_err(NoLanes::Interpreted)?;
        let system = NoLanes::Interpreted(Interpreted::LinearSystem);
        let (preparation, preparations) = stepper.preparations().ok_or(system.clone())?;
        let states = model.states.len();
        let window = listing.window.take().unwrap_or_else(|| stepper.window(&mut listing.interpolations));
        let interpolations: Arc<[_]> = listing.interpolations.clone().into();
        let checks = checks(&stepper, &window, preparations, states, &interpolations)?;
        let Listing { lines, states: registers, rates, .. } = listing;
        let rates = Body::new((lines, preparation), (registers, rates), interpolations);
        let method = match stepper.step_control() {
            Some(control) => Method::Adaptive(Box::new(Steps::new(control))),
            None => Method::Fixed(Fixed::new(listing.method, listing.pairs, &rates)),
        };
        let initial: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
        let routine = |nodes: &[NodeId]| Body::of_routine(&Routine::compile(model, nodes), states);
        let ensemble = Self {
            method,
            checks: checks.map(Box::new),
            rates,
            readings: routine(readings).ok_or(system.clone())?,
            initial: routine(&initial).ok_or(system)?,
            ends: Ends::default(),
            start: setup.start.clone(),
            grid: Times::new(setup.step, until),
            width: Width::default(),
            lanes: Lanes::default(),
            intervals: Intervals::default(),
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
        self.prepare(parameters.len(), parameters.first().map_or(&[], Vec::as_slice));
        for (run, parameters) in parameters.iter().enumerate() {
            self.lanes.parameters.set_lane(run, parameters);
        }
        self.compute(alone, take);
        let end = |run: usize| match self.error(run) {
            Some(error) => Err(error.clone()),
            None => Ok(Ended { last: self.lanes.last_row(run), initial: self.lanes.initial.list(run) }),
        };
        (0..parameters.len()).map(end).collect()
    }

    /// Prepares so many runs, at most [`Ensemble::lanes`], all with these parameters: one value per parameter, SI units.
    pub fn prepare(&mut self, runs: usize, parameters: &[f64]) {
        self.resize(parameters.len(), self.rates.states().len(), runs.div_ceil(WIDTH));
        self.lanes.runs = runs;
        parameters.iter().enumerate().for_each(|(row, &value)| self.lanes.parameters.fill(row, value));
    }

    /// Sets a parameter of a prepared run, SI units.
    pub fn set_parameter(&mut self, run: usize, parameter: usize, value: f64) {
        self.lanes.parameters.set(parameter, run, value);
    }

    /// Makes the prepared runs; `alone` and `take` as in [`Ensemble::run`].
    pub fn compute(&mut self, alone: &mut Alone, take: &mut dyn FnMut(usize, f64, &[f64])) {
        self.attempts = 0;
        self.begin(alone, take);
        match self.method {
            Method::Fixed(_) => self.advance_fixed(alone, take),
            Method::Adaptive(..) => self.advance_adaptive(alone, take),
        }
    }

    /// Reads these nodes also at the ends of runs. `further`: number of parameters that follow those of the model.
    ///
    /// # Errors
    /// The nodes are solutions of linear systems, which are found run by run.
    pub fn with_ends(self, model: &Model, nodes: &[NodeId], further: usize) -> Result<Self, NoLanes> {
        Ok(Self { ends: Ends::new(model, nodes, further)?, ..self })
    }

    /// Evaluates the nodes of [`Ensemble::with_ends`] at the last row of each run at or before its end. `set` gets the index of a run
    /// and sets its further parameters, SI units.
    pub fn evaluate_ends(&mut self, set: &mut dyn FnMut(usize, &mut [f64])) {
        self.ends.evaluate(&self.lanes, self.width, set);
    }

    /// Value of a node at the end of a run, SI units, after [`Ensemble::evaluate_ends`].
    pub fn value_at_end(&self, run: usize, node: usize) -> f64 {
        self.ends.value(run, node)
    }

    /// Error of a run; `None` if it has none. An event that ends the run is none.
    pub fn error(&self, run: usize) -> Option<&RunError> {
        self.lanes.errors[run].as_ref()
    }

    /// Number of operations in all lanes of the last runs.
    pub fn work(&self) -> u64 {
        let operations = self.rates.operations() + self.rates.states().len();
        self.attempts * (operations * self.lanes.running.len()) as u64
    }

    /// Makes room for so many blocks of runs.
    fn resize(&mut self, parameters: usize, states: usize, blocks: usize) {
        let width = self.width;
        if self.lanes.blocks == blocks {
            return;
        }
        for body in [&mut self.rates, &mut self.readings, &mut self.initial] {
            body.resize(blocks, width);
        }
        match &mut self.method {
            Method::Fixed(fixed) => fixed.resize(blocks),
            Method::Adaptive(steps) => steps.resize(states, blocks),
        }
        if let Some(checks) = &mut self.checks {
            checks.resize(states, parameters, (blocks, width));
        }
        self.lanes = Lanes::new(parameters, states, blocks, self.readings.len());
    }

    /// Sets initial values, and takes the first rows.
    fn begin(&mut self, alone: &Alone, take: &mut dyn FnMut(usize, f64, &[f64])) {
        let lanes = &mut self.lanes;
        match &self.start {
            Some(start) => start.iter().enumerate().for_each(|(row, &value)| lanes.initial.fill(row, value)),
            None => {
                self.initial.prepare(&lanes.parameters, &lanes.initial);
                self.initial.evaluate();
                for (row, &root) in self.initial.roots().iter().enumerate() {
                    lanes.initial.row_mut(row).copy_from_slice(self.initial.grid().row(root as usize));
                }
            }
        }
        lanes.begin();
        if !(lanes.parameters.is_finite() && lanes.initial.is_finite()) {
            for lane in 0..lanes.runs {
                let begun = lanes.begun(lane);
                let finite = begun.iter().flatten().all(|value| value.is_finite());
                if let Some(error) = (!finite).then(|| alone.refusal(&begun[0])).flatten() {
                    lanes.end(lane, Err(error));
                }
            }
        }
        self.readings.prepare(&lanes.parameters, &lanes.initial);
        if self.grid.last >= 0.0 && !self.readings.is_empty() {
            let running = lanes.running.clone();
            let initial = lanes.initial.clone();
            self.read(&Grid::new(1, initial.blocks()), &initial, &running, take);
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
    let motion = match stepper.motion() {
        Some(routine) => Body::of_routine(routine, states).ok_or(NoLanes::Interpreted(Interpreted::LinearSystem))?,
        None => Body::default(),
    };
    Ok(bodies.try_into().ok().map(|bodies| Checks::new(bodies, motion)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The row is that which is found by counting.
    #[test]
    fn the_last_row_reached_is_found_from_a_time() {
        for step in [0.1, 0.05, 1.0 / 3.0, 7e-9, 12.0] {
            let times = Times::new(step, 500.0 * step);
            for tick in 0..6000 {
                for end in [f64::next_down, f64::next_up, |time| time].map(|near| near(f64::from(tick) * 0.1 * step)) {
                    let end = end.max(0.0);
                    let counted = (0..times.all).take_while(|index| times.at(index + 1) <= end).count() as u64;
                    assert_eq!(times.reached(counted.min(3), end), counted, "{step} {end}");
                }
            }
        }
    }
}
