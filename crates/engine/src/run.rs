//! A run: a stepper with its recorded history.

use crate::methods::cubic::Cubic;
use crate::methods::stability::Stability;
use crate::methods::stepper::grid_index;
use crate::record::checkpoints::Checkpoints;
use crate::record::ranges::Ranges;
use crate::{
    Compiled, Compiler, History, Interpreted, Listing, Notice, NoticeKind, Press, Progress, Readings, RunError, Setup,
    Stepper,
};
use program::{Model, NodeId};
use std::rc::Rc;

/// Maximum size of a history in bytes (64 MiB); a run that reaches it pauses.
pub const CAPACITY: usize = 64 << 20;

/// Result of [`Run::advance`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Advance {
    /// The next grid point is reached: one new row.
    Step,
    /// The next grid point is reached, with one or more events on the way; each event adds two rows.
    Event,
    /// No progress: the history is full.
    Full,
    /// The allowed work is used up before the next row ([`Run::advance_within`]).
    Partial,
}

/// A stepper with its recorded history.
#[derive(Clone, Debug)]
pub struct Run {
    setup: Setup,
    stepper: Stepper,
    history: History,
    rates: Readings,
    /// Working storage: the states at both ends of an interval.
    ends: [Vec<f64>; 2],
    /// Index of the last row that is a grid point.
    last_on_grid: usize,
    ranges: Ranges,
    /// Stability check, only for fixed-step methods with continuous time.
    stability: Option<Stability>,
    /// Checkpoints, only for adaptive methods.
    checkpoints: Option<Checkpoints>,
    /// True if the independent variable counts (discrete time): the state is then constant between two counts.
    counts: bool,
}

impl Run {
    /// Checks the setup, computes the initial state and records it as the first row.
    ///
    /// # Errors
    /// A step or tolerance out of range, an initial state that is not finite, or a method that cannot integrate the model.
    pub fn start(model: &Model, setup: Setup) -> Result<Self, RunError> {
        let setup = setup.fitting(model);
        let drawn = model.with_drawings(&setup.drawings);
        let model = drawn.as_ref().unwrap_or(model);
        let mut stepper = Stepper::new(model, &setup)?;
        let history = History::new(stepper.initial().to_vec(), setup.parameters.clone());
        let rates: Vec<NodeId> = model.states.iter().map(|state| state.derivative).collect();
        let state = stepper.state().to_vec();
        let checkpoints = setup.method.adaptive().then(|| Checkpoints::new(&stepper));
        let rates = Readings::new(model, &rates);
        let mut ranges = Ranges::new(model);
        ranges.look(&setup.parameters, stepper.initial(), stepper.time(), &state);
        let counts = model.independent.counts;
        let mut stability = if counts { None } else { Stability::new(setup.method, state.len()) };
        stability.iter_mut().for_each(|stability| stepper.look(stability));
        let ends = [state.clone(), state];
        Ok(Self { rates, setup, stepper, history, ends, last_on_grid: 0, ranges, stability, checkpoints, counts })
    }

    /// Advances to the next grid point t_n = n h.
    ///
    /// # Errors
    /// A state that is no longer finite, too many events within one step, or a step size that became too small. The rows
    /// recorded before are kept.
    pub fn advance(&mut self) -> Result<Advance, RunError> {
        loop {
            match self.advance_within(u64::MAX)? {
                Advance::Partial => {}
                other => return Ok(other),
            }
        }
    }

    /// [`Run::advance`] with at most about `work` floating-point operations. If they are not enough, returns
    /// [`Advance::Partial`]; the next call continues. The bits of the rows do not depend on `work`.
    ///
    /// # Errors
    /// As [`Run::advance`].
    pub fn advance_within(&mut self, work: u64) -> Result<Advance, RunError> {
        if self.history.bytes() >= CAPACITY {
            return Ok(Advance::Full);
        }
        let Progress::Row { events } = self.stepper.advance_within(work, &mut self.history)? else {
            return Ok(Advance::Partial);
        };
        self.last_on_grid = self.history.len() - 1;
        let (parameters, initial) = (self.history.next_parameters(), self.history.initial());
        self.ranges.look(parameters, initial, self.stepper.time(), self.stepper.state());
        if let Some(stability) = &mut self.stability {
            self.stepper.look(stability);
        }
        if let Some(checkpoints) = &mut self.checkpoints {
            checkpoints.note(&self.stepper, self.last_on_grid);
        }
        Ok(if events == 0 { Advance::Step } else { Advance::Event })
    }

    /// Processes the events and presses up to `end` (SI units) if the next row lies beyond `end`. This may add rows; a
    /// longer run has the same rows.
    ///
    /// # Errors
    /// An event that ends the run.
    pub fn finish(&mut self, end: f64) -> Result<(), RunError> {
        let outcome = self.stepper.finish(end, &mut self.history);
        self.last_on_grid = self.history.len() - 1;
        outcome
    }

    /// The steps of the run for a compiler ([`Stepper::listing`]).
    ///
    /// # Errors
    /// The reason why they can only be interpreted.
    pub fn listing(&self) -> Result<Listing, Interpreted> {
        self.stepper.listing()
    }

    /// Makes all later steps with compiled code ([`Stepper::use_compiled`]).
    pub fn use_compiled(&mut self, code: Rc<dyn Compiled>) {
        self.stepper.use_compiled(code);
    }

    /// Makes all later steps with the code of `compiler`, if there is any.
    pub fn compile(&mut self, compiler: &dyn Compiler) {
        if let Some(code) = self.listing().ok().and_then(|listing| compiler.compile(listing)) {
            self.use_compiled(code);
        }
    }

    /// Approximate number of floating-point operations so far.
    pub fn work(&self) -> u64 {
        self.stepper.work()
    }

    /// The recorded rows.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// The setup of the run, with all presses so far.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// The parameters in force for the next step, one value per parameter, SI units.
    pub fn parameters(&self) -> &[f64] {
        self.history.next_parameters()
    }

    /// The state at the start, one value per state, SI units.
    pub fn initial(&self) -> &[f64] {
        self.history.initial()
    }

    /// Current value of the independent variable, SI units: that of the last row, or later after [`Advance::Partial`].
    pub fn time(&self) -> f64 {
        self.stepper.time()
    }

    /// The state at [`Run::time`], one value per state, SI units.
    pub fn state(&self) -> &[f64] {
        self.stepper.state()
    }

    /// Continues after an event that ended the run ([`RunError::is_end`]).
    pub fn go_on(&mut self) {
        self.stepper.go_on();
    }

    /// The limits of accuracy met so far.
    pub fn notices(&self) -> Vec<Notice> {
        let mut notices = self.stepper.notices();
        notices.extend(self.ranges.notice());
        let exceeded = self.stability.as_ref().and_then(Stability::exceeded);
        notices.extend(exceeded.map(|time| Notice { kind: NoticeKind::StepTooLong, time }));
        notices
    }

    /// Changes the parameters from the next step on (one value per parameter, SI units); the state is kept. A partly made
    /// step is discarded. A change that is undone before the next step has no effect on the bits of the run.
    pub fn set_parameters(&mut self, parameters: Vec<f64>) {
        if parameters.len() != self.setup.parameters.len() || parameters == self.parameters() {
            return;
        }
        if self.stepper.is_between_rows() {
            self.go_back_to(self.last_on_grid);
        }
        let last = self.history.len() - 1;
        if self.history.parameters(last) == parameters {
            // An adaptive method has restarted with the other parameters and must go back.
            self.truncate(last);
        } else {
            self.history.push_parameters(parameters.clone());
            self.stepper.set_parameters(parameters);
            if let Some(stability) = &mut self.stability {
                stability.look_soon();
            }
        }
    }

    /// Presses a button at `time` (SI units). If the run has passed that time, later rows and presses are dropped, and the
    /// run returns to the last grid point before. `None` only drops later presses.
    pub fn press(&mut self, time: f64, button: Option<usize>) {
        let time = if self.counts { time.floor() } else { time };
        let presses = &mut self.setup.presses;
        let known = presses.len();
        presses.retain(|press| press.time <= time);
        if presses.len() == known && button.is_none() {
            return;
        }
        presses.extend(button.map(|button| Press { time, button }));
        self.stepper.set_presses(presses);
        let before = grid_index(time, self.setup.step) as f64 * self.setup.step;
        let row = self.history.times().partition_point(|&at| at < before);
        if row + 1 < self.history.len() || (row < self.history.len() && self.stepper.is_between_rows()) {
            self.go_back_to(row);
        }
    }

    /// True if a press at or before `time` (SI units) has not acted yet.
    pub fn has_press_before(&self, time: f64) -> bool {
        self.stepper.next_press().is_some_and(|next| next <= time)
    }

    /// Drops the rows after `row` and continues from there, with the parameters in force there. If several rows have the
    /// same time, the last of them is kept, so that its events do not act again. From a row on the grid the run repeats the
    /// same bits, also with adaptive methods.
    pub fn truncate(&mut self, row: usize) {
        let history = &self.history;
        let mut row = row.min(history.len() - 1);
        while row + 1 < history.len() && history.time(row + 1) == history.time(row) {
            row += 1;
        }
        self.go_back_to(row);
    }

    /// [`Run::truncate`] to exactly this row: events at the time of the row act again.
    fn go_back_to(&mut self, row: usize) {
        let history = &mut self.history;
        self.ranges.go_back_to(history.time(row));
        if let Some(stability) = &mut self.stability {
            stability.go_back_to(history.time(row));
        }
        history.truncate(row);
        self.last_on_grid = self.last_on_grid.min(row);
        if !self.repeat_to(row) {
            let history = &self.history;
            let [state, _] = &mut self.ends;
            history.state(row, state);
            let parameters = history.next_parameters().to_vec();
            self.stepper.resume(history.time(row), state, parameters, history.after_jump(row));
        }
    }

    /// Repeats the steps of an adaptive method from the last checkpoint up to `row`. Returns false if no step ends at that
    /// row, which is then not on the grid.
    fn repeat_to(&mut self, row: usize) -> bool {
        let Some(checkpoints) = &mut self.checkpoints else { return false };
        let Some((mut at, moment)) = checkpoints.back_to(row, self.stepper.work()) else { return false };
        self.stepper.go_on_from(moment);
        while at < row {
            if let Some(parameters) = self.history.parameters_from(at + 1) {
                self.stepper.set_parameters(parameters.to_vec());
            }
            if self.stepper.advance(|_, _, _| at += 1).is_err() {
                return false;
            }
        }
        at == row
    }

    /// Drops all rows but the last, for example after they are written to a file; the run continues unchanged.
    pub fn forget(&mut self) {
        let dropped = self.history.len() - 1;
        self.history.forget();
        self.last_on_grid = self.last_on_grid.saturating_sub(dropped);
        if let Some(checkpoints) = &mut self.checkpoints {
            checkpoints.forget(dropped);
        }
    }

    /// State at any time up to the last row, one value per state, SI units. Cubic Hermite interpolation between two rows;
    /// the first or last row outside. With a counting independent variable, the last row at or before `time`.
    pub fn interpolate(&mut self, time: f64, out: &mut [f64]) {
        let history = &self.history;
        let row = history.row_at(time);
        history.state(row, out);
        let next = row + 1;
        if self.counts
            || next >= history.len()
            || history.segment(next) != history.segment(row)
            || time <= history.time(row)
        {
            return;
        }
        let [from, to] = &mut self.ends;
        history.state(row, from);
        history.state(next, to);
        let (start, end) = (history.time(row), history.time(next));
        let (size, part) = (end - start, (time - start) / (end - start));
        let (parameters, initial) = (history.parameters(next), history.initial());
        out.copy_from_slice(self.rates.at(parameters, initial, start, from));
        let end_rates = self.rates.at(parameters, initial, end, to);
        for (k, value) in out.iter_mut().enumerate() {
            *value = between(part, [from[k], to[k]], [size * *value, size * end_rates[k]], history.scale(k, next));
        }
    }
}

/// Cubic Hermite interpolation between two rows with the values `ends` and the slopes `slopes` (per unit of `part`) at
/// `part`, 0 to 1. If a slope exceeds ten times `scale`, the greatest magnitude of the state so far, it belongs to a change
/// too fast for the rows; the interpolation is then linear.
fn between(part: f64, ends: [f64; 2], slopes: [f64; 2], scale: f64) -> f64 {
    let [leaving, arriving] = slopes.map(f64::abs);
    if leaving.max(arriving) > 10.0 * scale {
        let [from, to] = ends;
        return from + part * (to - from);
    }
    Cubic::new(ends, slopes).at(part)
}
