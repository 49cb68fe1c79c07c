//! The runs of a plan.

use crate::Plan;
use engine::{Folds, Readings, Run, RunError, Setup};
use ensemble::{Alone, Ensemble, NoLanes};
use program::{Model, NodeId, Outcomes};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Mutex;

/// Size in bytes of a run's history at which its rows, which have been taken, are dropped.
const HISTORY: usize = 1 << 18;

/// A run of a plan, and what was taken, in the units of [`Outcomes::curves`].
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Number of the run, from 0.
    pub run: u64,
    /// The numbers that were taken, or why the run has none.
    pub taken: Result<Vec<f64>, RunError>,
}

/// Greatest number of operations ([`Ensemble::work`]) of runs that are computed on the thread of the caller: to wake others takes longer.
const SMALL: u64 = 40_000;

/// What runs of one model with one setup need, whatever the plan says: compiled once.
#[derive(Debug)]
pub struct SweepCode {
    prepared: Prepared,
    /// What the aggregates take at a row.
    nodes: Vec<NodeId>,
    /// Copies of `prepared` that have made runs and may make more.
    spare: Mutex<Vec<Prepared>>,
}

/// Code and memory of runs that one thread computes side by side.
#[derive(Clone, Debug)]
struct Prepared {
    /// Runs in lanes, or why there are none.
    ensemble: Result<Ensemble, NoLanes>,
    operands: Readings,
    /// The numbers at the end of a run.
    last: Readings,
    /// Parameters of the runs, SI units.
    parameters: Vec<Vec<f64>>,
    /// Initial values of a run, SI units.
    initial: Vec<f64>,
}

impl Clone for SweepCode {
    fn clone(&self) -> Self {
        Self { prepared: self.prepared.clone(), nodes: self.nodes.clone(), spare: Mutex::default() }
    }
}

impl SweepCode {
    /// Compiles runs up to `until` (SI) with this setup. What is taken is compiled against the model.
    pub fn new(model: &Model, (setup, until): (&Setup, f64), outcomes: &Outcomes) -> Self {
        let nodes: Vec<NodeId> = outcomes.aggregates.iter().map(|aggregate| aggregate.of).collect();
        let prepared = Prepared {
            ensemble: Ensemble::new(model, setup, until, &nodes),
            operands: Readings::new(model, &nodes),
            last: Readings::new(model, &outcomes.nodes),
            parameters: Vec::new(),
            initial: Vec::new(),
        };
        Self { prepared, nodes, spare: Mutex::default() }
    }

    /// Why the runs are computed one by one; `None` if they are computed side by side.
    pub fn no_lanes(&self) -> Option<&NoLanes> {
        self.prepared.ensemble.as_ref().err()
    }

    /// A copy of `prepared`, if possible one that has made runs.
    fn take(&self) -> Prepared {
        let spare = self.spare.lock().ok().and_then(|mut spare| spare.pop());
        spare.unwrap_or_else(|| self.prepared.clone())
    }

    fn give_back(&self, prepared: Prepared) {
        if let Ok(mut spare) = self.spare.lock() {
            spare.push(prepared);
        }
    }

    /// The same, but the runs are computed one by one.
    #[must_use]
    pub fn one_by_one(self) -> Self {
        let prepared = Prepared { ensemble: Err(NoLanes::Unwanted), ..self.prepared };
        Self { prepared, nodes: self.nodes, spare: Mutex::default() }
    }
}

/// Runs of one model with the parameters of a plan.
#[derive(Debug)]
pub struct Sweep<'a> {
    model: &'a Model,
    setup: &'a Setup,
    until: f64,
    plan: &'a Plan,
    outcomes: &'a Outcomes,
    code: &'a SweepCode,
}

/// Number of threads on which runs are computed.
pub fn threads() -> usize {
    rayon::current_num_threads()
}

/// Computes all runs of this process on so many threads. Has no effect after the first run.
pub fn use_threads(count: usize) {
    let _ = rayon::ThreadPoolBuilder::new().num_threads(count).build_global();
}

impl<'a> Sweep<'a> {
    /// Smallest number of runs that one thread computes side by side.
    pub const LEAST: u64 = 8;

    /// Runs up to `until` (SI) with this setup, in which the axes of the plan are set. `code` is compiled for the same model, setup
    /// and outcomes.
    pub fn new(
        model: &'a Model,
        (setup, until): (&'a Setup, f64),
        plan: &'a Plan,
        (outcomes, code): (&'a Outcomes, &'a SweepCode),
    ) -> Self {
        Self { model, setup, until, plan, outcomes, code }
    }

    /// Computes some runs on all processors and returns them in their order.
    pub fn compute(&self, runs: Range<u64>) -> Vec<Outcome> {
        let count = runs.end - runs.start;
        let alone = || Alone::new(self.model, self.setup, &self.code.nodes);
        // One that has made runs knows their work.
        let prepared = self.code.take();
        let (together, small) = match &prepared.ensemble {
            Ok(ensemble) => {
                let lanes = ensemble.lanes() as u64;
                let share = count.div_ceil(threads() as u64).next_multiple_of(Self::LEAST);
                (share.clamp(Self::LEAST, lanes), count <= lanes && (1..=SMALL).contains(&ensemble.work()))
            }
            Err(_) => (1, false),
        };
        self.code.give_back(prepared);
        if small {
            return self.block(&mut alone(), runs);
        }
        let blocks = count.div_ceil(together);
        let block = |alone: &mut Alone, block: u64| {
            let first = runs.start + block * together;
            self.block(alone, first..runs.end.min(first + together))
        };
        (0..blocks).into_par_iter().map_init(alone, block).flatten_iter().collect()
    }

    /// Computes some runs side by side.
    fn block(&self, alone: &mut Alone, runs: Range<u64>) -> Vec<Outcome> {
        let mut prepared = self.code.take();
        prepared.parameters.resize((runs.end - runs.start) as usize, Vec::new());
        let mut axes = Vec::new();
        for (run, parameters) in runs.clone().zip(&mut prepared.parameters) {
            self.plan.set(run, &mut axes);
            self.set_parameters(&axes, parameters);
        }
        let taken = match &prepared.ensemble {
            Ok(_) => self.together(&mut prepared, alone),
            Err(_) => (0..prepared.parameters.len()).map(|run| self.single(&mut prepared, run)).collect(),
        };
        self.code.give_back(prepared);
        runs.zip(taken).map(|(run, taken)| Outcome { run, taken }).collect()
    }

    /// Sets parameters to those with these values of the axes.
    fn set_parameters(&self, axes: &[f64], parameters: &mut Vec<f64>) {
        parameters.clone_from(&self.setup.parameters);
        for (axis, value) in self.plan.axes().iter().zip(axes) {
            if let Some(parameter) = parameters.get_mut(axis.parameter) {
                *parameter = *value;
            }
        }
    }

    /// Values taken of the prepared runs, which are computed in lanes.
    fn together(&self, prepared: &mut Prepared, alone: &mut Alone) -> Vec<Result<Vec<f64>, RunError>> {
        let aggregates = &self.outcomes.aggregates;
        let Prepared { ensemble: Ok(ensemble), last, parameters, initial, .. } = prepared else { return Vec::new() };
        let mut folds = vec![Folds::new(aggregates); parameters.len()];
        let mut take = |lane: usize, time: f64, values: &[f64]| folds[lane].take(aggregates, time, values);
        ensemble.compute(alone, parameters, &mut take);
        let taken = |(lane, (folds, parameters)): (usize, (&Folds, &Vec<f64>))| {
            let row = ensemble.end(lane, initial)?;
            let values = folds.values(aggregates, last, [parameters, initial], (row.time, &row.state));
            Ok(self.in_units(values))
        };
        folds.iter().zip(parameters.iter()).enumerate().map(taken).collect()
    }

    /// Values taken of one of the prepared runs.
    fn single(&self, prepared: &mut Prepared, run: usize) -> Result<Vec<f64>, RunError> {
        let aggregates = &self.outcomes.aggregates;
        let parameters = prepared.parameters[run].clone();
        let last = self.until * (1.0 + engine::ROUNDING);
        let mut run = Run::start(self.model, Setup { parameters, ..self.setup.clone() })?;
        let mut folds = Folds::new(aggregates);
        let mut take = |run: &Run, rows: Range<usize>| {
            for row in rows.filter(|_| !aggregates.is_empty()) {
                let time = run.history().time(row);
                if time <= last {
                    folds.take(aggregates, time, prepared.operands.at_row(run.history(), row));
                }
            }
        };
        take(&run, 0..run.history().len());
        while run.time() < self.until * (1.0 - engine::ROUNDING) {
            if run.history().bytes() > HISTORY {
                run.forget();
            }
            let rows = run.history().len();
            let advanced = run.advance();
            take(&run, rows..run.history().len());
            match advanced {
                Ok(_) => {}
                Err(error) if error.is_end() => break,
                Err(error) => return Err(error),
            }
        }
        let rows = run.history().len();
        match run.finish(self.until) {
            Err(error) if !error.is_end() => return Err(error),
            _ => take(&run, rows..run.history().len()),
        }
        let values = folds.values_at_end(aggregates, &mut prepared.last, run.history(), self.until);
        Ok(self.in_units(values.unwrap_or_default()))
    }

    /// Values (SI) in the units of [`Outcomes::curves`].
    fn in_units(&self, values: &[f64]) -> Vec<f64> {
        let units = self.outcomes.curves.iter().map(|curve| &curve.value.unit);
        values.iter().zip(units).map(|(value, unit)| unit.from_si(*value)).collect()
    }
}
