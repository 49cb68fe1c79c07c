//! The runs of a plot over a parameter: 64 neighbouring values side by side, or one after the other.

use super::taking::{TakenRun, Taking};
use crate::motion::Motion;
use engine::{Advance, LANES, Readings, Run, RunError, Setup, SideBySide};
use program::{Model, NodeId, Sweep};
use std::ops::Range;

/// Fewer runs are made one by one.
pub(super) const FEW: usize = 16;

/// Makes the runs of parameter values in ascending order, in portions of work.
#[derive(Debug)]
pub(super) struct Runs {
    sweep: Sweep,
    /// Values read at each row of a run: operands of aggregates, or the points and the count of their event.
    nodes: Vec<NodeId>,
    rows: Readings,
    /// Final values of each curve.
    drawn: Readings,
    /// Evaluates the initial state of a run, on which definitions may depend.
    initial: Readings,
    /// Number of states.
    states: usize,
    /// The run in progress.
    run: Option<(Run, Taking)>,
    /// Runs in progress side by side.
    together: Option<Together>,
    /// True if runs are known to be made one by one.
    alone: bool,
}

/// Runs that are made side by side, and then given one after the other.
#[derive(Debug)]
struct Together {
    runs: Box<dyn SideBySide>,
    /// Number of the first one.
    first: usize,
    /// Parameters and initial values of each, SI units.
    begun: Vec<[Vec<f64>; 2]>,
    /// Values taken from each.
    takings: Vec<Taking>,
    /// True if they are complete.
    ended: bool,
}

/// Result of a portion of work on runs side by side.
enum Portion {
    /// They go on.
    GoesOn,
    /// The next run is complete.
    Complete(TakenRun),
    /// The next run is made alone.
    Alone,
}

impl Runs {
    /// Runs of a sweep. `drawn`: the final value of each curve.
    pub fn new(model: &Model, sweep: &Sweep, drawn: &[NodeId]) -> Self {
        let nodes: Vec<NodeId> = if sweep.is_of_points() {
            drawn.iter().copied().chain(sweep.at).collect()
        } else {
            sweep.aggregates.iter().map(|aggregate| aggregate.of).collect()
        };
        let starts: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
        let [rows, drawn, initial] = [&nodes[..], drawn, &starts].map(|nodes| Readings::new(model, nodes));
        Self {
            sweep: sweep.clone(),
            nodes,
            rows,
            drawn,
            initial,
            states: starts.len(),
            run: None,
            together: None,
            alone: false,
        }
    }

    /// Discards the runs in progress.
    pub fn discard(&mut self) {
        (self.run, self.together, self.alone) = (None, None, false);
    }

    /// Values of the curves that need no run, for the parameter value of this number; NaN for the others. SI units.
    pub fn values_without_run(&mut self, setup: &Setup, number: usize) -> &[f64] {
        let [mut parameters, start] = self.begun(setup, number);
        parameters.extend(self.sweep.aggregates.iter().map(|_| f64::NAN));
        self.drawn.at(&parameters, &start, 0.0, &start)
    }

    /// Parameters and initial values of the run of a parameter value, SI units.
    fn begun(&mut self, setup: &Setup, number: usize) -> [Vec<f64>; 2] {
        let mut parameters = setup.parameters.clone();
        if let (Some(parameter), Some(value)) =
            (parameters.get_mut(self.sweep.parameter), self.sweep.values().nth(number))
        {
            *parameter = value;
        }
        let nothing = vec![0.0; self.states];
        let initial = self.initial.at(&parameters, &nothing, 0.0, &nothing).to_vec();
        [parameters, initial]
    }

    /// Continues the first of the runs with these numbers. `left` is the remaining work in floating-point operations and is
    /// reduced by the work done. Returns what is taken from the run once it is complete; the next call must begin with the run
    /// after it.
    pub fn proceed(
        &mut self,
        motion: Motion,
        setup: &Setup,
        numbers: Range<usize>,
        left: &mut u64,
    ) -> Option<TakenRun> {
        let next = numbers.start;
        if self.run.is_none() {
            match self.proceed_together(motion, setup, numbers, left) {
                Portion::GoesOn => return None,
                Portion::Complete(taken) => return Some(taken),
                Portion::Alone => {}
            }
        }
        let Some((run, taking)) = self.run.take().or_else(|| self.begin(motion, setup, next)) else {
            // A run that cannot start leaves a gap.
            *left = left.saturating_sub(1_000);
            return Some(TakenRun::default());
        };
        self.go_on(run, taking, left)
    }

    /// Continues runs side by side, or gives the next one of them.
    fn proceed_together(&mut self, motion: Motion, setup: &Setup, numbers: Range<usize>, left: &mut u64) -> Portion {
        let next = numbers.start;
        let begun = self.together.take().filter(|together| next < together.first + together.takings.len());
        let Some(mut together) = begun.or_else(|| self.begin_together(motion, setup, numbers)) else {
            return Portion::Alone;
        };
        let portion = if together.ended {
            // A run that fails is made again alone: its points until then count.
            self.take_next(&mut together, next).map_or(Portion::Alone, Portion::Complete)
        } else {
            let Together { runs, takings, ended, .. } = &mut together;
            *ended = runs.advance(left, &mut |run, time, values| takings[run].take(&self.sweep, time, values));
            Portion::GoesOn
        };
        self.together = Some(together);
        portion
    }

    /// Begins the next runs side by side; `None` if they are few, or made one by one.
    fn begin_together(&mut self, motion: Motion, setup: &Setup, numbers: Range<usize>) -> Option<Together> {
        if numbers.len() < FEW || self.alone {
            return None;
        }
        let runs = motion.side_by_side(setup, &self.nodes);
        self.alone = runs.is_none();
        let mut runs = runs?;
        let first = numbers.start;
        let begun: Vec<_> = numbers.take(LANES).map(|number| self.begun(setup, number)).collect();
        let mut takings: Vec<_> = begun.iter().map(|_| Taking::new(&self.sweep)).collect();
        let mut take = |run: usize, time: f64, values: &[f64]| takings[run].take(&self.sweep, time, values);
        runs.begin(&begun, self.sweep.until, &mut take);
        Some(Together { runs, first, begun, takings, ended: false })
    }

    /// Values and points of the run with this number, of runs that were made side by side; `None` if it has failed.
    fn take_next(&mut self, together: &mut Together, number: usize) -> Option<TakenRun> {
        let run = number - together.first;
        let (time, state) = together.runs.end(run)?;
        let (taking, [parameters, initial]) = (&mut together.takings[run], &together.begun[run]);
        let aggregates = &self.sweep.aggregates;
        let values = taking.folds.values(aggregates, &mut self.drawn, [parameters, initial], (time, &state)).to_vec();
        Some(TakenRun { points: std::mem::take(&mut taking.points), values })
    }

    /// Starts the run with this number; `None` if it cannot start.
    fn begin(&mut self, motion: Motion, setup: &Setup, number: usize) -> Option<(Run, Taking)> {
        let mut setup = setup.clone();
        *setup.parameters.get_mut(self.sweep.parameter)? = self.sweep.values().nth(number)?;
        let run = motion.start(setup).ok()?;
        let mut taking = Taking::new(&self.sweep);
        self.take(&run, &mut taking, 0);
        Some((run, taking))
    }

    /// Takes the values to be drawn from the rows of a run from this one on.
    fn take(&mut self, run: &Run, taking: &mut Taking, from: usize) {
        for row in from..run.history().len() {
            taking.take(&self.sweep, run.history().time(row), self.rows.at_row(run.history(), row));
        }
    }

    /// Continues a run to its end, or until the work in `left` is used up.
    fn go_on(&mut self, mut run: Run, mut taking: Taking, left: &mut u64) -> Option<TakenRun> {
        let mut ends = true;
        while run.time() < self.sweep.until * (1.0 - engine::ROUNDING) {
            if *left == 0 {
                self.run = Some((run, taking));
                return None;
            }
            let (rows, work) = (run.history().len(), run.work());
            let advance = run.advance_within(*left);
            *left = left.saturating_sub((run.work() - work).max(1));
            self.take(&run, &mut taking, rows);
            run.forget();
            if advance.as_ref().is_err_and(RunError::is_end) {
                break;
            }
            if matches!(advance, Err(_) | Ok(Advance::Full)) {
                ends = false;
                break;
            }
        }
        let rows = run.history().len();
        // An event that ends the run at this point has no further effect.
        let _ = run.finish(self.sweep.until);
        self.take(&run, &mut taking, rows);
        let aggregates = &self.sweep.aggregates;
        let values = taking.folds.values_at_end(aggregates, &mut self.drawn, run.history(), self.sweep.until);
        // A run that fails has no value.
        let values = values.filter(|_| ends).map(<[f64]>::to_vec).unwrap_or_default();
        Some(TakenRun { points: taking.points, values })
    }
}
