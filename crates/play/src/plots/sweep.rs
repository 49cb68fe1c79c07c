//! Curves and points over the values of a parameter. Definitions are evaluated at once; values taken from runs are
//! computed in time slices.

use crate::motion::Motion;
use crate::time::course::Course;
use engine::{Advance, Folds, LANES, Readings, Run, RunError, Setup, SideBySide};
use figure::Interval;
use program::{Model, NodeId, Plot, Sweep, Taken};
use units::Unit;

/// Fewer runs are made one by one.
const FEW: usize = 16;

/// Curves of one plot over the values of a parameter, as far as computed.
#[derive(Debug)]
pub(crate) struct Swept {
    sweep: Sweep,
    /// Unit of the horizontal axis, and units of the curves.
    unit: Unit,
    units: Vec<Unit>,
    /// Values read at each row of a run: operands of aggregates, or the points and the count of their event.
    nodes: Vec<NodeId>,
    rows: Readings,
    /// Final values of each curve.
    drawn: Readings,
    /// Evaluates the initial state of a run, on which definitions may depend.
    initial: Readings,
    /// Settings with which the values were computed.
    setup: Option<Setup>,
    /// Number of parameter values, and of states.
    count: usize,
    states: usize,
    /// Abscissas: parameter values, in the unit of the axis; for points, one entry per point.
    pub(super) x: Vec<f64>,
    /// Ordinates, one list per curve, in the units of the curves. NaN while unknown. Points are appended as runs
    /// proceed.
    pub(super) y: Vec<Vec<f64>>,
    /// Number of complete runs, and the run in progress.
    done: usize,
    run: Option<(Run, Taking)>,
    /// Runs in progress side by side.
    together: Option<Together>,
    /// True if runs are known to be made one by one.
    alone: bool,
}

/// Runs that are made side by side, and then drawn one after the other.
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

/// Values taken from a run so far.
#[derive(Clone, Debug)]
struct Taking {
    /// Intermediate results of the aggregates.
    folds: Folds,
    /// Values at the previous row, for points.
    before: Option<Vec<f64>>,
    /// Points, SI units: one value per curve for each of them.
    points: Vec<f64>,
}

impl Taking {
    fn new(sweep: &Sweep) -> Self {
        Self { folds: Folds::new(&sweep.aggregates), before: None, points: Vec::new() }
    }

    /// Takes the values read at a row.
    fn take(&mut self, sweep: &Sweep, time: f64, values: &[f64]) {
        if time > sweep.until * (1.0 + engine::ROUNDING) {
            return;
        }
        if sweep.is_of_points() {
            self.add_points(sweep, time, values);
            self.before = Some(values.to_vec());
        } else {
            self.folds.take(&sweep.aggregates, time, values);
        }
    }

    /// Adds one point per curve: the values at this row, or, if an event has fired since the previous row, those of that row.
    fn add_points(&mut self, sweep: &Sweep, time: f64, values: &[f64]) {
        let before = self.before.as_deref();
        let taken = match (sweep.at, before) {
            (None, _) => Some(values),
            (Some(_), Some(before)) if values.last() > before.last() => Some(before),
            (Some(_), _) => None,
        };
        let counts = |taken: &Taken| matches!(taken, Taken::Points(from) if time >= *from);
        let is_full = self.points.len() / sweep.taken.len().max(1) >= Sweep::MOST_POINTS / sweep.count().max(1);
        let Some(values) = taken.filter(|_| !is_full && sweep.taken.iter().any(counts)) else { return };
        let points = sweep.taken.iter().zip(values);
        self.points.extend(points.map(|(taken, value)| if counts(taken) { *value } else { f64::NAN }));
    }
}

impl Swept {
    /// Sweep for a plot over a range of parameter values, with curves in these units.
    pub fn new(model: &Model, plot: &Plot, sweep: &Sweep, units: Vec<Unit>) -> Self {
        let own = |(curve, taken): (&program::Curve, &Taken)| match taken {
            Taken::Run(node) => *node,
            Taken::Value | Taken::Points(_) => curve.value.node,
        };
        let drawn: Vec<NodeId> = plot.curves.iter().zip(&sweep.taken).map(own).collect();
        let nodes: Vec<NodeId> = if sweep.is_of_points() {
            drawn.iter().copied().chain(sweep.at).collect()
        } else {
            sweep.aggregates.iter().map(|aggregate| aggregate.of).collect()
        };
        let starts: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
        let unit = plot.x.value.unit.clone();
        let count = sweep.count();
        let mut x: Vec<f64> = sweep.values().map(|value| unit.from_si(value)).collect();
        if sweep.is_of_points() {
            x.clear();
        }
        let y = vec![vec![f64::NAN; x.len()]; plot.curves.len()];
        let [rows, drawn, initial] = [&nodes, &drawn, &starts].map(|nodes| Readings::new(model, nodes));
        Self {
            sweep: sweep.clone(),
            unit,
            units,
            nodes,
            rows,
            drawn,
            initial,
            setup: None,
            count,
            states: starts.len(),
            x,
            y,
            done: 0,
            run: None,
            together: None,
            alone: false,
        }
    }

    /// True if the plot shows points instead of lines.
    pub fn is_of_points(&self) -> bool {
        self.sweep.is_of_points()
    }

    /// Least to greatest value of the parameter, in the unit of the axis.
    pub fn range(&self) -> Interval {
        let last = self.sweep.values().last().unwrap_or(self.sweep.low);
        Interval::new(self.unit.from_si(self.sweep.low), self.unit.from_si(last))
    }

    /// Restarts the sweep if parameters (except the swept one), method or step have changed; definitions are evaluated
    /// at once. Returns true if it restarted.
    pub fn follow(&mut self, course: &Course) -> bool {
        // A start set by hand and button presses belong to the visible run only.
        let parameters = course.parameters().to_vec();
        let setup = Setup { parameters, start: None, presses: Vec::new(), ..course.begun().clone() };
        let same = |before: &Setup| {
            let mut now = setup.parameters.clone();
            // The present value of the swept parameter is irrelevant.
            if let (Some(value), Some(own)) =
                (now.get_mut(self.sweep.parameter), before.parameters.get(self.sweep.parameter))
            {
                *value = *own;
            }
            before.parameters == now && (before.method, before.step) == (setup.method, setup.step)
        };
        if self.setup.as_ref().is_some_and(same) {
            return false;
        }
        (self.run, self.together, self.alone, self.done) = (None, None, false, 0);
        if self.is_of_points() {
            self.x.clear();
            self.y.iter_mut().for_each(Vec::clear);
            self.setup = Some(setup);
            return true;
        }
        for place in 0..self.count {
            let [mut parameters, start] = self.begun(&setup, place);
            parameters.extend(self.sweep.aggregates.iter().map(|_| f64::NAN));
            let values = self.drawn.at(&parameters, &start, 0.0, &start);
            for (curve, (column, taken)) in self.y.iter_mut().zip(&self.sweep.taken).enumerate() {
                if let (Taken::Value, Some(cell), Some(unit)) = (taken, column.get_mut(place), self.units.get(curve)) {
                    *cell = unit.from_si(values.get(curve).copied().unwrap_or(f64::NAN));
                } else if let Some(cell) = column.get_mut(place) {
                    *cell = f64::NAN;
                }
            }
        }
        self.setup = Some(setup);
        true
    }

    /// Parameters and initial values of the run of a parameter value, SI units.
    fn begun(&mut self, setup: &Setup, place: usize) -> [Vec<f64>; 2] {
        let mut parameters = setup.parameters.clone();
        if let (Some(parameter), Some(value)) =
            (parameters.get_mut(self.sweep.parameter), self.sweep.values().nth(place))
        {
            *parameter = value;
        }
        let nothing = vec![0.0; self.states];
        let initial = self.initial.at(&parameters, &nothing, 0.0, &nothing).to_vec();
        [parameters, initial]
    }

    /// Number of complete runs and total number; `None` if no runs are needed.
    pub fn progress(&self) -> Option<(usize, usize)> {
        let runs = self.sweep.taken.iter().any(|taken| *taken != Taken::Value);
        runs.then_some((self.done, self.count))
    }

    /// True if runs are missing.
    pub fn is_unfinished(&self) -> bool {
        self.setup.is_some() && self.progress().is_some_and(|(done, all)| done < all)
    }

    /// Continues the runs. `left` is the remaining work in floating-point operations and is reduced by the work done.
    pub fn proceed(&mut self, motion: Motion, left: &mut u64) {
        while *left > 0 && self.is_unfinished() {
            if self.run.is_none() && self.proceed_together(motion, left) {
                continue;
            }
            let Some((run, taking)) = self.run.take().or_else(|| self.begin(motion)) else {
                // A run that cannot start leaves a gap.
                self.done += 1;
                *left = left.saturating_sub(1_000);
                continue;
            };
            self.go_on(run, taking, left);
        }
    }

    /// Continues runs side by side, or draws the next one of them. False if the next run is made alone.
    fn proceed_together(&mut self, motion: Motion, left: &mut u64) -> bool {
        let begun = self.together.take().filter(|together| self.done < together.first + together.takings.len());
        let Some(mut together) = begun.or_else(|| self.begin_together(motion)) else { return false };
        let mut draws = true;
        if together.ended {
            draws = self.draw_next(&together);
        } else {
            let Together { runs, takings, ended, .. } = &mut together;
            *ended = runs.advance(left, &mut |run, time, values| takings[run].take(&self.sweep, time, values));
        }
        self.together = Some(together);
        draws
    }

    /// Begins the next runs side by side; `None` if they are few, or made one by one.
    fn begin_together(&mut self, motion: Motion) -> Option<Together> {
        let setup = self.setup.clone().filter(|_| self.count - self.done >= FEW && !self.alone)?;
        let runs = motion.side_by_side(&setup, &self.nodes);
        self.alone = runs.is_none();
        let mut runs = runs?;
        let first = self.done;
        let begun: Vec<_> = (first..self.count).take(LANES).map(|place| self.begun(&setup, place)).collect();
        let mut takings: Vec<_> = begun.iter().map(|_| Taking::new(&self.sweep)).collect();
        let mut take = |run: usize, time: f64, values: &[f64]| takings[run].take(&self.sweep, time, values);
        runs.begin(&begun, self.sweep.until, &mut take);
        Some(Together { runs, first, begun, takings, ended: false })
    }

    /// Draws the next one of runs that were made side by side. False if it has failed: what it has until then is found alone.
    fn draw_next(&mut self, together: &Together) -> bool {
        let run = self.done - together.first;
        let Some((time, state)) = together.runs.end(run) else { return false };
        let (taking, [parameters, initial]) = (&together.takings[run], &together.begun[run]);
        let aggregates = &self.sweep.aggregates;
        let values = taking.folds.values(aggregates, &mut self.drawn, [parameters, initial], (time, &state)).to_vec();
        self.draw(taking, &values);
        true
    }

    /// Starts the next run; `None` if it cannot start.
    fn begin(&mut self, motion: Motion) -> Option<(Run, Taking)> {
        let mut setup = self.setup.clone()?;
        *setup.parameters.get_mut(self.sweep.parameter)? = self.sweep.values().nth(self.done)?;
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
    fn go_on(&mut self, mut run: Run, mut taking: Taking, left: &mut u64) {
        let mut ends = true;
        while run.time() < self.sweep.until * (1.0 - engine::ROUNDING) {
            if *left == 0 {
                self.run = Some((run, taking));
                return;
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
        self.draw(&taking, &values);
    }

    /// Draws the points and values of the next run, which is complete; SI units.
    fn draw(&mut self, taking: &Taking, values: &[f64]) {
        let value = self.sweep.values().nth(self.done).map_or(f64::NAN, |value| self.unit.from_si(value));
        for point in taking.points.chunks(self.y.len().max(1)) {
            self.x.push(value);
            for ((column, value), unit) in self.y.iter_mut().zip(point).zip(&self.units) {
                column.push(unit.from_si(*value));
            }
        }
        let columns = self.y.iter_mut().zip(&self.sweep.taken).zip(values.iter().zip(&self.units));
        for ((column, taken), (value, unit)) in columns {
            if let (Some(cell), Taken::Run(_)) = (column.get_mut(self.done), taken) {
                *cell = unit.from_si(*value);
            }
        }
        self.done += 1;
    }

    /// Present value of the swept parameter, in the unit of the axis.
    pub fn present(&self, course: &Course) -> Option<f64> {
        course.parameters().get(self.sweep.parameter).map(|value| self.unit.from_si(*value))
    }

    /// Index of the first parameter value not below the present one, limited to the last value.
    pub fn present_row(&self, course: &Course) -> usize {
        let present = self.present(course).unwrap_or(f64::NAN);
        self.x.partition_point(|value| *value < present).min(self.x.len().saturating_sub(1))
    }
}
