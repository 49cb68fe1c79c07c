//! The runs of a plan.

use crate::Plan;
use engine::{Folds, Readings, Run, RunError, Setup};
use ensemble::{Alone, Ended, Ensemble, NoLanes};
use program::{Model, NodeId, Outcomes};
use rayon::prelude::*;
use std::ops::Range;

/// Size in bytes of a run's history at which its rows, which have been taken, are dropped.
const HISTORY: usize = 1 << 18;

/// A run of a plan: the values of the axes, and what was taken, in the units of [`Outcomes::curves`].
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Number of the run, from 0.
    pub run: u64,
    /// Values of the axes, SI units.
    pub axes: Vec<f64>,
    /// The numbers that were taken, or why the run has none.
    pub taken: Result<Vec<f64>, RunError>,
}

/// What runs of one model with one setup need, whatever the plan says: compiled once.
#[derive(Clone, Debug)]
pub struct SweepCode {
    /// Runs in lanes, or why there are none.
    ensemble: Result<Ensemble, NoLanes>,
    /// What the aggregates take at a row.
    nodes: Vec<NodeId>,
    operands: Readings,
    /// The numbers at the end of a run.
    last: Readings,
}

impl SweepCode {
    /// Compiles runs up to `until` (SI) with this setup. What is taken is compiled against the model.
    pub fn new(model: &Model, (setup, until): (&Setup, f64), outcomes: &Outcomes) -> Self {
        let nodes: Vec<NodeId> = outcomes.aggregates.iter().map(|aggregate| aggregate.of).collect();
        Self {
            ensemble: Ensemble::new(model, setup, until, &nodes),
            operands: Readings::new(model, &nodes),
            last: Readings::new(model, &outcomes.nodes),
            nodes,
        }
    }

    /// Why the runs are computed one by one; `None` if they are computed side by side.
    pub fn no_lanes(&self) -> Option<&NoLanes> {
        self.ensemble.as_ref().err()
    }

    /// The same, but the runs are computed one by one.
    #[must_use]
    pub fn one_by_one(self) -> Self {
        Self { ensemble: Err(NoLanes::Unwanted), ..self }
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

/// What one thread needs.
struct Worker<'a> {
    code: SweepCode,
    alone: Alone<'a>,
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
        let together = match &self.code.ensemble {
            Ok(ensemble) => {
                let share = (runs.end - runs.start).div_ceil(threads() as u64).next_multiple_of(Self::LEAST);
                share.clamp(Self::LEAST, ensemble.lanes() as u64)
            }
            Err(_) => 1,
        };
        let blocks = (runs.end - runs.start).div_ceil(together);
        let block = |worker: &mut Worker, block: u64| {
            let first = runs.start + block * together;
            self.block(worker, first..runs.end.min(first + together))
        };
        (0..blocks).into_par_iter().map_init(|| self.worker(), block).flatten_iter().collect()
    }

    fn worker(&self) -> Worker<'_> {
        Worker { code: self.code.clone(), alone: Alone::new(self.model, self.setup, &self.code.nodes) }
    }

    /// Computes some runs side by side.
    fn block(&self, worker: &mut Worker, runs: Range<u64>) -> Vec<Outcome> {
        let axes: Vec<Vec<f64>> = runs.clone().map(|run| self.plan.values(run)).collect();
        let parameters: Vec<Vec<f64>> = axes.iter().map(|axes| self.parameters(axes)).collect();
        let taken = match &mut worker.code.ensemble {
            Ok(_) => self.together(worker, &parameters),
            Err(_) => parameters.into_iter().map(|parameters| self.single(&mut worker.code, parameters)).collect(),
        };
        runs.zip(axes).zip(taken).map(|((run, axes), taken)| Outcome { run, axes, taken }).collect()
    }

    /// Parameters with these values of the axes.
    fn parameters(&self, axes: &[f64]) -> Vec<f64> {
        let mut parameters = self.setup.parameters.clone();
        for (axis, value) in self.plan.axes().iter().zip(axes) {
            if let Some(parameter) = parameters.get_mut(axis.parameter) {
                *parameter = *value;
            }
        }
        parameters
    }

    /// What is taken of runs with these parameters, which are computed in lanes.
    fn together(&self, worker: &mut Worker, parameters: &[Vec<f64>]) -> Vec<Result<Vec<f64>, RunError>> {
        let aggregates = &self.outcomes.aggregates;
        let Worker { code: SweepCode { ensemble: Ok(ensemble), last, .. }, alone } = worker else { return Vec::new() };
        let mut folds = vec![Folds::new(aggregates); parameters.len()];
        let mut take = |lane: usize, time: f64, values: &[f64]| folds[lane].take(aggregates, time, values);
        let ends = ensemble.run(alone, parameters, &mut take);
        let taken = |((end, folds), parameters): ((Result<Ended, RunError>, &Folds), &Vec<f64>)| {
            let Ended { last: row, initial } = end?;
            let values = folds.values(aggregates, last, [parameters, &initial], (row.time, &row.state));
            Ok(self.in_units(values))
        };
        ends.into_iter().zip(&folds).zip(parameters).map(taken).collect()
    }

    /// What is taken of one run.
    fn single(&self, code: &mut SweepCode, parameters: Vec<f64>) -> Result<Vec<f64>, RunError> {
        let aggregates = &self.outcomes.aggregates;
        let last = self.until * (1.0 + engine::ROUNDING);
        let mut run = Run::start(self.model, Setup { parameters, ..self.setup.clone() })?;
        let mut folds = Folds::new(aggregates);
        let mut take = |run: &Run, rows: Range<usize>| {
            for row in rows.filter(|_| !aggregates.is_empty()) {
                let time = run.history().time(row);
                if time <= last {
                    folds.take(aggregates, time, code.operands.at_row(run.history(), row));
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
        let values = folds.values_at_end(aggregates, &mut code.last, run.history(), self.until);
        Ok(self.in_units(values.unwrap_or_default()))
    }

    /// Values (SI) in the units of [`Outcomes::curves`].
    fn in_units(&self, values: &[f64]) -> Vec<f64> {
        let units = self.outcomes.curves.iter().map(|curve| &curve.value.unit);
        values.iter().zip(units).map(|(value, unit)| unit.from_si(*value)).collect()
    }
}
