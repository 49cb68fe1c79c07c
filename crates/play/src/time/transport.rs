//! The clock and the transport of the time line: play, pause, proceed, show.

use super::TimeLine;
use super::course::Outcome;
use crate::{Basis, Changes};

/// Status of the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Paused.
    Paused,
    /// Playing: the run follows the clock.
    Playing,
    /// Paused because the recording is full; go back to the start or scrub back to continue.
    Full,
    /// Paused because the run failed; [`TimeLine::problem`] gives the reason.
    Failed,
    /// Paused at the end set by the document or an event; [`crate::Play::play`] continues beyond it.
    Ended,
}

/// Available speeds, as multiples of the speed of the document ([`program::Speed`]).
pub const SPEEDS: [f64; 7] = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0];

/// Longest gap between ticks, in seconds, for which the run catches up. Browsers wake a hidden page about once a
/// second, at worst once a minute. A longer gap means that the computer slept; the run then skips it.
pub const LONGEST_GAP: f64 = 60.0;

/// Maximum work in one tick, in floating-point operations: some milliseconds. The resulting delay is
/// [`TimeLine::slippage`].
pub const WORK_PER_TICK: u64 = 1_000_000;

impl TimeLine {
    /// Time (SI) to be reached after `seconds` of wall time; `None` unless the run plays.
    pub(crate) fn due(&self, seconds: f64) -> Option<f64> {
        let follows = self.playing && seconds.is_finite() && seconds > 0.0 && seconds <= LONGEST_GAP;
        follows.then(|| self.course.time() + seconds * self.speed * self.pace.per_second)
    }

    /// Plays from the time shown, which must be the front, unless the recording is full or the run could not start.
    pub(crate) fn play(&mut self) -> Changes {
        self.course.go_on();
        self.playing = !self.full && self.course.history().is_some();
        self.slippage = 0.0;
        Changes::TRANSPORT
    }

    /// Pauses the run.
    pub(crate) fn stop(&mut self) -> Changes {
        Changes::TRANSPORT.only_if(std::mem::take(&mut self.playing))
    }

    /// Continues to a time (SI), beyond an event that ended the run, and shows that moment. `work` is the limit in
    /// floating-point operations.
    pub(crate) fn go_on(&mut self, basis: &Basis, to: f64, work: u64) -> (Outcome, Changes) {
        self.course.go_on();
        self.proceed(basis, to, work)
    }

    /// Continues to a time (SI) and shows that moment. `work` is the limit in floating-point operations.
    pub(crate) fn proceed(&mut self, basis: &Basis, to: f64, mut work: u64) -> (Outcome, Changes) {
        let before = self.status(basis);
        let mut changes = Changes::NONE;
        let outcome = self.course.proceed(to, &mut work);
        match outcome {
            Outcome::Reached => {}
            Outcome::Behind(missing) => self.slippage += missing / (self.speed * self.pace.per_second),
            Outcome::Full => {
                self.full = true;
                changes |= self.stop();
            }
            Outcome::Failed => changes |= self.stop() | Changes::TRANSPORT,
        }
        changes |= Changes::TRANSPORT.only_if(self.status(basis) != before);
        (outcome, changes | self.moved())
    }

    /// Shows a recorded time (SI). The columns must be up to date.
    pub(crate) fn show(&mut self, time: f64) -> Changes {
        self.course.show(time);
        Changes::PARAMETERS | Changes::TRANSPORT | self.moved()
    }

    /// Makes the moment shown the front of the run; rows recorded after it become the ghost. The columns must be up to
    /// date.
    pub(crate) fn branch(&mut self) -> Changes {
        if !self.course.is_scrubbed() {
            return Changes::NONE;
        }
        let changes = self.keep_ghost(self.course.rows_until_shown());
        self.course.resume();
        self.traces.truncate(self.course.rows());
        self.note_rewritten(self.course.front());
        self.full = false;
        changes | Changes::PARAMETERS | Changes::TRANSPORT | self.moved()
    }

    /// Playback speed, as a multiple of the document's speed.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Text of a playback speed, a multiple of the document's speed: `2 ×` in real time, otherwise with its unit,
    /// `2 d/s`.
    pub fn speed_text(&self, basis: &Basis, speed: f64) -> String {
        self.pace.text(speed, basis.style())
    }

    /// Sets the playback speed to the nearest of [`SPEEDS`].
    pub(crate) fn set_speed(&mut self, speed: f64) -> Changes {
        let distance = |offered: &f64| (libm::log2(*offered) - libm::log2(speed.max(f64::MIN_POSITIVE))).abs();
        let nearest = SPEEDS.into_iter().min_by(|one, other| distance(one).total_cmp(&distance(other)));
        match nearest.filter(|&nearest| nearest != self.speed && speed.is_finite()) {
            Some(nearest) => {
                self.speed = nearest;
                Changes::TRANSPORT
            }
            None => Changes::NONE,
        }
    }

    /// Status of the run.
    pub fn status(&self, basis: &Basis) -> Status {
        if self.playing {
            Status::Playing
        } else if self.course.is_scrubbed() {
            Status::Paused
        } else if self.course.has_ended() {
            Status::Ended
        } else if self.course.error().is_some() {
            Status::Failed
        } else if self.full {
            Status::Full
        } else if basis.program().until.is_some_and(|end| is_at(self.course.time(), end)) {
            Status::Ended
        } else {
            Status::Paused
        }
    }

    /// True while the run is playing.
    pub fn is_playing(&self) -> bool {
        self.playing
    }

    /// True if the run stopped because its memory limit was reached.
    pub(crate) fn is_full(&self) -> bool {
        self.full
    }

    /// Delay of the run behind the clock, in seconds of wall time, since it was last started or reset. It arises
    /// because each tick is limited to [`WORK_PER_TICK`].
    pub fn slippage(&self) -> f64 {
        self.slippage
    }

    /// True if a button can be pressed now. False if the run has failed, an event has ended it, or the recording is
    /// full, unless an earlier moment is shown.
    pub fn can_press(&self) -> bool {
        let course = &self.course;
        course.history().is_some() && (course.is_scrubbed() || (course.error().is_none() && !self.full))
    }
}

/// True if a time equals `end` up to rounding, which occurs for an event at the end.
pub(super) fn is_at(time: f64, end: f64) -> bool {
    (end..=end * (1.0 + engine::ROUNDING)).contains(&time)
}
