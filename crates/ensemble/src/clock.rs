//! Times and step control of lanes, as in the engine: a proportional-integral controller.

use crate::grid::{Block, Mask};
use engine::{LastStep, StepControl, dormand_prince_growth, dormand_prince_shrinkage};

/// Times and step control of the lanes in a block.
#[derive(Clone, Copy, Debug)]
pub struct Clock {
    /// Start of the last step.
    pub start: Block,
    /// Its size.
    pub size: Block,
    /// Its end.
    pub end: Block,
    /// Size proposed for the next step.
    pub proposed: Block,
    /// Error of the last step in units of the allowed error.
    pub error: Block,
    /// Size of the attempt.
    pub attempt: Block,
    /// Its error.
    pub found: Block,
    /// Growth of the step after it.
    pub growth: Block,
    /// 1 after an attempt that was not accepted.
    pub rejected: Block,
    /// Lanes in which the last attempt is accepted.
    pub accepted: Mask,
}

impl Clock {
    /// The start of runs at 0.
    pub fn begin(control: &StepControl) -> Self {
        let zero = Block::of(0.0);
        Self {
            start: zero,
            size: zero,
            end: zero,
            proposed: Block::of(control.first),
            error: Block::of(control.first_error),
            attempt: zero,
            found: zero,
            growth: zero,
            rejected: zero,
            accepted: Mask::NONE,
        }
    }

    /// Continues a lane of the block after a step that was made elsewhere.
    pub fn load(&mut self, lane: usize, last: &LastStep) {
        self.start.0[lane] = last.start;
        self.size.0[lane] = last.size;
        self.end.0[lane] = last.end;
        self.proposed.0[lane] = last.proposed;
        self.error.0[lane] = last.error;
        self.rejected.0[lane] = 0.0;
    }

    /// Accepts the attempts of the `active` lanes of the block, or shortens the next ones. `stalled` becomes true for lanes whose
    /// attempt cannot be shorter.
    #[inline(always)]
    pub fn judge(&mut self, active: &[bool], stalled: &mut [bool]) {
        let Self { error, found, rejected, .. } = *self;
        self.growth = Block::each(|lane| {
            let most = if rejected.0[lane] == 0.0 { 10.0 } else { 1.0 };
            dormand_prince_growth(error.0[lane], found.0[lane]).clamp(0.2, most)
        });
        for (lane, (&active, stalled)) in active.iter().zip(stalled).enumerate() {
            let accepted = active && found.0[lane] <= 1.0;
            self.accepted.set(lane, accepted);
            if active && !accepted {
                *stalled |= !self.shorten(lane);
            }
        }
    }

    /// Shortens the next attempt of a lane. False if it cannot be shorter.
    fn shorten(&mut self, lane: usize) -> bool {
        let (size, end) = (self.attempt.0[lane], self.end.0[lane]);
        let smallest = 16.0 * f64::EPSILON * end.abs().max(f64::MIN_POSITIVE / f64::EPSILON);
        if size <= smallest {
            return false;
        }
        let shrinkage = dormand_prince_shrinkage(self.found.0[lane]);
        // The comparison also covers NaN.
        let shorter = size * if shrinkage > 0.2 { shrinkage } else { 0.2 };
        self.attempt.0[lane] = shorter.max(smallest);
        self.rejected.0[lane] = 1.0;
        true
    }

    /// Takes over the accepted attempts as last steps.
    #[inline(always)]
    pub fn accept(&mut self) {
        let Self { start, size, end, proposed, error, attempt, found, growth, rejected, accepted } = *self;
        self.start = accepted.choose(end, start);
        self.size = accepted.choose(attempt, size);
        self.end = accepted.choose(Block::each(|lane| end.0[lane] + attempt.0[lane]), end);
        self.proposed = accepted.choose(Block::each(|lane| attempt.0[lane] * growth.0[lane]), proposed);
        self.error = accepted.choose(Block::each(|lane| found.0[lane].max(1e-4)), error);
        self.rejected = accepted.choose(Block::of(0.0), rejected);
    }
}
