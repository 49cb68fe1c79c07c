//! The runs of a plan.

use crate::Plan;
use engine::{Folds, Readings, Run, RunError, Setup};
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

/// Runs of one model with the parameters of a plan.
#[derive(Debug)]
pub struct Sweep<'a> {
    model: &'a Model,
    setup: &'a Setup,
    until: f64,
    plan: &'a Plan,
    outcomes: &'a Outcomes,
}

/// Number of threads on which runs are computed.
pub fn threads() -> usize {
    rayon::current_num_threads()
}

/// Computes all runs of this process on so many threads. Has no effect after the first run.
pub fn use_threads(count: usize) {
    let _ = rayon::ThreadPoolBuilder::new().num_threads(count).build_global();
}

/// Evaluates what is taken, for one thread.
struct Reader {
    /// Operands of the aggregates at a row.
    operands: Readings,
    /// The numbers at the end of a run.
    last: Readings,
}

impl<'a> Sweep<'a> {
    /// Runs up to `until` (SI) with this setup, in which the axes of the plan are set. What is taken is compiled against the model.
    pub fn new(model: &'a Model, (setup, until): (&'a Setup, f64), plan: &'a Plan, outcomes: &'a Outcomes) -> Self {
        Self { model, setup, until, plan, outcomes }
    }

    /// Computes some runs on all processors and returns them in their order.
    pub fn compute(&self, runs: Range<u64>) -> Vec<Outcome> {
        runs.into_par_iter().map_init(|| self.reader(), |reader, run| self.one(reader, run)).collect()
    }

    fn reader(&self) -> Reader {
        let operands: Vec<NodeId> = self.outcomes.aggregates.iter().map(|aggregate| aggregate.of).collect();
        let [operands, last] = [&operands, &self.outcomes.nodes].map(|nodes| Readings::new(self.model, nodes));
        Reader { operands, last }
    }

    fn one(&self, reader: &mut Reader, run: u64) -> Outcome {
        let axes = self.plan.values(run);
        let mut setup = self.setup.clone();
        for (axis, value) in self.plan.axes().iter().zip(&axes) {
            if let Some(parameter) = setup.parameters.get_mut(axis.parameter) {
                *parameter = *value;
            }
        }
        Outcome { run, axes, taken: self.taken(reader, setup) }
    }

    fn taken(&self, reader: &mut Reader, setup: Setup) -> Result<Vec<f64>, RunError> {
        let aggregates = &self.outcomes.aggregates;
        let last = self.until * (1.0 + engine::ROUNDING);
        let mut run = Run::start(self.model, setup)?;
        let mut folds = Folds::new(aggregates);
        let mut take = |run: &Run, rows: Range<usize>| {
            for row in rows.filter(|_| !aggregates.is_empty()) {
                let time = run.history().time(row);
                if time <= last {
                    folds.take(aggregates, time, reader.operands.at_row(run.history(), row));
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
        let values = folds.values_at_end(aggregates, &mut reader.last, run.history(), self.until).unwrap_or_default();
        let units = self.outcomes.curves.iter().map(|curve| &curve.value.unit);
        Ok(values.iter().zip(units).map(|(value, unit)| unit.from_si(*value)).collect())
    }
}
