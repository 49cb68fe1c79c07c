//! The course of one run: what is computed, what of it has been reached, and which moment of it is shown.
//!
//! The run is computed a little ahead: the time shown lies inside the last step or on its end. What lies behind the
//! *front*, the greatest time reached, can be shown again; what lies before it is not shown yet.

use engine::{Advance, CAPACITY, History, Run, RunError, Setup};
use program::Model;

/// The same run again: from these values, with these changes of parameters on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// What it starts with.
    pub setup: Setup,
    /// Parameters, each with the first row they hold for; ascending.
    pub changes: Vec<(usize, Vec<f64>)>,
    /// How far it goes (SI).
    pub front: f64,
    /// Which moment is shown (SI).
    pub time: f64,
}

/// How far [`Course::proceed`] got.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// Where it was to go.
    Reached,
    /// As far as the work allowed; so much is missing (SI).
    Behind(f64),
    /// As far as the memory allowed.
    Full,
    /// As far as the equations allow.
    Failed,
}

/// One run, and which moment of it is shown.
#[derive(Debug)]
pub struct Course {
    /// Absent when it could not start.
    run: Option<Run>,
    error: Option<RunError>,
    /// What it was started with.
    begun: Setup,
    changes: Vec<(usize, Vec<f64>)>,
    time: f64,
    front: f64,
    state: Vec<f64>,
    /// What the plots keep for each row, in bytes.
    overhead: usize,
}

impl Course {
    /// Starts a run; a failure is kept as [`Course::error`].
    pub fn start(model: &Model, setup: Setup, overhead: usize) -> Self {
        let mut course = Self {
            run: None,
            error: None,
            begun: setup.clone(),
            changes: Vec::new(),
            time: 0.0,
            front: 0.0,
            state: vec![f64::NAN; model.states.len()],
            overhead,
        };
        match Run::start(model, setup) {
            Ok(run) => course.run = Some(run),
            Err(error) => course.error = Some(error),
        }
        course.show(0.0);
        course
    }

    /// Runs a recipe with no more than about the work in `left` ([`Run::work`]), from which what was done is taken.
    /// Returns whether it could be followed to its end.
    pub fn replay(model: &Model, recipe: &Recipe, overhead: usize, left: &mut u64) -> (Self, bool) {
        let mut course = Self::start(model, recipe.setup.clone(), overhead);
        for (row, parameters) in &recipe.changes {
            while course.rows_computed() < *row && *left > 0 {
                if matches!(course.advance(left), None | Some(Advance::Full)) {
                    break;
                }
            }
            if course.rows_computed() != *row {
                course.proceed(course.last_time(), &mut 0);
                return (course, false);
            }
            course.set_parameters(model, parameters.clone());
        }
        let complete = course.proceed(recipe.front, left) == Outcome::Reached;
        course.show(recipe.time.min(course.front));
        (course, complete)
    }

    /// How to make this run again.
    pub fn recipe(&self) -> Recipe {
        Recipe { setup: self.begun.clone(), changes: self.changes.clone(), front: self.front, time: self.time }
    }

    /// What it was started with.
    pub fn begun(&self) -> &Setup {
        &self.begun
    }

    /// Why it cannot start or go on.
    pub fn error(&self) -> Option<&RunError> {
        self.error.as_ref()
    }

    /// The recorded rows; absent when it could not start.
    pub fn history(&self) -> Option<&History> {
        self.run.as_ref().map(Run::history)
    }

    /// How many rows lie at or behind the front.
    pub fn rows(&self) -> usize {
        self.history().map_or(0, |history| history.row_at(self.front) + 1)
    }

    /// How many rows lie at or before the moment shown.
    pub fn rows_until_shown(&self) -> usize {
        self.history().map_or(0, |history| history.row_at(self.time) + 1)
    }

    /// The time shown.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The greatest time reached.
    pub fn front(&self) -> f64 {
        self.front
    }

    /// The state at the time shown.
    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// The state at the start, what `y(0)` is; not numbers when it could not start.
    pub fn initial(&self) -> &[f64] {
        self.run.as_ref().map_or(&self.state, Run::initial)
    }

    /// Whether an earlier moment than the front is shown.
    pub fn is_scrubbed(&self) -> bool {
        self.time < self.front
    }

    /// The parameters in force at the time shown: those of the step it lies in, at the front those of the next step.
    pub fn parameters(&self) -> &[f64] {
        match &self.run {
            None => &self.begun.parameters,
            Some(run) if self.is_scrubbed() => run.history().parameters(self.row_ahead(run)),
            Some(run) => &run.setup().parameters,
        }
    }

    /// The state at a time behind the front, and the parameters that were in force there.
    pub fn state_at(&mut self, time: f64, out: &mut [f64]) -> Option<Vec<f64>> {
        let run = self.run.as_mut()?;
        run.interpolate(time, out);
        let history = run.history();
        Some(history.parameters((history.row_at(time) + 1).min(history.len() - 1)).to_vec())
    }

    /// Shows a moment between the start and the front.
    pub fn show(&mut self, time: f64) {
        self.time = if time.is_finite() { time.clamp(0.0, self.front) } else { self.front };
        if let Some(run) = &mut self.run {
            run.interpolate(self.time, &mut self.state);
        }
    }

    /// Goes on to `to` with no more than about the work in `left`, from which what was done is taken, and shows that moment.
    /// Only from the front: see [`Course::resume`].
    pub fn proceed(&mut self, to: f64, left: &mut u64) -> Outcome {
        let mut outcome = Outcome::Reached;
        while self.last_time() < to {
            if *left == 0 {
                outcome = Outcome::Behind(to - self.last_time());
                break;
            }
            match self.advance(left) {
                Some(Advance::Full) => {
                    outcome = Outcome::Full;
                    break;
                }
                Some(_) => {}
                None => {
                    outcome = Outcome::Failed;
                    break;
                }
            }
        }
        self.front = self.front.max(to.min(self.last_time()));
        self.show(self.front);
        outcome
    }

    /// The grid time after the one shown; one so near that a step to it would not be seen does not count.
    pub fn next_grid_time(&self) -> f64 {
        self.grid_time((self.time / self.begun.step + SEEN).floor() + 1.0)
    }

    /// The grid time before the one shown, likewise; 0 at the start.
    pub fn previous_grid_time(&self) -> f64 {
        self.grid_time((self.time / self.begun.step - SEEN).ceil() - 1.0).max(0.0)
    }

    /// The row at which the run goes on from an earlier moment: the end of the step that the moment lies in.
    pub fn resume_row(&self) -> Option<usize> {
        let run = self.run.as_ref()?;
        self.is_scrubbed().then(|| self.row_ahead(run))
    }

    /// Gives up the rows after the step that the moment shown lies in, so that the run goes on from there with the
    /// parameters then in force.
    pub fn resume(&mut self) {
        let Some(row) = self.resume_row() else { return };
        self.changes.retain(|&(first, _)| first <= row);
        self.front = self.time;
        if let Some(run) = &mut self.run {
            run.truncate(row);
            self.error = None;
        }
    }

    /// Changes the parameters from the next step on; at the very start, from the start on. None of them may decide an
    /// initial value.
    pub fn set_parameters(&mut self, model: &Model, parameters: Vec<f64>) {
        self.error = None;
        let Some(run) = self.run.as_mut().filter(|run| run.history().len() > 1) else {
            let setup = Setup { parameters, ..self.begun.clone() };
            *self = Self::start(model, setup, self.overhead);
            return;
        };
        // This gives up what is only partly a step, with the rows in it.
        run.set_parameters(parameters.clone());
        let row = run.history().len();
        self.changes.retain(|&(first, _)| first < row);
        let before = self.changes.last().map_or(&self.begun.parameters, |(_, last)| last);
        if *before != parameters {
            self.changes.push((row, parameters));
        }
    }

    /// To the next row, or as far as the work in `left` allows; `None` when it fails.
    fn advance(&mut self, left: &mut u64) -> Option<Advance> {
        let run = self.run.as_mut()?;
        let history = run.history();
        if history.bytes() + self.overhead * history.len() >= CAPACITY {
            return Some(Advance::Full);
        }
        let (rows, work) = (history.len(), run.work());
        let result = run.advance_within(*left);
        let recorded = (run.history().len() - rows) as u64 * (ROW + VALUE * self.state.len() as u64);
        *left = left.saturating_sub(recorded + run.work() - work);
        match result {
            Ok(advance) => Some(advance),
            Err(error) => {
                self.error = Some(error);
                None
            }
        }
    }

    fn rows_computed(&self) -> usize {
        self.history().map_or(0, History::len)
    }

    fn last_time(&self) -> f64 {
        self.history().and_then(|history| history.times().last().copied()).unwrap_or(0.0)
    }

    fn grid_time(&self, index: f64) -> f64 {
        index * self.begun.step
    }

    /// The last row at the first grid time at or after the time shown. Rows off the grid (events) are passed over: the
    /// rest of their step belongs to them.
    fn row_ahead(&self, run: &Run) -> usize {
        let times = run.history().times();
        let step = self.begun.step;
        let on_grid = |time: f64| (time / step - (time / step).round()).abs() < NEAR;
        let last = times.len().saturating_sub(1);
        let mut row = times.partition_point(|&time| time < self.time).min(last);
        while row + 1 < times.len() && (!on_grid(times[row]) || times[row + 1] == times[row]) {
            row += 1;
        }
        row
    }
}

/// The work of recording a row and its values, in floating-point operations.
const ROW: u64 = 20;
const VALUE: u64 = 4;
/// A step to a grid time nearer than this part of a step would look as if the button did nothing.
const SEEN: f64 = 0.25;
/// Grid times closer than this part of a step are the same: quotients of times are rounded.
const NEAR: f64 = 1e-6;
