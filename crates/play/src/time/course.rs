//! A run as it is played: the computed rows, the time reached, and the moment shown.
//!
//! The run is computed slightly ahead: the time shown lies inside the last step or at its end. The *front* is the
//! greatest time reached. Moments up to the front can be shown again; rows beyond it are not shown yet.

use crate::motion::Motion;
use engine::{Advance, CAPACITY, Compiler, History, Notice, ROUNDING, Run, RunError, Setup};

/// Result of [`Course::proceed`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// The target time was reached.
    Reached,
    /// The work limit was reached; the remaining time to the target (SI).
    Behind(f64),
    /// The memory limit was reached.
    Full,
    /// The run failed or ended.
    Failed,
}

/// One run, and the moment of it that is shown.
#[derive(Debug)]
pub struct Course {
    /// The run, whose history records all changes of parameters; or, if it could not start, its settings.
    run: Result<Run, Setup>,
    error: Option<RunError>,
    time: f64,
    front: f64,
    state: Vec<f64>,
    /// Memory that the plots need per row, in bytes.
    overhead: usize,
}

impl Course {
    /// Sets the memory that the plots need per row, in bytes.
    pub fn set_overhead(&mut self, overhead: usize) {
        self.overhead = overhead;
    }

    /// Starts a run; a failure is available as [`Course::error`].
    pub fn start(motion: Motion, setup: Setup, overhead: usize) -> Self {
        let (run, error) = match motion.start(setup.clone()) {
            Ok(run) => (Ok(run), None),
            Err(error) => (Err(setup), Some(error)),
        };
        let state = vec![f64::NAN; motion.states()];
        let mut course = Self { run, error, time: 0.0, front: 0.0, state, overhead };
        course.show(0.0);
        course
    }

    /// Makes the later steps of the run with compiled code. Its bits stay the same.
    pub fn compile(&mut self, compiler: &dyn Compiler) {
        if let Ok(run) = &mut self.run {
            run.compile(compiler);
        }
    }

    /// Settings with which the run was started.
    pub fn begun(&self) -> &Setup {
        match &self.run {
            Ok(run) => run.setup(),
            Err(setup) => setup,
        }
    }

    /// True if the run started from a state set by hand instead of the model's initial values.
    pub fn is_started_by_hand(&self) -> bool {
        self.begun().start.is_some()
    }

    /// Reason why it cannot start or continue.
    pub fn error(&self) -> Option<&RunError> {
        self.error.as_ref()
    }

    /// Continues beyond an event that ended the run. Call only at the front.
    pub fn go_on(&mut self) {
        if let Ok(run) = &mut self.run
            && self.error.take_if(|error| error.is_end()).is_some()
        {
            run.go_on();
        }
    }

    /// True if an event has ended the run.
    pub fn has_ended(&self) -> bool {
        self.error.as_ref().is_some_and(RunError::is_end)
    }

    /// Warnings of the run.
    pub fn notices(&self) -> Vec<Notice> {
        self.run.as_ref().map(Run::notices).unwrap_or_default()
    }

    /// Recorded rows; `None` if the run could not start.
    pub fn history(&self) -> Option<&History> {
        self.run.as_ref().ok().map(Run::history)
    }

    /// Number of rows up to the front.
    pub fn rows(&self) -> usize {
        self.history().map_or(0, |history| history.row_at(self.front) + 1)
    }

    /// Number of rows up to the moment shown.
    pub fn rows_until_shown(&self) -> usize {
        self.history().map_or(0, |history| history.row_at(self.time) + 1)
    }

    /// Time shown (SI).
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Greatest time reached (SI).
    pub fn front(&self) -> f64 {
        self.front
    }

    /// State at the time shown, SI, one value per state.
    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// Initial state, SI: `y(0)` and so on. NaN if the run could not start.
    pub fn initial(&self) -> &[f64] {
        self.run.as_ref().map_or(&self.state, Run::initial)
    }

    /// True if a moment before the front is shown.
    pub fn is_scrubbed(&self) -> bool {
        self.time < self.front
    }

    /// Parameters (SI) in force at the time shown: those of the step that contains it; at the front, those of the next
    /// step.
    pub fn parameters(&self) -> &[f64] {
        match &self.run {
            Err(setup) => &setup.parameters,
            Ok(run) if self.is_scrubbed() => run.history().parameters(self.row_ahead(run)),
            Ok(run) => run.parameters(),
        }
    }

    /// Writes the state (SI) at a time (SI) up to the front into `out`. Returns the parameters (SI) in force there;
    /// `None` if the run could not start.
    pub fn state_at(&mut self, time: f64, out: &mut [f64]) -> Option<Vec<f64>> {
        let run = self.run.as_mut().ok()?;
        run.interpolate(time, out);
        let history = run.history();
        Some(history.parameters((history.row_at(time) + 1).min(history.len() - 1)).to_vec())
    }

    /// Writes the state (SI) at a time (SI) up to the front into `out`.
    pub fn interpolate(&mut self, time: f64, out: &mut [f64]) {
        if let Ok(run) = &mut self.run {
            run.interpolate(time, out);
        }
    }

    /// Shows a moment (SI) between the start and the front.
    pub fn show(&mut self, time: f64) {
        self.time = if time.is_finite() { time.clamp(0.0, self.front) } else { self.front };
        if let Ok(run) = &mut self.run {
            run.interpolate(self.time, &mut self.state);
        }
    }

    /// Continues to the time `to` (SI) and shows that moment. `left` is the remaining work in floating-point operations
    /// and is reduced by the work done. Call only at the front: see [`Course::resume`].
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
        // Rounding can place the rows of these events slightly after `to`.
        let reached = if self.rows_computed() > rows { to * (1.0 + ROUNDING) } else { to };
        self.front = self.front.max(reached.min(self.last_time()));
        self.show(self.front);
        outcome
    }

    /// Performs the events at a time (SI) if the last row lies there. Returns false if one ends the run.
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

    /// Next grid time (SI) after the one shown. A grid time too close to be noticed as a step is skipped.
    pub fn next_grid_time(&self) -> f64 {
        self.grid_time((self.time / self.begun().step + SEEN).floor() + 1.0)
    }

    /// Previous grid time (SI) before the one shown, likewise; 0 at the start.
    pub fn previous_grid_time(&self) -> f64 {
        self.grid_time((self.time / self.begun().step - SEEN).ceil() - 1.0).max(0.0)
    }

    /// Row from which the run continues after an earlier moment: the end of the step that contains the moment. `None`
    /// at the front.
    pub fn resume_row(&self) -> Option<usize> {
        let run = self.run.as_ref().ok()?;
        self.is_scrubbed().then(|| self.row_ahead(run))
    }

    /// Discards the rows after the step that contains the moment shown. The run continues from there with the
    /// parameters then in force.
    pub fn resume(&mut self) {
        let Some(row) = self.resume_row() else { return };
        self.front = self.time;
        if let Ok(run) = &mut self.run {
            run.truncate(row);
            self.error = None;
        }
    }

    /// Changes the parameters (SI) from the next step on, or from the start if there is only one row. None of them may
    /// determine an initial value.
    pub fn set_parameters(&mut self, motion: Motion, parameters: Vec<f64>) {
        self.error = None;
        match &mut self.run {
            // Discards an incomplete step with the rows in it.
            Ok(run) if run.history().len() > 1 => run.set_parameters(parameters),
            _ => *self = Self::start(motion, Setup { parameters, ..self.begun().clone() }, self.overhead),
        }
    }

    /// Presses a button at the moment shown, which must be the front. Later presses are discarded.
    pub fn press(&mut self, button: usize) {
        self.press_or_none(Some(button));
    }

    /// Discards the presses after the moment shown, which must be the front.
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
            // Changes that wait for the next step stay pending.
            run.set_parameters(parameters);
        }
    }

    /// Recomputes the rows discarded before the front, with the presses there. `left` is the remaining work in
    /// floating-point operations.
    fn catch_up(&mut self, left: &mut u64) {
        let front = self.front;
        while *left > 0 && self.is_behind(front) {
            match self.advance(left) {
                Some(Advance::Full) => break,
                Some(_) => {}
                // The run had been continued beyond its end.
                None if self.has_ended() && self.is_behind(front) => self.go_on(),
                None => break,
            }
        }
        self.front = front.min(self.last_time());
        self.show(self.front);
    }

    /// Computes the next row, or as much of it as the work in `left` allows; `None` if the run fails or ends.
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

    /// Number of computed rows, including those beyond the front.
    pub(super) fn rows_computed(&self) -> usize {
        self.history().map_or(0, History::len)
    }

    /// True if the row at a grid time (SI) is computed.
    pub(super) fn has_computed(&self, time: f64) -> bool {
        self.last_time() >= time - NEAR * self.begun().step
    }

    /// True if the run is not computed up to a time (SI), or a press before it has not taken effect.
    pub(super) fn is_behind(&self, time: f64) -> bool {
        self.last_time() < time || self.run.as_ref().is_ok_and(|run| run.has_press_before(time))
    }

    /// Time (SI) of the last computed row.
    pub(super) fn last_time(&self) -> f64 {
        self.history().and_then(|history| history.times().last().copied()).unwrap_or(0.0)
    }

    fn grid_time(&self, index: f64) -> f64 {
        index * self.begun().step
    }

    /// Last row at the first grid time at or after the time shown. Rows off the grid (events) are skipped: they belong
    /// to the rest of their step.
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

/// Maximum work for pressing a button, in floating-point operations: less than half a second.
const PRESS: u64 = 50_000_000;
/// Work for recording a row and each of its values, in floating-point operations.
const ROW: u64 = 20;
const VALUE: u64 = 4;
/// A step to a grid time closer than this fraction of a step would be unnoticeable.
const SEEN: f64 = 0.25;
/// Grid times closer than this fraction of a step are equal, because quotients of times are rounded.
const NEAR: f64 = 1e-6;
