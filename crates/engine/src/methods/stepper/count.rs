//! Runs with a counting independent variable (discrete time): nothing happens between two counts, and each count gives one
//! row, recorded after its events.

use super::advance::not_finite;
use super::{Solver, Stepper};
use crate::{AfterJump, Cause, Record, RunError};

impl Stepper {
    /// Advances towards a count or a time between two counts. True if it is reached.
    pub(super) fn count_until(&mut self, target: f64, work: u64, record: &mut dyn Record) -> Result<bool, RunError> {
        let begun = self.work();
        loop {
            if self.time < target && self.press(record)? {
                continue;
            }
            let next = self.time.floor() + 1.0;
            if next > target {
                self.time = target;
                return Ok(true);
            }
            self.row.steps += 1;
            self.count(next, record)?;
            if self.time < target && self.work() - begun >= work {
                return Ok(false);
            }
        }
    }

    /// Advances to the next count and runs its events.
    fn count(&mut self, next: f64, record: &mut dyn Record) -> Result<(), RunError> {
        // Only running sums of the model have rates.
        if let Solver::Fixed(method) = &mut self.solver {
            method.step(&mut self.equations, self.time, next - self.time, &self.state, &mut self.next);
        }
        self.time = next;
        let events = &mut self.surfaces.events;
        let due = events.due(next, &self.next);
        if due {
            let mut fired = events.fire(&mut self.equations, next, &self.next);
            let mut count = 0;
            while fired > 0 {
                count += fired;
                if count > Self::BURST_LIMIT {
                    let cause = Cause::TooManyEvents(Self::BURST_LIMIT, events.first_due());
                    return Err(RunError { cause, time: next });
                }
                fired = events.cascade(next);
            }
            self.row.events += count;
            self.next.copy_from_slice(events.after());
        } else {
            events.pass();
        }
        if !self.next.iter().all(|value| value.is_finite()) {
            let cause = not_finite(&self.next, self.equations.singular(), self.method);
            return Err(RunError { cause, time: next });
        }
        std::mem::swap(&mut self.state, &mut self.next);
        record.row(next, &self.state, false);
        if due {
            let armed = self.surfaces.events.armed().to_vec();
            record.after_jump(AfterJump { armed, on_grid: true, presses: self.presses.acted() });
        }
        self.hold();
        match self.surfaces.events.take_end() {
            Some(event) if self.heeds_ends => Err(RunError { cause: Cause::Ended(event), time: next }),
            _ => Ok(()),
        }
    }
}
