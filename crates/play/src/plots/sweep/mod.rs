//! Curves and points over the values of a parameter. Definitions are evaluated at once; values taken from runs are
//! computed in time slices, or by workers.
//!
//! `Plots::work` makes the runs that sweeps need, a portion in each frame. `Plots::work_beside` leaves to `SweepWorkers` what
//! the first portion after a change does not finish. It divides the runs into batches of at most 64 neighbouring values
//! (`batches.rs`), each a `SweepWork` that needs nothing else, and takes `SweepNews`. Runs are drawn in the order of their
//! values, so that the picture does not depend on which worker is ready first.

mod batches;
mod runs;
mod taking;
mod workers;

pub use taking::TakenRun;
pub use workers::{SweepComputation, SweepNews, SweepWork, SweepWorkers};

use crate::motion::Motion;
use crate::time::course::Course;
use batches::Batches;
use engine::Setup;
use figure::Interval;
use program::{Model, NodeId, Plot, Sweep, Taken};
use runs::Runs;
use units::Unit;

/// Curves of one plot over the values of a parameter, as far as computed.
#[derive(Debug)]
pub(crate) struct Swept {
    sweep: Sweep,
    /// Unit of the horizontal axis, and units of the curves.
    unit: Unit,
    units: Vec<Unit>,
    /// Final value of each curve.
    drawn: Vec<NodeId>,
    /// Settings with which the values were computed.
    setup: Option<Setup>,
    /// Number of parameter values.
    count: usize,
    /// Abscissas: parameter values, in the unit of the axis; for points, one entry per point.
    pub(super) x: Vec<f64>,
    /// Ordinates, one list per curve, in the units of the curves. NaN while unknown. Points are appended as runs
    /// proceed.
    pub(super) y: Vec<Vec<f64>>,
    /// Number of runs that are drawn.
    done: usize,
    /// Runs that are made here.
    runs: Runs,
    /// True until the first slice: what fits into it is drawn sooner than any worker could answer.
    is_new: bool,
    /// Runs that workers make.
    batches: Batches,
}

impl Swept {
    /// Sweep for a plot over a range of parameter values, with curves in these units.
    pub fn new(model: &Model, plot: &Plot, sweep: &Sweep, units: Vec<Unit>) -> Self {
        let own = |(curve, taken): (&program::Curve, &Taken)| match taken {
            Taken::Run(node) => *node,
            Taken::Value | Taken::Points(_) => curve.value.node,
        };
        let drawn: Vec<NodeId> = plot.curves.iter().zip(&sweep.taken).map(own).collect();
        let unit = plot.x.value.unit.clone();
        let mut x: Vec<f64> = sweep.values().map(|value| unit.from_si(value)).collect();
        if sweep.is_of_points() {
            x.clear();
        }
        let y = vec![vec![f64::NAN; x.len()]; plot.curves.len()];
        Self {
            unit,
            units,
            setup: None,
            count: sweep.count(),
            x,
            y,
            done: 0,
            runs: Runs::new(model, sweep, &drawn),
            is_new: true,
            batches: Batches::default(),
            sweep: sweep.clone(),
            drawn,
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
    /// at once.
    pub fn follow(&mut self, course: &Course) {
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
            return;
        }
        self.runs.discard();
        self.batches.clear();
        (self.done, self.is_new) = (0, true);
        if self.is_of_points() {
            self.x.clear();
            self.y.iter_mut().for_each(Vec::clear);
            self.setup = Some(setup);
            return;
        }
        for place in 0..self.count {
            let values = self.runs.values_without_run(&setup, place);
            for (curve, (column, taken)) in self.y.iter_mut().zip(&self.sweep.taken).enumerate() {
                if let (Taken::Value, Some(cell), Some(unit)) = (taken, column.get_mut(place), self.units.get(curve)) {
                    *cell = unit.from_si(values.get(curve).copied().unwrap_or(f64::NAN));
                } else if let Some(cell) = column.get_mut(place) {
                    *cell = f64::NAN;
                }
            }
        }
        self.setup = Some(setup);
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

    /// Continues the runs here. `left` is the remaining work in floating-point operations and is reduced by the work done.
    pub fn proceed(&mut self, motion: Motion, left: &mut u64) {
        let Some(setup) = self.setup.clone().filter(|_| self.is_unfinished()) else { return };
        self.is_new &= *left == 0;
        while *left > 0 && self.done < self.count {
            if let Some(taken) = self.runs.proceed(motion, &setup, self.done..self.count, left) {
                self.draw(&taken);
            }
        }
    }

    /// True until the first slice has been computed here.
    pub fn is_new(&self) -> bool {
        self.is_new
    }

    /// Numbers of the batches in progress.
    pub fn in_progress(&self) -> impl Iterator<Item = u32> {
        self.batches.in_progress()
    }

    /// Begins as many batches as `free` workers of `count` can compute. Returns the number of batches begun.
    pub fn hand_out(&mut self, model: &Model, workers: &mut dyn SweepWorkers, [free, count]: [usize; 2]) -> usize {
        let Some(setup) = &self.setup else { return 0 };
        for begun in 0..free {
            let Some(numbers) = self.batches.next(self.done..self.count, count) else { return begun };
            self.runs.discard();
            let work = SweepWork::new(model, (&self.sweep, &self.drawn), setup, numbers.clone());
            self.batches.add(workers.begin(work), numbers);
        }
        free
    }

    /// Forgets what workers compute and is not drawn.
    pub fn take_back(&mut self) {
        self.batches.clear();
    }

    /// Takes the news of a batch of this plot, and draws the runs that can be drawn. Others are ignored.
    pub fn take_news(&mut self, number: u32, news: &SweepNews) {
        if !self.in_progress().any(|own| own == number) {
            return;
        }
        match news {
            SweepNews::Taken { runs, .. } => {
                self.batches.take(number, runs);
                self.batches.ready().iter().for_each(|taken| self.draw(taken));
            }
            SweepNews::Lost => self.take_back(),
        }
    }

    /// Draws the points and values of the next run.
    fn draw(&mut self, taken: &TakenRun) {
        let value = self.sweep.values().nth(self.done).map_or(f64::NAN, |value| self.unit.from_si(value));
        for point in taken.points.chunks(self.y.len().max(1)) {
            self.x.push(value);
            for ((column, value), unit) in self.y.iter_mut().zip(point).zip(&self.units) {
                column.push(unit.from_si(*value));
            }
        }
        let columns = self.y.iter_mut().zip(&self.sweep.taken).zip(taken.values.iter().zip(&self.units));
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
