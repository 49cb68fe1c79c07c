//! The course of one run: what is computed, what of it has been reached, and which moment of it is shown.
//!
//! The run is computed a little ahead: the time shown lies inside the last step or on its end. What lies behind the
//! *front*, the greatest time reached, can be shown again; what lies before it is not shown yet.

use engine::{Advance, CAPACITY, History, Notice, ROUNDING, Run, RunError, Setup};
use program::Model;

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
    /// The run, whose history is the record of all changes of parameters; what it was to start with, if it could not.
    run: Result<Run, Setup>,
    error: Option<RunError>,
    time: f64,
    front: f64,
    state: Vec<f64>,
    /// What the plots keep for each row, in bytes.
    overhead: usize,
}

impl Course {
    /// For other plots, which keep so many bytes for each row.
    pub fn set_overhead(&mut self, overhead: usize) {
        self.overhead = overhead;
    }

    /// Starts a run; a failure is kept as [`Course::error`].
    pub fn start(model: &Model, setup: Setup, overhead: usize) -> Self {
        let (run, error) = match Run::start(model, setup.clone()) {
            Ok(run) => (Ok(run), None),
            Err(error) => (Err(setup), Some(error)),
        };
        let state = vec![f64::NAN; model.states.len()];
        let mut course = Self { run, error, time: 0.0, front: 0.0, state, overhead };
        course.show(0.0);
        course
    }

    /// What it was started with.
    pub fn begun(&self) -> &Setup {
        match &self.run {
            Ok(run) => run.setup(),
            Err(setup) => setup,
        }
    }

    /// Why it cannot start or go on.
    pub fn error(&self) -> Option<&RunError> {
        self.error.as_ref()
    }

    /// Goes on beyond an event that has ended the run. Only from the front.
    pub fn go_on(&mut self) {
        if let Ok(run) = &mut self.run
            && self.error.take_if(|error| error.is_end()).is_some()
        {
            run.go_on();
        }
    }

    /// Whether an event has ended the run.
    pub fn has_ended(&self) -> bool {
        self.error.as_ref().is_some_and(RunError::is_end)
    }

    /// What the run cannot promise.
    pub fn notices(&self) -> Vec<Notice> {
        self.run.as_ref().map(Run::notices).unwrap_or_default()
    }

    /// The recorded rows; absent when it could not start.
    pub fn history(&self) -> Option<&History> {
        self.run.as_ref().ok().map(Run::history)
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
            Err(setup) => &setup.parameters,
            Ok(run) if self.is_scrubbed() => run.history().parameters(self.row_ahead(run)),
            Ok(run) => run.parameters(),
        }
    }

    /// The state at a time behind the front, and the parameters that were in force there.
    pub fn state_at(&mut self, time: f64, out: &mut [f64]) -> Option<Vec<f64>> {
        let run = self.run.as_mut().ok()?;
        run.interpolate(time, out);
        let history = run.history();
        Some(history.parameters((history.row_at(time) + 1).min(history.len() - 1)).to_vec())
    }

    /// The state at a time behind the front.
    pub fn interpolate(&mut self, time: f64, out: &mut [f64]) {
        if let Ok(run) = &mut self.run {
            run.interpolate(time, out);
        }
    }

    /// Shows a moment between the start and the front.
    pub fn show(&mut self, time: f64) {
        self.time = if time.is_finite() { time.clamp(0.0, self.front) } else { self.front };
        if let Ok(run) = &mut self.run {
            run.interpolate(self.time, &mut self.state);
        }
    }

    /// Goes on to `to` with no more than about the work in `left`, from which what was done is taken, and shows that moment.
    /// Only from the front: see [`Course::resume`].
    pub fn proceed(&mut self, to: f64, left: &mut u64) -> Outcome {
        let mut outcome = Outcome::Reached;
        while self.is_behind(to) {
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
        let rows = self.rows_computed();
        if outcome == Outcome::Reached && !self.finish(to) {
            outcome = Outcome::Failed;
        }
        // What happens there can lie behind it by rounding.
        let reached = if self.rows_computed() > rows { to * (1.0 + ROUNDING) } else { to };
        self.front = self.front.max(reached.min(self.last_time()));
        self.show(self.front);
        outcome
    }

    /// Lets what happens at a time happen, where the last row stands there; false where that ends the run.
    fn finish(&mut self, time: f64) -> bool {
        let Ok(run) = &mut self.run else { return true };
        match run.finish(time) {
            Ok(()) => true,
            Err(error) => {
                self.error = Some(error);
                false
            }
        }
    }

    /// The grid time after the one shown; one so near that a step to it would not be seen does not count.
    pub fn next_grid_time(&self) -> f64 {
        self.grid_time((self.time / self.begun().step + SEEN).floor() + 1.0)
    }

    /// The grid time before the one shown, likewise; 0 at the start.
    pub fn previous_grid_time(&self) -> f64 {
        self.grid_time((self.time / self.begun().step - SEEN).ceil() - 1.0).max(0.0)
    }

    /// The row at which the run goes on from an earlier moment: the end of the step that the moment lies in.
    pub fn resume_row(&self) -> Option<usize> {
        let run = self.run.as_ref().ok()?;
        self.is_scrubbed().then(|| self.row_ahead(run))
    }

    /// Gives up the rows after the step that the moment shown lies in, so that the run goes on from there with the
    /// parameters then in force.
    pub fn resume(&mut self) {
        let Some(row) = self.resume_row() else { return };
        self.front = self.time;
        if let Ok(run) = &mut self.run {
            run.truncate(row);
            self.error = None;
        }
    }

    /// Changes the parameters from the next step on; at the very start, from the start on. None of them may decide an
    /// initial value.
    pub fn set_parameters(&mut self, model: &Model, parameters: Vec<f64>) {
        self.error = None;
        match &mut self.run {
            // This gives up what is only partly a step, with the rows in it.
            Ok(run) if run.history().len() > 1 => run.set_parameters(parameters),
            _ => *self = Self::start(model, Setup { parameters, ..self.begun().clone() }, self.overhead),
        }
    }

    /// Presses a button at the moment shown, which is the front. Presses after it are given up.
    pub fn press(&mut self, button: usize) {
        self.press_or_none(Some(button));
    }

    /// Gives up the presses after the moment shown, which is the front: something else happens there now.
    pub fn give_up_presses(&mut self) {
        if self.begun().presses.iter().any(|press| press.time > self.time) {
            self.press_or_none(None);
        }
    }

    fn press_or_none(&mut self, button: Option<usize>) {
        let Ok(run) = &mut self.run else { return };
        let parameters = run.parameters().to_vec();
        run.press(self.time, button);
        self.error = None;
        self.catch_up(&mut { PRESS });
        if let Ok(run) = &mut self.run {
            // Those that wait for the next step go on waiting.
            run.set_parameters(parameters);
        }
    }

    /// Computes what has been given up before the front, with about the work in `left`, and what is pressed there.
    fn catch_up(&mut self, left: &mut u64) {
        let front = self.front;
        while *left > 0 && self.is_behind(front) {
            match self.advance(left) {
                Some(Advance::Full) => break,
                Some(_) => {}
                // What was gone on with beyond its end is here, too.
                None if self.has_ended() && self.is_behind(front) => self.go_on(),
                None => break,
            }
        }
        self.front = front.min(self.last_time());
        self.show(self.front);
    }

    /// To the next row, or as far as the work in `left` allows; `None` when it fails.
    pub(super) fn advance(&mut self, left: &mut u64) -> Option<Advance> {
        let run = self.run.as_mut().ok()?;
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

    /// How many rows are computed, beyond the front, too.
    pub(super) fn rows_computed(&self) -> usize {
        self.history().map_or(0, History::len)
    }

    /// Whether the row at a time of the grid is computed.
    pub(super) fn has_computed(&self, time: f64) -> bool {
        self.last_time() >= time - NEAR * self.begun().step
    }

    /// Whether something up to a time is not computed yet, or a press has not acted.
    pub(super) fn is_behind(&self, time: f64) -> bool {
        self.last_time() < time || self.run.as_ref().is_ok_and(|run| run.has_press_before(time))
    }

    /// The time of the last row computed.
    pub(super) fn last_time(&self) -> f64 {
        self.history().and_then(|history| history.times().last().copied()).unwrap_or(0.0)
    }

    fn grid_time(&self, index: f64) -> f64 {
        index * self.begun().step
    }

    /// The last row at the first grid time at or after the time shown. Rows off the grid (events) are passed over: the
    /// rest of their step belongs to them.
    fn row_ahead(&self, run: &Run) -> usize {
        let times = run.history().times();
        let step = self.begun().step;
        let on_grid = |time: f64| (time / step - (time / step).round()).abs() < NEAR;
        let last = times.len().saturating_sub(1);
        let mut row = times.partition_point(|&time| time < self.time).min(last);
        while row + 1 < times.len() && (!on_grid(times[row]) || times[row + 1] == times[row]) {
            row += 1;
        }
        row
    }
}

/// The work that may be done when a button is pressed, in floating-point operations: less than half a second.
const PRESS: u64 = 50_000_000;
/// The work of recording a row and its values, in floating-point operations.
const ROW: u64 = 20;
const VALUE: u64 = 4;
/// A step to a grid time nearer than this part of a step would look as if the button did nothing.
const SEEN: f64 = 0.25;
/// Grid times closer than this part of a step are the same: quotients of times are rounded.
const NEAR: f64 = 1e-6;
