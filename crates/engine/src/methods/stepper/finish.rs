//! The end of a run: what happens there happens, as it would in a longer run.

use super::Stepper;
use crate::{AfterJump, Record, RunError};

/// Upper bound of the rounding of a time, relative to it. Moments are products and sums, so an event that is meant for the end
/// of a run can lie a little behind it.
pub const ROUNDING: f64 = 1e-12;

/// Rows that may have to be given up.
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
    /// Lets everything happen that happens at `end` or before it, where it stands less than a row before `end` or there: events,
    /// presses and switches. Every row is one that a longer run has, too, and going on from here gives the bits of that run.
    ///
    /// # Errors
    /// An event that ends the run. Other errors lie behind the end.
    pub fn finish(&mut self, end: f64, record: &mut impl Record) -> Result<(), RunError> {
        if self.stopped.is_some() || (self.surfaces.events.is_empty() && self.presses.next().is_none()) {
            return Ok(());
        }
        let limit = end * (1.0 + ROUNDING);
        let target = (self.index + 1) as f64 * self.step;
        while self.time <= limit && target > limit {
            let mut ahead = self.clone();
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
