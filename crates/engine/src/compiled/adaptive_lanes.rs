//! Runs of the Dormand-Prince method side by side, each with its own time and step size.
//!
//! Compiled code makes rounds over all pairs of runs. In a round, both runs of a pair take the rows within their last steps, with the
//! checks of every interval between rows and ends of steps, and then attempt their next step, which each of them accepts or makes
//! shorter; masks say for which run a result holds. A run pauses at the row `limit`, or where a check fails, which is a *stop*; the other
//! run of the pair goes on. The code returns after the round in which a run has paused.
//!
//! Rows of paused runs are taken then. One that has stopped continues in the engine's stepper from the moment it has reached to its
//! next row, so that events and switches are located and act as in a single run. Then all that determines how it continues
//! (`Stepper::write_to`) is written back to its places, and it takes part in the next round.
//! Where runs stop at most of their rows, one that stops continues over several rows: it is faster alone.

use super::Compiled;
use super::lanes::{LanesLayout, Numbers};
use super::side_by_side::{LANES, SideBySide, Take};
use super::window_layout::WindowLayout;
use crate::methods::last_step::LastStep;
use crate::{Progress, ROUNDING, Reached, Record, Routine, RunError, Stepper, rows_until};
use std::rc::Rc;

/// Number of steps in compiled code that take no longer than one in the interpreter, with what is done with their rows.
const FASTER: u64 = 4;

/// Maximum number of rounds that are made at once.
const MOST_ROUNDS: u64 = 1024;

/// Maximum number of floating-point operations with which a run continues alone to its next row. One that needs more fails: it is made
/// again alone, for which the caller can divide the work.
const MOST_WORK: u64 = 1_000_000;

/// Number of stops for each run after which a run continues alone over several rows if runs stop at more than half of their rows.
const MANY_STOPS: u64 = 2;

/// Greatest number of these rows, and of floating-point operations after which there is no further one.
const ROWS_ALONE: u64 = 64;
const WORK_ALONE: u64 = 50_000;

/// Runs of one model in compiled code.
#[derive(Debug)]
pub(crate) struct AdaptiveLanes {
    /// Continues runs that have stopped.
    stepper: Stepper,
    readings: Routine,
    code: Rc<dyn Compiled>,
    layout: LanesLayout,
    window: WindowLayout,
    /// The times of the rows.
    grid: Grid,
    lanes: Vec<Lane>,
    /// Number of rows to which runs have continued alone.
    stops: u64,
    numbers: Numbers,
    values: Vec<f64>,
}

/// Times of the rows, SI units, and numbers of the last row that is taken and of the last one.
#[derive(Clone, Copy, Debug, Default)]
struct Grid {
    step: f64,
    until: f64,
    taken: u64,
    all: u64,
}

/// A run.
#[derive(Debug)]
struct Lane {
    parameters: Vec<f64>,
    initial: Vec<f64>,
    /// Index of the grid point up to which rows have been taken.
    index: u64,
    progress: LaneProgress,
    /// Time and state of the last row that was taken.
    last: (f64, Vec<f64>),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LaneProgress {
    Running,
    Ended,
    Failed,
}

impl Grid {
    /// Last time at which rows are taken.
    fn last(&self) -> f64 {
        self.until * (1.0 + ROUNDING)
    }
}

/// Reads and takes rows of a run that continues alone.
struct Rows<'a, 'b> {
    run: usize,
    /// Last time at which rows are taken, SI units.
    end: f64,
    readings: &'a mut Routine,
    values: &'a mut Vec<f64>,
    last: &'a mut (f64, Vec<f64>),
    take: Take<'b>,
}

impl Record for Rows<'_, '_> {
    fn row(&mut self, time: f64, state: &[f64], _jumped: bool) {
        if time > self.end {
            return;
        }
        self.last.0 = time;
        state.clone_into(&mut self.last.1);
        if !self.values.is_empty() {
            self.readings.evaluate(time, state, self.values);
            (self.take)(self.run, time, self.values);
        }
    }
}

impl AdaptiveLanes {
    /// Runs with rows `step` apart (SI units), whose steps `code` makes.
    pub fn new(
        stepper: Stepper,
        readings: Routine,
        code: Rc<dyn Compiled>,
        (layout, window): (LanesLayout, WindowLayout),
        step: f64,
    ) -> Self {
        let (numbers, values) = (Numbers::new(layout), vec![0.0; layout.values]);
        let grid = Grid { step, ..Grid::default() };
        Self { stepper, readings, code, layout, window, grid, lanes: Vec::new(), stops: 0, numbers, values }
    }

    /// Takes the rows of a run that the code has made. One that has paused goes on to its next row alone if it has stopped, or ends at
    /// its last row.
    fn settle(&mut self, run: usize, take: Take) {
        let reached = self.numbers.get(run, self.window.index()) as u64;
        self.take_rows(run, reached, take);
        let progress = match self.numbers.get(run, self.layout.stopped()) {
            0.0 => LaneProgress::Running,
            1.0 => self.go_on_alone(run, take),
            _ => LaneProgress::Failed,
        };
        self.lanes[run].progress = progress;
        self.settle_end(run, take);
    }

    /// Ends a run at its last row, or lets the rounds continue it.
    fn settle_end(&mut self, run: usize, take: Take) {
        let Lane { index, progress, .. } = self.lanes[run];
        if progress == LaneProgress::Running && index == self.grid.all {
            self.lanes[run].progress = self.finish(run, take);
        }
        self.set_limit(run);
    }

    /// Takes the rows up to that of index `reached`.
    fn take_rows(&mut self, run: usize, reached: u64, take: Take) {
        let (taken, step) = (self.grid.taken, self.grid.step);
        let first = std::mem::replace(&mut self.lanes[run].index, reached);
        for row in (first..reached.min(taken)).filter(|_| self.layout.values > 0) {
            self.numbers.copy(run, self.layout.row((row - first) as usize), &mut self.values);
            take(run, (row + 1) as f64 * step, &self.values);
        }
        if first < taken && reached == taken {
            self.lanes[run].last = (reached as f64 * step, self.states(run, self.window.present()));
        }
    }

    /// Lets the rounds continue a run up to a row for which there is room.
    fn set_limit(&mut self, run: usize) {
        let Lane { index, progress, .. } = self.lanes[run];
        let Grid { taken, all, .. } = self.grid;
        let goal = if index < taken { taken } else { all };
        let limit = match progress {
            LaneProgress::Running => goal.min(index + self.layout.rows as u64),
            LaneProgress::Ended | LaneProgress::Failed => 0,
        };
        self.numbers.set(run, self.layout.base(), &[index as f64, limit as f64]);
    }

    /// A number for each state from a place on.
    fn states(&self, run: usize, place: usize) -> Vec<f64> {
        let mut list = vec![0.0; self.window.states];
        self.numbers.copy(run, place, &mut list);
        list
    }

    /// True if a run has paused, or has many rows that are not taken.
    fn is_to_be_settled(&self, run: usize) -> bool {
        let number = |place: usize| self.numbers.get(run, place);
        let Lane { index, progress, .. } = self.lanes[run];
        let reached = number(self.window.index());
        let pauses = reached >= number(self.layout.limit()) || number(self.layout.stopped()) != 0.0;
        progress == LaneProgress::Running && (pauses || reached - index as f64 > 0.5 * self.layout.rows as f64)
    }

    /// True if the runs reach more than half of their rows alone.
    fn stops_too_often(&self) -> bool {
        let rows: u64 = self.lanes.iter().map(|lane| lane.index).sum();
        self.stops > MANY_STOPS * self.lanes.len() as u64 && 2 * self.stops > rows
    }

    /// Continues a run alone up to its next row, or over several rows if runs stop too often.
    fn go_on_alone(&mut self, run: usize, take: Take) -> LaneProgress {
        let most = if self.stops_too_often() { ROWS_ALONE.min(self.grid.all - self.lanes[run].index) } else { 1 };
        let (mut made, mut is_at_row) = (0, false);
        let outcome = self.alone(run, take, |stepper, rows| {
            let mut record = |time: f64, state: &[f64], jumped: bool| rows.row(time, state, jumped);
            let begun = stepper.work();
            while made == 0 || (is_at_row && made < most && stepper.work() - begun < WORK_ALONE) {
                is_at_row = stepper.advance_within(MOST_WORK, &mut record)? != Progress::Partial;
                made += 1;
            }
            Ok(())
        });
        self.stops += made;
        match outcome {
            Ok(()) if is_at_row => {
                self.lanes[run].index += made;
                self.write(run);
                LaneProgress::Running
            }
            Err(error) if error.is_end() => LaneProgress::Ended,
            _ => LaneProgress::Failed,
        }
    }

    /// Lets events act up to the end of a run that is at its last row.
    fn finish(&mut self, run: usize, take: Take) -> LaneProgress {
        let Grid { step, until, all, .. } = self.grid;
        if all as f64 * step <= self.grid.last() {
            // The only error is an event that ends the run.
            let _ = self.alone(run, take, |stepper, rows| stepper.finish(until, rows));
        }
        LaneProgress::Ended
    }

    /// Brings the stepper to the moment that a run has reached, and lets `act` continue it.
    fn alone(
        &mut self,
        run: usize,
        take: Take,
        act: impl FnOnce(&mut Stepper, &mut dyn Record) -> Result<(), RunError>,
    ) -> Result<(), RunError> {
        let window = self.window;
        let number = |place: usize| self.numbers.get(run, place);
        let record = window.record(0);
        let dense: [Vec<f64>; 5] = std::array::from_fn(|degree| self.states(run, record + window.dense(degree)));
        let [from, ..] = &dense;
        let last = LastStep {
            start: number(record),
            size: number(record + 1),
            end: number(record + 2),
            from: from.clone(),
            to: self.states(run, record + window.to()),
            proposed: number(record + 3),
            error: number(record + 4),
            peaks: self.states(run, record + window.peaks()),
            dense,
        };
        let armed: Vec<bool> = (0..window.events).map(|event| number(window.armed() + event) != 0.0).collect();
        let state = self.states(run, window.present());
        let steps = number(self.layout.since()) as usize;
        let reached = Reached { time: number(window.time()), state: &state, armed: &armed, last: Some(&last), steps };
        let Self { stepper, readings, values, grid, .. } = self;
        let Lane { parameters, initial, last, .. } = &mut self.lanes[run];
        stepper.begin(parameters.clone(), initial);
        stepper.continue_at(&reached);
        readings.prepare(parameters, initial);
        act(stepper, &mut Rows { run, end: grid.last(), readings, values, last, take })
    }

    /// Writes the moment that the stepper has reached to the places of a run.
    fn write(&mut self, run: usize) {
        let Self { stepper, numbers, .. } = self;
        stepper.write_to(&self.window, |place, values| numbers.set(run, place, values));
        numbers.set(run, self.layout.stopped(), &[0.0; 3]);
    }
}

impl SideBySide for AdaptiveLanes {
    fn begin(&mut self, runs: &[[Vec<f64>; 2]], until: f64, take: Take) {
        let [taken, all] = rows_until(self.grid.step, until);
        self.grid = Grid { until, taken, all, ..self.grid };
        self.lanes.clear();
        self.stops = 0;
        (0..LANES).for_each(|run| self.numbers.set(run, self.layout.base(), &[0.0; 2]));
        for (run, [parameters, initial]) in runs.iter().take(LANES).enumerate() {
            self.stepper.begin(parameters.clone(), initial);
            self.readings.prepare(parameters, initial);
            self.numbers.set(run, self.layout.readings(), self.readings.registers());
            self.write(run);
            if self.layout.values > 0 {
                self.readings.evaluate(0.0, initial, &mut self.values);
                take(run, 0.0, &self.values);
            }
            let finite = parameters.iter().chain(initial).all(|value| value.is_finite());
            let progress = if finite { LaneProgress::Running } else { LaneProgress::Failed };
            let (parameters, initial) = (parameters.clone(), initial.clone());
            self.lanes.push(Lane { last: (0.0, initial.clone()), parameters, initial, index: 0, progress });
            self.settle_end(run, take);
        }
    }

    fn advance(&mut self, left: &mut u64, take: Take) -> bool {
        let work = (LANES as u64 * self.stepper.work_of_attempt() / FASTER).max(1);
        while self.lanes.iter().any(|lane| lane.progress == LaneProgress::Running) {
            if *left == 0 {
                return false;
            }
            let rounds = (*left / work).clamp(1, MOST_ROUNDS);
            let made = self.numbers.run(&*self.code, rounds as u32);
            *left = left.saturating_sub(u64::from(made.max(1)) * work);
            let before = self.stepper.work();
            for run in 0..self.lanes.len() {
                if self.is_to_be_settled(run) {
                    self.settle(run, take);
                }
            }
            *left = left.saturating_sub(self.stepper.work() - before);
        }
        true
    }

    fn end(&self, run: usize) -> Option<(f64, Vec<f64>)> {
        let Lane { progress, last, .. } = &self.lanes[run];
        (*progress == LaneProgress::Ended).then(|| last.clone())
    }
}
