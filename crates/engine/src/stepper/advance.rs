//! From one point of the grid to the next: steps of the method, events on the way.

use super::{RowWork, Solver, Stepper};
use crate::adaptive::Stalled;
use crate::{AfterJump, Cause, Method, Record, RunError};

/// How far [`Stepper::advance_within`] got.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// To the next point of the grid, with so many events on the way.
    Row {
        /// The number of events.
        events: usize,
    },
    /// Not yet there: the work allowed is done.
    Partial,
}

impl Stepper {
    /// So many events in one step stop the run.
    pub const EVENT_LIMIT: usize = 1000;
    /// So many steps of an adaptive method between two grid points stop the run.
    pub const STEP_LIMIT: usize = 100_000;

    /// Goes to the next point of the grid; `record` receives every row on the way: time, state, and whether the state
    /// jumped there from the row before. The result is the number of events.
    ///
    /// # Errors
    /// A state that is no longer finite, too many events, a step that has become too small or too many of them. The state
    /// is then the last finite one, and every further try gives the same error until parameters change.
    pub fn advance(&mut self, mut record: impl FnMut(f64, &[f64], bool)) -> Result<usize, RunError> {
        loop {
            if let Progress::Row { events } = self.advance_within(u64::MAX, &mut record)? {
                return Ok(events);
            }
        }
    }

    /// [`Stepper::advance`], but with no more than about `work` floating-point operations ([`Stepper::work`]); where these
    /// are not enough the next call goes on. At least one step is made. The bits of the rows are the same however the work
    /// is divided.
    ///
    /// # Errors
    /// As [`Stepper::advance`].
    pub fn advance_within(&mut self, work: u64, record: &mut impl Record) -> Result<Progress, RunError> {
        let target = (self.index + 1) as f64 * self.step;
        let arrived = self.try_until(target, work, record)?;
        if !arrived {
            return Ok(Progress::Partial);
        }
        self.index += 1;
        self.on_grid = self.time == target;
        Ok(Progress::Row { events: std::mem::take(&mut self.row).events })
    }

    /// Whether it stands between two points of the grid after [`Progress::Partial`]: not after an error.
    pub fn is_between_rows(&self) -> bool {
        self.row.steps > 0 && self.stopped.is_none()
    }

    /// Goes to any later time, which need not be on the grid, without a record; the result is the number of events.
    ///
    /// # Errors
    /// As [`Stepper::advance`].
    pub fn advance_to(&mut self, time: f64) -> Result<usize, RunError> {
        self.on_grid = false;
        self.row = RowWork::default();
        let result = self.try_until(time, u64::MAX, &mut |_: f64, _: &[f64], _: bool| {});
        self.find_grid();
        result.map(|_| std::mem::take(&mut self.row).events)
    }

    /// [`Stepper::advance_until`]; after an error every further try gives the same one.
    fn try_until(&mut self, target: f64, work: u64, record: &mut impl Record) -> Result<bool, RunError> {
        if let Some(error) = &self.stopped {
            return Err(error.clone());
        }
        let result = self.advance_until(target, work, record);
        if let Err(error) = &result {
            self.stopped = Some(error.clone());
        }
        result
    }

    /// Goes towards a time; whether it is reached.
    fn advance_until(&mut self, target: f64, work: u64, record: &mut impl Record) -> Result<bool, RunError> {
        let begun = self.work();
        while self.time < target {
            self.row.steps += 1;
            let jumped = match self.solver {
                Solver::Fixed(_) => self.fixed(target)?,
                Solver::Adaptive(_) if self.row.steps > Self::STEP_LIMIT => {
                    return Err(self.error(Cause::TooManySteps(Self::STEP_LIMIT, self.method)));
                }
                Solver::Adaptive(_) => self.adaptive(target)?,
            };
            match jumped {
                Some(resolution) => self.jump(resolution, record)?,
                None if self.time == target => record.row(self.time, &self.state, false),
                None => {}
            }
            if self.time < target && self.work() - begun >= work {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// One step to `target`, or, if an event lies before it, to the event, whose resolution in time is returned.
    // Not inlined: `advance` is compiled with its caller, which in the page is optimised for size.
    fn fixed(&mut self, target: f64) -> Result<Option<f64>, RunError> {
        let Solver::Fixed(method) = &mut self.solver else {
            return Ok(None);
        };
        let equations = &mut self.equations;
        let size = if self.on_grid { self.step } else { target - self.time };
        method.step(equations, self.time, size, &self.state, &mut self.next);
        if !self.next.iter().all(|value| value.is_finite()) {
            let cause = not_finite(&self.next, equations.singular(), self.method);
            return Err(self.error(cause));
        }
        if !self.events.is_empty() {
            if self.events.due(target, &self.next) {
                let (time, state) = (self.time, &self.state);
                let crossing = self.events.locate(time, 0.0, size, |since, out| {
                    method.step(equations, time, since, state, out);
                });
                self.time += crossing.low;
                return Ok(Some(crossing.high - crossing.low));
            }
            self.events.pass();
        }
        std::mem::swap(&mut self.state, &mut self.next);
        self.time = target;
        Ok(None)
    }

    /// Goes on to `target` or to the end of the method's own step, whichever is first; or, if an event lies before that, to
    /// the event, whose resolution in time is returned.
    fn adaptive(&mut self, target: f64) -> Result<Option<f64>, RunError> {
        let Solver::Adaptive(method) = &mut self.solver else {
            return Ok(None);
        };
        let equations = &mut self.equations;
        if method.end() <= self.time
            && let Err(stalled) = method.extend(equations, target)
        {
            let cause = match stalled {
                Stalled::NotFinite => not_finite(method.attempt(), equations.singular(), self.method),
                Stalled::TooSmall => Cause::StepTooSmall,
            };
            return Err(self.error(cause));
        }
        let until = target.min(method.end());
        if until == method.end() {
            self.next.copy_from_slice(method.end_state());
        } else {
            method.dense(until - method.start(), &mut self.next);
        }
        if !self.events.is_empty() {
            if self.events.due(until, &self.next) {
                let start = method.start();
                let crossing = method.locate(equations, &mut self.events, self.time - start, until - start);
                self.time = start + crossing.low;
                return Ok(Some(crossing.high - crossing.low));
            }
            self.events.pass();
        }
        std::mem::swap(&mut self.state, &mut self.next);
        self.time = until;
        Ok(None)
    }

    /// An error at the present time.
    fn error(&self, cause: Cause) -> RunError {
        RunError { cause, time: self.time }
    }

    /// Lets the located events act.
    fn jump(&mut self, resolution: f64, record: &mut impl Record) -> Result<(), RunError> {
        self.on_grid = false;
        self.state.copy_from_slice(self.events.before());
        record.row(self.time, &self.state, false);
        self.row.events += self.events.fire(self.time);
        loop {
            let after = self.events.after();
            if !after.iter().all(|value| value.is_finite()) {
                let cause = not_finite(after, false, self.method);
                return Err(self.error(cause));
            }
            self.state.copy_from_slice(after);
            record.row(self.time, &self.state, true);
            if self.row.events > Self::EVENT_LIMIT {
                return Err(self.error(Cause::TooManyEvents(Self::EVENT_LIMIT, self.events.first_due())));
            }
            match self.events.cascade(self.time) {
                0 => break,
                more => self.row.events += more,
            }
        }
        self.events.settle(&mut self.equations, self.time, resolution, self.step);
        let on_grid = self.time == (self.index + 1) as f64 * self.step;
        record.after_jump(AfterJump { armed: self.events.armed().to_vec(), on_grid });
        self.restart();
        Ok(())
    }
}

/// Why a state that a step has given cannot be taken.
fn not_finite(state: &[f64], singular: bool, method: Method) -> Cause {
    let first = state.iter().position(|value| !value.is_finite()).unwrap_or_default();
    if singular {
        Cause::Singular(first)
    } else if state.get(first).is_some_and(|value| value.is_infinite()) {
        Cause::Infinite(first, method)
    } else {
        Cause::NotANumber(first, method)
    }
}
