//! The clock and the transport of the time line: play, pause, proceed, show.

use super::TimeLine;
use super::course::{Course, Outcome};
use crate::{Announcement, Basis, Changes};
use engine::Setup;

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
    /// Paused at the end set by the document or an event; [`TimeLine::play`] continues beyond it.
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

/// Maximum work for a single step by the user: less than half a second.
const WORK_PER_STEP: u64 = 50_000_000;

impl TimeLine {
    /// Advances by `seconds` of wall time. Returns true if anything shown has changed.
    pub fn tick(&mut self, seconds: f64) -> (bool, Changes) {
        if !(self.playing && seconds.is_finite() && seconds > 0.0 && seconds <= LONGEST_GAP) {
            return (false, Changes::NONE);
        }
        let to = self.course.time() + seconds * self.speed * self.pace.per_second;
        let end = self.end_ahead().filter(|end| *end <= to);
        let mut changes = self.proceed(end.unwrap_or(to), WORK_PER_TICK);
        if self.playing && end.is_some_and(|end| self.course.time() >= end) {
            changes |= self.stop().announcing(Announcement::Ended(self.course.time()));
        }
        (true, changes)
    }

    /// Plays from the time shown, unless the recording is full or the run could not start. After scrubbing, the later
    /// rows are discarded and become the ghost. A part of the scene that is dragged is released.
    pub fn play(&mut self) -> Changes {
        if self.playing {
            return Changes::NONE;
        }
        let changes = Changes::RELEASED | self.branch() | self.play_on();
        changes.announcing(if self.playing {
            Announcement::Playing
        } else if self.full {
            Announcement::Full
        } else {
            Announcement::Failed
        })
    }

    /// Plays from the front of the run without an announcement.
    pub(crate) fn play_on(&mut self) -> Changes {
        self.course.go_on();
        self.playing = !self.full && self.course.history().is_some();
        self.slippage = 0.0;
        Changes::TRANSPORT
    }

    /// Pauses the run.
    pub fn pause(&mut self) -> Changes {
        if self.playing { self.stop().announcing(Announcement::Paused(self.course.time())) } else { Changes::NONE }
    }

    /// Toggles between playing and paused.
    pub fn toggle(&mut self) -> Changes {
        if self.playing { self.pause() } else { self.play() }
    }

    /// Pauses and advances to the next grid time. After scrubbing, the run continues from the time shown, as with
    /// [`TimeLine::play`].
    pub fn step_forward(&mut self) -> Changes {
        let changes = self.stop() | self.branch() | self.step_on();
        changes.announcing(Announcement::Stepped(self.course.time()))
    }

    /// Pauses and shows the previous grid time.
    pub fn step_back(&mut self) -> Changes {
        let changes = self.stop() | self.show(self.course.previous_grid_time());
        changes.announcing(Announcement::Stepped(self.course.time()))
    }

    /// Restarts at time 0 with the present parameters, paused. A start set by hand stays
    /// ([`crate::Settings::restore_defaults`] discards it); the ghost is removed.
    pub fn back_to_start(&mut self, basis: &Basis) -> Changes {
        let changes = Changes::RELEASED | self.stop() | self.restart(basis, self.setup()) | self.clear_ghost();
        changes.announcing(Announcement::BackAtStart)
    }

    /// Pauses and shows a recorded time (SI), clamped to the recording.
    pub fn scrub(&mut self, time: f64) -> Changes {
        let changes = self.stop() | self.show(time);
        changes.announcing(Announcement::Scrubbed(self.course.time()))
    }

    /// Computes one grid step towards a time (SI), from the end of the recording and without an announcement. Used when
    /// something other than the transport, such as a film, controls the time. Returns true if more remains to be
    /// computed; false while the run plays.
    pub fn compute_on(&mut self, until: f64) -> (bool, Changes) {
        let before = self.course.front();
        if self.playing || self.full || self.course.error().is_some() || before >= until {
            return (false, Changes::NONE);
        }
        let changes = self.show(before) | self.step_on();
        (self.course.front() > before, changes)
    }

    /// Shows a recorded time (SI) without an announcement, unless the run plays.
    pub fn show_time(&mut self, time: f64) -> Changes {
        let time = time.clamp(0.0, self.course.front());
        if self.playing || self.course.time() == time { Changes::NONE } else { self.show(time) }
    }

    /// Starts another run with this setup and its presses, paused, in the place of the present one.
    pub fn start(&mut self, basis: &Basis, setup: Setup) -> Changes {
        let changes = self.stop();
        let course = Course::start(self.motion(basis), setup, self.columns.bytes_per_row());
        changes | self.replace(course)
    }

    /// Restarts with these parameters (SI) and the model's own start, computes the run up to a time (SI) and shows its
    /// beginning.
    pub fn run_through(&mut self, basis: &Basis, parameters: Vec<f64>, to: f64) -> Changes {
        let changes = self.stop();
        let setup = Setup { parameters, start: None, ..self.course.begun().clone() };
        let changes = changes | self.restart(basis, setup) | self.clear_ghost();
        changes | self.proceed(to, WORK_PER_STEP) | self.show(0.0)
    }

    /// Pauses the run without an announcement.
    pub(crate) fn stop(&mut self) -> Changes {
        Changes::TRANSPORT.only_if(std::mem::take(&mut self.playing))
    }

    /// End of the run set by the document (SI), if it is still ahead.
    fn end_ahead(&self) -> Option<f64> {
        self.until.filter(|end| *end > self.course.time())
    }

    /// Advances to the next grid time, beyond an event that ended the run.
    fn step_on(&mut self) -> Changes {
        let to = self.course.next_grid_time();
        let to = self.end_ahead().map_or(to, |end| to.min(end));
        self.course.go_on();
        self.proceed(to, WORK_PER_STEP)
    }

    /// Continues to a time (SI) and shows that moment. `work` is the limit in floating-point operations.
    fn proceed(&mut self, to: f64, mut work: u64) -> Changes {
        let before = self.status();
        let mut changes = match self.course.proceed(to, &mut work) {
            Outcome::Reached => Changes::NONE,
            Outcome::Behind(missing) => {
                self.slippage += missing / (self.speed * self.pace.per_second);
                Changes::NONE
            }
            Outcome::Full => {
                self.full = true;
                self.stop().announcing(Announcement::Full)
            }
            Outcome::Failed => (self.stop() | Changes::TRANSPORT).announcing(Announcement::Failed),
        };
        changes |= Changes::TRANSPORT.only_if(self.status() != before);
        changes | self.moved()
    }

    /// Shows a recorded time (SI).
    fn show(&mut self, time: f64) -> Changes {
        self.follow_rows();
        self.course.show(time);
        Changes::PARAMETERS | Changes::TRANSPORT | self.moved()
    }

    /// Makes the moment shown the front of the run; rows recorded after it become the ghost.
    pub(super) fn branch(&mut self) -> Changes {
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
    pub fn set_speed(&mut self, speed: f64) -> Changes {
        let distance = |offered: &f64| (libm::log2(*offered) - libm::log2(speed.max(f64::MIN_POSITIVE))).abs();
        let nearest = SPEEDS.into_iter().min_by(|one, other| distance(one).total_cmp(&distance(other)));
        match nearest.filter(|&nearest| nearest != self.speed && speed.is_finite()) {
            Some(nearest) => {
                self.speed = nearest;
                Changes::TRANSPORT.announcing(Announcement::Speed(nearest))
            }
            None => Changes::NONE,
        }
    }

    /// Status of the run.
    pub fn status(&self) -> Status {
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
        } else if self.until.is_some_and(|end| is_at(self.course.time(), end)) {
            Status::Ended
        } else {
            Status::Paused
        }
    }

    /// True while the run is playing.
    pub fn is_playing(&self) -> bool {
        self.playing
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
