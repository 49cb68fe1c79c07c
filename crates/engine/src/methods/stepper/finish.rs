//! End of a run: processes everything up to the end time, as a longer run would.

use super::Stepper;
use crate::{AfterJump, Record, RunError};

/// Upper bound of the rounding of a time, relative to it. Times are products and sums, so an event meant for the end of a
/// run can be slightly after it.
pub const ROUNDING: f64 = 1e-12;

/// Numbers of the rows of a run up to `until`, at distances of `step` (SI units): of the last row at or before it, and of the last one
/// that is computed to reach it.
pub fn rows_until(step: f64, until: f64) -> [u64; 2] {
    let (last, begun) = (until * (1.0 + ROUNDING), until * (1.0 - ROUNDING));
    let mut all = (begun / step).max(0.0) as u64;
    while all > 0 && (all - 1) as f64 * step >= begun {
        all -= 1;
    }
    while (all as f64) * step < begun {
        all += 1;
    }
    let mut taken = all;
    while taken > 0 && taken as f64 * step > last {
        taken -= 1;
    }
    [taken, all]
}

/// Rows of a trial that may be discarded.
#[derive(Default)]
struct Rows(Vec<(f64, Vec<f64>, bool, Option<AfterJump>)>);

impl Record for Rows {
    fn row(&mut self, time: f64, state: &[f64], jumped: bool) {
        self.0.push((time, state.to_vec(), jumped, None));
    }

    fn after_jump(&mut self, after: AfterJump) {
        if let Some((.., last)) = self.0.last_mut() {
            *last = Some(after);
        }
    }
}

impl Stepper {
    /// Processes the events, presses and switches up to `end` (SI units) if the stepper is less than a row before `end`.
    /// Every row is also one of a longer run, and continuing from here gives the bits of that run.
    ///
    /// # Errors
    /// An event that ends the run. Other errors concern times after the end and are ignored.
    pub fn finish(&mut self, end: f64, record: &mut dyn Record) -> Result<(), RunError> {
        if self.stopped.is_some() || (self.surfaces.events.is_empty() && self.presses.next().is_none()) {
            return Ok(());
        }
        let limit = end * (1.0 + ROUNDING);
        let target = (self.index + 1) as f64 * self.step;
        while self.time <= limit && target > limit {
            let mut ahead = self.clone();
            ahead.catch_up();
            let mut rows = Rows::default();
            let outcome = match self.counts {
                true => ahead.press(&mut rows).map(drop),
                false => ahead.advance_once(target, &mut rows),
            };
            let refused = outcome.as_ref().is_err_and(|error| !error.is_end());
            if refused || ahead.time > limit || (self.counts && rows.0.is_empty()) {
                break;
            }
            *self = ahead;
            self.row.steps = 0;
            for (time, state, jumped, after) in rows.0 {
                record.row(time, &state, jumped);
                if let Some(after) = after {
                    record.after_jump(after);
                }
            }
            if let Err(error) = outcome {
                self.stopped = Some(error.clone());
                return Err(error);
            }
        }
        Ok(())
    }
}
