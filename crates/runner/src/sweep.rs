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

/// Numbers taken of consecutive runs of a plan, in the units of [`Outcomes::curves`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Taken {
    /// Numbers of the runs, from 0.
    runs: Range<u64>,
    /// The numbers of the first run, then those of the next one; NaN for a run that could not be computed.
    values: Vec<f64>,
    /// Runs that could not be computed, and why.
    errors: Vec<(u64, RunError)>,
}

impl Taken {
    /// No runs yet; those that are added begin with this number.
    pub fn starting_at(first: u64) -> Self {
        Self { runs: first..first, ..Self::default() }
    }

    /// Numbers of the runs, from 0.
    pub fn runs(&self) -> Range<u64> {
        self.runs.clone()
    }

    /// Values of the number with this index, one for each run; NaN for a run that could not be computed.
    pub fn values(&self, index: usize) -> impl Iterator<Item = f64> {
        let width = self.values.len() / self.runs.clone().count().max(1);
        self.values.iter().skip(index).step_by(width.max(1)).copied()
    }

    /// Numbers of the runs that could not be computed, and why.
    pub fn errors(&self) -> &[(u64, RunError)] {
        &self.errors
    }

    /// Adds the runs that follow.
    pub fn append(&mut self, next: Self) {
        self.runs.end = next.runs.end;
        self.values.extend(next.values);
        self.errors.extend(next.errors);
    }
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
    /// For runs that are computed one by one: the operands of the aggregates, and the numbers at the end.
    operands: Readings,
    last: Readings,
    /// Values of the axes of a run.
    axes: Vec<f64>,
}

impl Prepared {
    /// True if runs were made, and needed little work.
    fn is_short(&self) -> bool {
        self.ensemble.as_ref().is_ok_and(|ensemble| (1..=SMALL).contains(&ensemble.work()))
    }
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
            ensemble: Ensemble::new(model, setup, until, &nodes)
                .and_then(|ensemble| ensemble.with_ends(model, &outcomes.nodes, outcomes.aggregates.len())),
            operands: Readings::new(model, &nodes),
            last: Readings::new(model, &outcomes.nodes),
            axes: Vec::new(),
        };
        Self { prepared, nodes, spare: Mutex::default() }
    }

    /// Why the runs are computed one by one; `None` if they are computed side by side.
    pub fn no_lanes(&self) -> Option<&NoLanes> {
        self.prepared.ensemble.as_ref().err()
    }

    /// True if runs were made, and needed little work.
    pub fn is_short(&self) -> bool {
        let prepared = self.take();
        let is_short = prepared.is_short();
        self.give_back(prepared);
        is_short
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

    /// Computes some runs on all processors.
    pub fn compute(&self, runs: Range<u64>) -> Taken {
        let count = runs.end - runs.start;
        let alone = || Alone::new(self.model, self.setup, &self.code.nodes);
        // One that has made runs knows their work.
        let prepared = self.code.take();
        let (together, small) = match &prepared.ensemble {
            Ok(ensemble) => {
                let lanes = ensemble.lanes() as u64;
                let share = count.div_ceil(threads() as u64).next_multiple_of(Self::LEAST);
                (share.clamp(Self::LEAST, lanes), count <= lanes && prepared.is_short())
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
        let parts: Vec<Taken> = (0..blocks).into_par_iter().map_init(alone, block).collect();
        let mut taken = Taken::starting_at(runs.start);
        parts.into_iter().for_each(|part| taken.append(part));
        taken
    }

    /// Computes some runs side by side.
    fn block(&self, alone: &mut Alone, runs: Range<u64>) -> Taken {
        let mut prepared = self.code.take();
        let mut taken = Taken { runs, ..Taken::default() };
        match &mut prepared.ensemble {
            Ok(ensemble) => self.together(ensemble, &mut prepared.axes, alone, &mut taken),
            Err(_) => self.one_by_one(&mut prepared, &mut taken),
        }
        self.code.give_back(prepared);
        taken
    }

    /// Takes the runs, which are computed in lanes.
    fn together(&self, ensemble: &mut Ensemble, axes: &mut Vec<f64>, alone: &mut Alone, taken: &mut Taken) {
        let Taken { runs, values, errors } = taken;
        let aggregates = &self.outcomes.aggregates;
        let count = (runs.end - runs.start) as usize;
        ensemble.prepare(count, &self.setup.parameters);
        for (lane, run) in runs.clone().enumerate() {
            self.plan.set(run, axes);
            for (axis, value) in self.plan.axes().iter().zip(&*axes) {
                ensemble.set_parameter(lane, axis.parameter, *value);
            }
        }
        let mut folds = vec![Folds::new(aggregates); if aggregates.is_empty() { 0 } else { count }];
        ensemble.compute(alone, &mut |lane, time, values| folds[lane].take(aggregates, time, values));
        ensemble.evaluate_ends(&mut |lane, further| {
            further.iter_mut().zip(folds[lane].results(aggregates)).for_each(|(to, result)| *to = result);
        });
        let curves = &self.outcomes.curves;
        for (lane, run) in runs.clone().enumerate() {
            let error = ensemble.error(lane);
            let value = |node: usize| if error.is_some() { f64::NAN } else { ensemble.value_at_end(lane, node) };
            values.extend(curves.iter().enumerate().map(|(node, curve)| curve.value.unit.from_si(value(node))));
            errors.extend(error.map(|error| (run, error.clone())));
        }
    }

    /// Takes the runs, which are computed one after the other.
    fn one_by_one(&self, prepared: &mut Prepared, taken: &mut Taken) {
        let curves = &self.outcomes.curves;
        for run in taken.runs() {
            let found = self.single(prepared, run);
            let value = |node: usize| found.as_ref().ok()?.get(node).copied();
            let values = curves.iter().enumerate();
            let values = values.map(|(node, curve)| curve.value.unit.from_si(value(node).unwrap_or(f64::NAN)));
            taken.values.extend(values);
            taken.errors.extend(found.err().map(|error| (run, error)));
        }
    }

    /// Values (SI units) taken of a run.
    fn single(&self, prepared: &mut Prepared, run: u64) -> Result<Vec<f64>, RunError> {
        let aggregates = &self.outcomes.aggregates;
        let mut parameters = self.setup.parameters.clone();
        self.plan.set(run, &mut prepared.axes);
        for (axis, value) in self.plan.axes().iter().zip(&prepared.axes) {
            parameters[axis.parameter] = *value;
        }
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
        Ok(values.unwrap_or_default().to_vec())
    }
}
