//! Advance from one grid point to the next: steps of the method and events on the way.

use super::{RowWork, Solver, Stepper};
use crate::events::crossing::Crossing;
use crate::methods::adaptive::Stalled;
use crate::{AfterJump, Cause, Method, Record, RunError};

/// Result of [`Stepper::advance_within`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// The next grid point is reached.
    Row {
        /// Number of events on the way.
        events: usize,
    },
    /// The allowed work is used up before the next grid point.
    Partial,
}

/// Early end of a step at an event or switch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Early {
    /// Last moment before it.
    before: f64,
    /// First moment after it.
    beyond: f64,
    /// Shortest time in which the state changes there.
    resolution: f64,
}

impl Early {
    /// Early end at a crossing (relative to `start`) in a step of `size` from `start` to `end`.
    pub fn new(crossing: Crossing, start: f64, size: f64, end: f64) -> Self {
        // With rounding, `start + size` may differ from `end`.
        let beyond = if crossing.high == size { end } else { (start + crossing.high).min(end) };
        Self { before: start + crossing.low, beyond, resolution: crossing.high - crossing.low }
    }
}

impl Stepper {
    /// Maximum number of events within a hundredth of a step; more of them stop the run, because time would hardly advance.
    pub const BURST_LIMIT: usize = 1000;
    /// Maximum number of switches of the equations within one step of the grid; more of them stop the run. The switches of a
    /// relay that acts on a second derivative grow denser by a constant factor from step to step.
    pub const SWITCH_LIMIT: usize = 10_000;
    /// Number of switches in a step of the grid from which on a motion to and fro about a corner is expected.
    const TO_AND_FRO: usize = 16;
    /// Fraction of a step within which events are counted.
    const BURST_SPAN: f64 = 1e-2;
    /// Maximum number of steps of an adaptive method between two grid points; more of them stop the run.
    pub const STEP_LIMIT: usize = 100_000;

    /// Advances to the next grid point. `record` receives every row on the way: time, state, and true if the state jumped
    /// there from the row before. Returns the number of events.
    ///
    /// # Errors
    /// A state that is no longer finite, too many events or steps, or a step size that became too small. The state is then
    /// the last finite one, and every further call returns the same error until parameters change.
    pub fn advance(&mut self, mut record: impl FnMut(f64, &[f64], bool)) -> Result<usize, RunError> {
        loop {
            if let Progress::Row { events } = self.advance_within(u64::MAX, &mut record)? {
                return Ok(events);
            }
        }
    }

    /// [`Stepper::advance`] with at most about `work` floating-point operations ([`Stepper::work`]), but at least one step.
    /// If they are not enough, the next call continues. The bits of the rows do not depend on the division of the work.
    ///
    /// # Errors
    /// As [`Stepper::advance`].
    pub fn advance_within(&mut self, work: u64, record: &mut impl Record) -> Result<Progress, RunError> {
        let target = (self.index + 1) as f64 * self.step;
        if self.takes_known_row(target) {
            record.row(target, &self.state, false);
            return Ok(Progress::Row { events: 0 });
        }
        if self.takes_row(target, work) {
            record.row(target, &self.state, false);
            return Ok(Progress::Row { events: std::mem::take(&mut self.row).events });
        }
        let arrived = self.try_until(target, work, record)?;
        if !arrived {
            return Ok(Progress::Partial);
        }
        self.index += 1;
        self.on_grid = self.time == target;
        Ok(Progress::Row { events: std::mem::take(&mut self.row).events })
    }

    /// True if the stepper is between two grid points after [`Progress::Partial`]; false after an error.
    pub fn is_between_rows(&self) -> bool {
        self.row.steps > 0 && self.stopped.is_none()
    }

    /// Continues after an event that ended the run.
    pub fn go_on(&mut self) {
        self.stopped.take_if(|error| error.is_end());
    }

    /// Advances to any later time (SI units), which need not be on the grid, without a record. Events that end a run act
    /// but do not end it. Returns the number of events.
    ///
    /// # Errors
    /// As [`Stepper::advance`].
    pub fn advance_to(&mut self, time: f64) -> Result<usize, RunError> {
        self.row = RowWork::default();
        self.catch_up();
        if self.moves_within_step(time) {
            self.find_grid();
            return Ok(0);
        }
        self.on_grid = false;
        self.heeds_ends = false;
        let result = self.try_until(time, u64::MAX, &mut |_: f64, _: &[f64], _: bool| {});
        self.heeds_ends = true;
        self.find_grid();
        result.map(|_| std::mem::take(&mut self.row).events)
    }

    /// [`Stepper::advance_until`]; after an error every further call returns the same error.
    fn try_until(&mut self, target: f64, work: u64, record: &mut dyn Record) -> Result<bool, RunError> {
        if let Some(error) = &self.stopped {
            return Err(error.clone());
        }
        self.catch_up();
        let result = self.advance_until(target, work, record);
        if let Err(error) = &result {
            self.stopped = Some(error.clone());
        }
        result
    }

    /// Advances towards `target`. True if it is reached.
    fn advance_until(&mut self, target: f64, work: u64, record: &mut dyn Record) -> Result<bool, RunError> {
        if self.counts {
            return self.count_until(target, work, record);
        }
        let begun = self.work();
        while self.time < target {
            self.advance_once(target, record)?;
            if self.time < target && self.work() - begun >= work {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Lets a press act, or makes one step towards the moment `target` (SI), which ends early at an event, a switch or the next press.
    pub(super) fn advance_once(&mut self, target: f64, record: &mut dyn Record) -> Result<(), RunError> {
        if self.press(record)? {
            return Ok(());
        }
        self.row.steps += 1;
        let until = self.presses.next().map_or(target, |next| next.min(target));
        self.on_grid &= until == target;
        let early = match self.solver {
            Solver::Fixed(_) => self.fixed(until)?,
            Solver::Adaptive(_) if self.row.steps > Self::STEP_LIMIT => {
                return Err(self.error(Cause::TooManySteps(Self::STEP_LIMIT, self.method)));
            }
            Solver::Adaptive(_) => self.adaptive(until)?,
        };
        match early {
            Some(early) if self.surfaces.events.first_due().is_some() => self.jump(early, record)?,
            Some(early) => self.switch(early, record)?,
            None if self.time == until => record.row(self.time, &self.state, false),
            None => {}
        }
        Ok(())
    }

    /// Makes one step to `target`, or to an earlier event or switch, or a shorter one where the equations have no value.
    // Not inlined: `advance` is compiled with its caller, which is optimized for size on the page.
    fn fixed(&mut self, target: f64) -> Result<Option<Early>, RunError> {
        let expected = self.surfaces.timetable.next(self.time, target, &self.state);
        let end = expected.map_or(target, |expected| expected.high);
        let size = if self.on_grid && expected.is_none() { self.step } else { end - self.time };
        if self.try_fixed(size)
            && let Some(early) = self.arrive(end, size, expected)
        {
            return Ok(early);
        }
        self.shortened(size, end)
    }

    /// Computes the next state by a step of a fixed-step method of `size`, SI units. True if it is finite.
    pub(super) fn try_fixed(&mut self, size: f64) -> bool {
        let Solver::Fixed(method) = &mut self.solver else { return false };
        method.step(&mut self.equations, self.time, size, &self.state, &mut self.next);
        self.next.iter().all(|value| value.is_finite())
    }

    /// Moves to the next state, at `end` after a step of `size` (SI) of a fixed-step method, or to an earlier event or switch. Returns
    /// `None` and stays if a step to that event or switch has no value, although one of `size` has.
    pub(super) fn arrive(&mut self, end: f64, size: f64, expected: Option<Crossing>) -> Option<Option<Early>> {
        let Solver::Fixed(method) = &mut self.solver else { return Some(None) };
        let (equations, time) = (&mut self.equations, self.time);
        if !self.surfaces.is_empty() {
            let (from, to) = ((time, self.state.as_slice()), (end, self.next.as_slice()));
            let mut state_at = |since: f64, out: &mut [f64]| method.repeat(equations, time, since, from.1, out);
            let (low, happened) = self.surfaces.look_between(time, None, from, to, &mut state_at);
            if happened.is_some() || self.surfaces.crossed(end, &self.next) {
                let expected = expected.filter(|_| happened.is_none());
                let (high, end) = happened.map_or((size, end), |since| (since, time + since));
                let crossing = self.surfaces.locate(time, (low, high), expected, state_at);
                return self.surfaces.is_finite().then(|| Some(Early::new(crossing, time, high, end)));
            }
            self.surfaces.events.pass();
        }
        std::mem::swap(&mut self.state, &mut self.next);
        self.time = end;
        self.on_grid = false;
        Some(None)
    }

    /// Advances to `target` or to the end of the step of the method, whichever is first, or to an earlier event or switch.
    fn adaptive(&mut self, target: f64) -> Result<Option<Early>, RunError> {
        self.begin_steps();
        if let Some(early) = self.leave_standstill(target) {
            return Ok(early);
        }
        let Solver::Adaptive(method) = &mut self.solver else {
            return Ok(None);
        };
        let equations = &mut self.equations;
        if method.end() <= self.time
            && let Err(stalled) = method.extend(equations, target)
        {
            let finite = stalled == Stalled::TooSmall;
            let cause = if finite { Cause::StepTooSmall } else { self.not_finite() };
            return self.cross(f64::EPSILON * target, target, !finite).ok_or_else(|| self.error(cause));
        }
        let until = target.min(method.end());
        let expected = self.surfaces.timetable.next(self.time, until, &self.state);
        let until = expected.map_or(until, |expected| expected.high);
        // A grid row must not depend on whether a button is pressed there.
        let on_grid = until == (self.index + 1) as f64 * self.step;
        if until == method.end() {
            self.next.copy_from_slice(method.end_state());
        } else if self.presses.next() == Some(until) && !on_grid {
            method.shorter(equations, until - method.start(), &mut self.next);
        } else {
            method.dense(until - method.start(), &mut self.next);
        }
        if !self.surfaces.is_empty() {
            let start = method.start();
            let (from, to) = ((self.time, self.state.as_slice()), (until, self.next.as_slice()));
            let dense = |time: f64, out: &mut [f64]| method.dense(time - start, out);
            let state_at = |since: f64, out: &mut [f64]| method.dense(since, out);
            let (low, happened) = self.surfaces.look_between(start, Some(&dense), from, to, state_at);
            if happened.is_some() || self.surfaces.crossed(until, &self.next) {
                let (high, until) = happened.map_or((until - start, until), |since| (since, start + since));
                let expected = expected.filter(|_| happened.is_none());
                let crossing = method.locate(equations, &mut self.surfaces, (low, high), expected);
                return Ok(Some(Early::new(crossing, start, high, until)));
            }
            self.surfaces.events.pass();
        }
        std::mem::swap(&mut self.state, &mut self.next);
        self.time = until;
        Ok(None)
    }

    /// An error at the current time.
    pub(super) fn error(&self, cause: Cause) -> RunError {
        RunError { cause, time: self.time }
    }

    /// Lets the next press act if it is due now. Its changes add a row. True if a press acted.
    pub(super) fn press(&mut self, record: &mut dyn Record) -> Result<bool, RunError> {
        if self.presses.next().is_none_or(|next| next > self.time) {
            return Ok(false);
        }
        let Some(event) = self.presses.take() else { return Ok(false) };
        let fired = self.surfaces.events.fire_one(event, &mut self.equations, self.time, &self.state);
        self.act(fired, f64::MIN_POSITIVE, record)?;
        Ok(true)
    }

    /// Continues after a switch of the equations. If the rates jump, two rows are recorded, before and after it.
    fn switch(&mut self, early: Early, record: &mut dyn Record) -> Result<(), RunError> {
        let began = self.time;
        self.surfaces.approach(&mut self.equations, early.before);
        let doubted = self.rates_around(early.before);
        self.time = early.beyond;
        self.state.copy_from_slice(self.surfaces.beyond());
        self.row.switches += 1;
        if self.row.switches >= Self::TO_AND_FRO && self.row.switches.is_power_of_two() {
            self.rest_on_corner();
        }
        let jumped = self.hold();
        self.drop_doubt(began, &doubted);
        if let Some(switch) = jumped {
            if early.before > began {
                record.row(early.before, self.surfaces.before(), false);
            }
            self.surfaces.switches.carry(&mut self.equations, self.time, switch, &mut self.state);
        }
        let target = (self.index + 1) as f64 * self.step;
        if jumped.is_some() || self.time == target || self.presses.next() == Some(self.time) {
            record.row(self.time, &self.state, jumped.is_some());
        }
        if !self.surfaces.events.due(self.time, &self.state) {
            self.surfaces.events.pass();
        }
        self.on_grid = self.time == target;
        if self.row.switches > Self::SWITCH_LIMIT {
            // Rates that are continuous are stiff there: no motion leads to and fro.
            let cause = match jumped {
                Some(_) => Cause::TooManySwitches(Self::SWITCH_LIMIT),
                None => Cause::TooManySteps(Self::SWITCH_LIMIT, self.method),
            };
            return Err(self.error(cause));
        }
        self.restart();
        Ok(())
    }

    /// Runs the actions of the located events.
    fn jump(&mut self, early: Early, record: &mut dyn Record) -> Result<(), RunError> {
        self.time = early.before;
        self.state.copy_from_slice(self.surfaces.before());
        record.row(self.time, &self.state, false);
        let fired = self.surfaces.events.fire(&mut self.equations, self.time, &self.state);
        self.act(fired, early.resolution, record)
    }

    /// Continues after events of which `fired` have acted, and runs those that become due by them. `resolution` is the
    /// shortest time in which the state changes.
    pub(super) fn act(&mut self, mut fired: usize, resolution: f64, record: &mut dyn Record) -> Result<(), RunError> {
        self.on_grid = false;
        loop {
            self.row.events += fired;
            let burst = self.row.event_burst.add(fired, self.time, self.step * Self::BURST_SPAN);
            let after = self.surfaces.events.after();
            if !after.iter().all(|value| value.is_finite()) {
                let cause = not_finite(after, false, self.method);
                return Err(self.error(cause));
            }
            self.state.copy_from_slice(after);
            record.row(self.time, &self.state, true);
            if burst > Self::BURST_LIMIT {
                return Err(self.error(Cause::TooManyEvents(Self::BURST_LIMIT, self.surfaces.events.first_due())));
            }
            fired = self.surfaces.events.cascade(self.time);
            if fired == 0 {
                break;
            }
        }
        self.hold();
        self.surfaces.events.settle(&mut self.equations, self.time, resolution, self.step);
        let on_grid = self.time == (self.index + 1) as f64 * self.step;
        let armed = self.surfaces.events.armed().to_vec();
        record.after_jump(AfterJump { armed, on_grid, presses: self.presses.acted() });
        self.restart();
        match self.surfaces.events.take_end() {
            Some(event) if self.heeds_ends => Err(self.error(Cause::Ended(event))),
            _ => Ok(()),
        }
    }
}

/// Cause of an error for a state that is not finite.
pub(super) fn not_finite(state: &[f64], singular: bool, method: Method) -> Cause {
    let first = state.iter().position(|value| !value.is_finite()).unwrap_or_default();
    if singular {
        Cause::Singular(first)
    } else if state.get(first).is_some_and(|value| value.is_infinite()) {
        Cause::Infinite(first, method)
    } else {
        Cause::NotANumber(first, method)
    }
}
