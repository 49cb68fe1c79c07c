//! Curves and points over the values of a parameter. Definitions are evaluated at once; values taken from runs are
//! computed in time slices.

use crate::motion::Motion;
use crate::time::course::Course;
use engine::{Advance, Folds, Readings, Run, RunError, Setup};
use figure::Interval;
use program::{Model, NodeId, Plot, Sweep, Taken};
use units::Unit;

/// Curves of one plot over the values of a parameter, as far as computed.
#[derive(Debug)]
pub(crate) struct Swept {
    sweep: Sweep,
    /// Unit of the horizontal axis, and units of the curves.
    unit: Unit,
    units: Vec<Unit>,
    /// Values read at each row of a run: operands of aggregates, or the points and the count of their event.
    rows: Readings,
    /// Final values of each curve.
    drawn: Readings,
    /// Evaluates the initial state of a run, on which definitions may depend.
    initial: Readings,
    /// Settings with which the values were computed.
    setup: Option<Setup>,
    /// Number of parameter values.
    count: usize,
    /// Abscissas: parameter values, in the unit of the axis; for points, one entry per point.
    pub(super) x: Vec<f64>,
    /// Ordinates, one list per curve, in the units of the curves. NaN while unknown. Points are appended as runs
    /// proceed.
    pub(super) y: Vec<Vec<f64>>,
    /// Number of complete runs, and the run in progress.
    done: usize,
    run: Option<Going>,
}

/// A run in progress and the values taken from it so far.
#[derive(Debug)]
struct Going {
    run: Run,
    /// Intermediate results of the aggregates.
    folds: Folds,
    /// Values at the previous row, for points.
    before: Option<Vec<f64>>,
    /// Number of points taken from this run.
    points: usize,
}

impl Swept {
    /// Sweep for a plot over a range of parameter values, with curves in these units.
    pub fn new(model: &Model, plot: &Plot, sweep: &Sweep, units: Vec<Unit>) -> Self {
        let own = |(curve, taken): (&program::Curve, &Taken)| match taken {
            Taken::Run(node) => *node,
            Taken::Value | Taken::Points(_) => curve.value.node,
        };
        let drawn: Vec<NodeId> = plot.curves.iter().zip(&sweep.taken).map(own).collect();
        let rows: Vec<NodeId> = if sweep.is_of_points() {
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
        let [rows, drawn, initial] = [&rows, &drawn, &starts].map(|nodes| Readings::new(model, nodes));
        Self { sweep: sweep.clone(), unit, units, rows, drawn, initial, setup: None, count, x, y, done: 0, run: None }
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
        (self.run, self.done) = (None, 0);
        if self.is_of_points() {
            self.x.clear();
            self.y.iter_mut().for_each(Vec::clear);
            self.setup = Some(setup);
            return true;
        }
        let nothing = vec![0.0; self.initial_length(course)];
        for (place, value) in self.sweep.values().enumerate() {
            let mut parameters = setup.parameters.clone();
            if let Some(parameter) = parameters.get_mut(self.sweep.parameter) {
                *parameter = value;
            }
            let start = self.initial.at(&parameters, &nothing, 0.0, &nothing).to_vec();
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

    fn initial_length(&self, course: &Course) -> usize {
        course.state().len()
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
            let Some(going) = self.run.take().or_else(|| self.begin(motion)) else {
                // A run that cannot start leaves a gap.
                self.done += 1;
                *left = left.saturating_sub(1_000);
                continue;
            };
            self.go_on(going, left);
        }
    }

    /// Starts the next run; `None` if it cannot start.
    fn begin(&mut self, motion: Motion) -> Option<Going> {
        let mut setup = self.setup.clone()?;
        *setup.parameters.get_mut(self.sweep.parameter)? = self.sweep.values().nth(self.done)?;
        let run = motion.start(setup).ok()?;
        let mut going = Going { run, folds: Folds::new(&self.sweep.aggregates), before: None, points: 0 };
        self.take(&mut going, 0);
        Some(going)
    }

    /// Takes the values to be drawn from one row of a run.
    fn take(&mut self, going: &mut Going, row: usize) {
        let history = going.run.history();
        let time = history.time(row);
        if time > self.sweep.until * (1.0 + engine::ROUNDING) {
            return;
        }
        if self.is_of_points() {
            let values = self.rows.at_row(history, row).to_vec();
            self.add_points(going, time, &values);
            going.before = Some(values);
        } else {
            going.folds.take(&self.sweep.aggregates, time, self.rows.at_row(history, row));
        }
    }

    /// Appends one point per curve: the values at this row, or, if an event has fired since the previous row, those of
    /// that row.
    fn add_points(&mut self, going: &mut Going, time: f64, values: &[f64]) {
        let before = going.before.as_deref();
        let taken = match (self.sweep.at, before) {
            (None, _) => Some(values),
            (Some(_), Some(before)) if values.last() > before.last() => Some(before),
            (Some(_), _) => None,
        };
        let counts = |taken: &Taken| matches!(taken, Taken::Points(from) if time >= *from);
        let is_full = going.points >= Sweep::MOST_POINTS / self.count.max(1);
        let Some(values_taken) = taken.filter(|_| !is_full && self.sweep.taken.iter().any(counts)) else { return };
        self.x.push(self.sweep.values().nth(self.done).map_or(f64::NAN, |value| self.unit.from_si(value)));
        let columns = self.y.iter_mut().zip(&self.sweep.taken);
        for (((column, taken), value), unit) in columns.zip(values_taken).zip(&self.units) {
            column.push(if counts(taken) { unit.from_si(*value) } else { f64::NAN });
        }
        going.points += 1;
    }

    /// Continues a run to its end, or until the work in `left` is used up.
    fn go_on(&mut self, mut going: Going, left: &mut u64) {
        let mut ends = true;
        while going.run.time() < self.sweep.until * (1.0 - engine::ROUNDING) {
            if *left == 0 {
                self.run = Some(going);
                return;
            }
            let (rows, work) = (going.run.history().len(), going.run.work());
            let advance = going.run.advance_within(*left);
            *left = left.saturating_sub((going.run.work() - work).max(1));
            for row in rows..going.run.history().len() {
                self.take(&mut going, row);
            }
            going.run.forget();
            if advance.as_ref().is_err_and(RunError::is_end) {
                break;
            }
            if matches!(advance, Err(_) | Ok(Advance::Full)) {
                ends = false;
                break;
            }
        }
        let rows = going.run.history().len();
        // An event that ends the run at this point has no further effect.
        let _ = going.run.finish(self.sweep.until);
        for row in rows..going.run.history().len() {
            self.take(&mut going, row);
        }
        // A run that fails has no value.
        if ends {
            self.draw(&going);
        }
        self.done += 1;
    }

    /// Computes the values of a complete run.
    fn draw(&mut self, going: &Going) {
        let (history, aggregates) = (going.run.history(), &self.sweep.aggregates);
        let values = going.folds.values_at_end(aggregates, &mut self.drawn, history, self.sweep.until);
        let Some(values) = values else { return };
        let columns = self.y.iter_mut().zip(&self.sweep.taken).zip(values.iter().zip(&self.units));
        for ((column, taken), (value, unit)) in columns {
            if let (Some(cell), Taken::Run(_)) = (column.get_mut(self.done), taken) {
                *cell = unit.from_si(*value);
            }
        }
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
