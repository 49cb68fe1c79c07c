//! The clock and the transport: play, pause, step, scrub.

use crate::time::course::Outcome;
use crate::{Announcement, Changes, Play, number};
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
    /// Paused because the run failed; [`Play::problem`] gives the reason.
    Failed,
    /// Paused at the end set by the document or an event; [`Play::play`] continues beyond it.
    Ended,
}

/// Available speeds, as multiples of the speed of the document ([`program::Speed`]).
pub const SPEEDS: [f64; 7] = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0];

/// Longest gap between ticks, in seconds, for which the run catches up. Browsers wake a hidden page about once a
/// second, at worst once a minute. A longer gap means that the computer slept; the run then skips it.
pub const LONGEST_GAP: f64 = 60.0;

/// Maximum work in one tick, in floating-point operations: some milliseconds. The resulting delay is
/// [`Play::slippage`].
pub const WORK_PER_TICK: u64 = 1_000_000;

/// Maximum work for a single step by the user: less than half a second.
const WORK_PER_STEP: u64 = 50_000_000;

/// Initial length, in steps, of the time line and of plots against the independent variable.
const STEPS_AT_FIRST: f64 = 200.0;

impl Play {
    /// Advances by `seconds` of wall time. Returns true if anything shown has changed.
    pub fn tick(&mut self, seconds: f64) -> bool {
        if !self.playing || !seconds.is_finite() || seconds <= 0.0 || seconds > LONGEST_GAP {
            return false;
        }
        let to = self.course.time() + seconds * self.speed * self.pace.per_second;
        let end = self.end_ahead().filter(|end| *end <= to);
        self.proceed(end.unwrap_or(to), WORK_PER_TICK);
        if self.playing && end.is_some_and(|end| self.course.time() >= end) {
            self.stop();
            self.announce(Announcement::Ended(self.course.time()));
        }
        true
    }

    /// Plays from the time shown. After scrubbing, the later rows are discarded and become the ghost.
    pub fn play(&mut self) {
        if self.playing {
            return;
        }
        self.hold = None;
        self.branch();
        self.course.go_on();
        self.playing = !self.full && self.course.history().is_some();
        self.slippage = 0.0;
        self.note(Changes::TRANSPORT);
        self.announce(if self.playing {
            Announcement::Playing
        } else if self.full {
            Announcement::Full
        } else {
            Announcement::Failed
        });
    }

    /// Pauses the run.
    pub fn pause(&mut self) {
        if self.playing {
            self.stop();
            self.announce(Announcement::Paused(self.course.time()));
        }
    }

    /// Toggles between playing and paused.
    pub fn toggle(&mut self) {
        if self.playing {
            self.pause();
        } else {
            self.play();
        }
    }

    /// Pauses and advances to the next grid time. After scrubbing, the run continues from the time shown, as with
    /// [`Play::play`].
    pub fn step_forward(&mut self) {
        self.stop();
        self.branch();
        self.course.go_on();
        let to = self.course.next_grid_time();
        self.proceed(self.end_ahead().map_or(to, |end| to.min(end)), WORK_PER_STEP);
        self.announce(Announcement::Stepped(self.course.time()));
    }

    /// Pauses and shows the previous grid time.
    pub fn step_back(&mut self) {
        self.stop();
        self.show(self.course.previous_grid_time());
        self.announce(Announcement::Stepped(self.course.time()));
    }

    /// Restarts at time 0 with the present parameters, paused. A start set by hand stays ([`Play::restore_defaults`]
    /// discards it); the ghost is removed.
    pub fn back_to_start(&mut self) {
        self.stop();
        self.hold = None;
        let parameters = self.course.parameters().to_vec();
        let setup = Setup { parameters, ..self.course.begun().clone() };
        self.restart(setup);
        self.clear_ghost();
        self.announce(Announcement::BackAtStart);
    }

    /// Pauses and shows a recorded time (SI), clamped to the recording.
    pub fn scrub(&mut self, time: f64) {
        self.stop();
        self.show(time);
        self.announce(Announcement::Scrubbed(self.course.time()));
    }

    /// Computes one grid step towards a time (SI), from the end of the recording and without an announcement. Used when
    /// something other than the transport, such as a film, controls the time. Returns true if more remains to be
    /// computed; false while the run plays.
    pub fn compute_on(&mut self, until: f64) -> bool {
        let before = self.course.front();
        if self.playing || self.full || before >= until || self.course.error().is_some() {
            return false;
        }
        self.show(before);
        self.course.go_on();
        let to = self.course.next_grid_time();
        self.proceed(self.end_ahead().map_or(to, |end| to.min(end)), WORK_PER_STEP);
        self.course.front() > before
    }

    /// Shows a recorded time (SI) without an announcement, unless the run plays.
    pub fn show_time(&mut self, time: f64) {
        let time = time.clamp(0.0, self.course.front());
        if !self.playing && self.course.time() != time {
            self.show(time);
        }
    }

    /// Playback speed, as a multiple of the document's speed.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Text of a playback speed, a multiple of the document's speed: `2 ×` in real time, otherwise with its unit,
    /// `2 d/s`.
    pub fn speed_text(&self, speed: f64) -> String {
        self.pace.text(speed, self.basis.style())
    }

    /// Sets the playback speed to the nearest of [`SPEEDS`].
    pub fn set_speed(&mut self, speed: f64) {
        let distance = |offered: &f64| (libm::log2(*offered) - libm::log2(speed.max(f64::MIN_POSITIVE))).abs();
        let nearest = SPEEDS.into_iter().min_by(|one, other| distance(one).total_cmp(&distance(other)));
        if let Some(nearest) = nearest.filter(|&nearest| nearest != self.speed && speed.is_finite()) {
            self.speed = nearest;
            self.note(Changes::TRANSPORT);
            self.announce(Announcement::Speed(nearest));
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
        } else if self.basis.program().until.is_some_and(|end| is_at(self.course.time(), end)) {
            Status::Ended
        } else {
            Status::Paused
        }
    }

    /// End of the run set by the document (SI), if it is still ahead.
    fn end_ahead(&self) -> Option<f64> {
        self.basis.program().until.filter(|end| *end > self.course.time())
    }

    /// True while the run is playing.
    pub fn is_playing(&self) -> bool {
        self.playing
    }

    /// Time shown (SI).
    pub fn time(&self) -> f64 {
        self.course.time()
    }

    /// Greatest time reached (SI), the upper limit for scrubbing.
    pub fn end(&self) -> f64 {
        self.course.front()
    }

    /// End of the time line (SI). It starts with the length of a plot against time and doubles whenever the run reaches
    /// it, limited by the end set by the document. So the line shows the progress of the run without stretching in
    /// every frame.
    pub fn horizon(&self) -> f64 {
        let mut horizon = self.step() * STEPS_AT_FIRST;
        while horizon < self.end() {
            horizon *= 2.0;
        }
        self.basis
            .program()
            .until
            .filter(|end| *end >= self.end() || is_at(self.end(), *end))
            .map_or(horizon, |end| horizon.min(end))
    }

    /// Initial length of plots against the independent variable (SI).
    pub(crate) fn first_part(&self) -> f64 {
        let first = self.step() * STEPS_AT_FIRST;
        self.basis.program().until.map_or(first, |end| first.min(end))
    }

    /// True if a time before [`Play::end`] is shown.
    pub fn is_scrubbed(&self) -> bool {
        self.course.is_scrubbed()
    }

    /// Text of the time shown, `12,35 s`, with as many decimals as the step has, at least two.
    pub fn time_text(&self) -> String {
        self.time_words(self.course.time())
    }

    /// Text of any time (SI) in the same format, for the ends of the time line and for `aria-valuetext`.
    pub fn time_words(&self, time: f64) -> String {
        if let Some(group) = self.small_times() {
            return group.quantity(time);
        }
        let unit = &self.model().independent.unit;
        let number = self.time_number(time);
        if unit.text.is_empty() { number } else { format!("{number} {}", number::unit_text(&unit.text)) }
    }

    /// Format with a prefixed unit for times that would need more than six decimals or are all below a tenth of their
    /// unit; `None` if the unit fits.
    pub(crate) fn small_times(&self) -> Option<number::Group> {
        let longest = self.basis.program().until.unwrap_or_else(|| self.horizon());
        let unit = &self.model().independent.unit;
        let is_small = self.step_decimals() > 6 || unit.from_si(longest) < 0.1;
        is_small.then(|| number::Group::of_scale(unit, longest, 4, self.basis.style()))
    }

    /// Number of decimals of a time: that of the step, from two to six.
    pub(crate) fn time_decimals(&self) -> usize {
        self.step_decimals().clamp(2, 6)
    }

    /// Number of decimals that the step needs for three digits.
    fn step_decimals(&self) -> usize {
        number::decimals(self.model().independent.unit.from_si(self.step()), 3)
    }

    pub(crate) fn time_number(&self, time: f64) -> String {
        if self.model().independent.counts {
            return number::fixed(time.floor(), 0, self.basis.style());
        }
        let unit = &self.model().independent.unit;
        number::fixed(unit.from_si(time), self.time_decimals(), self.basis.style())
    }

    /// Delay of the run behind the clock, in seconds of wall time, since it was last started or reset. It arises
    /// because each tick is limited to [`WORK_PER_TICK`].
    pub fn slippage(&self) -> f64 {
        self.slippage
    }

    pub(crate) fn stop(&mut self) {
        if self.playing {
            self.playing = false;
            self.note(Changes::TRANSPORT);
        }
    }

    fn show(&mut self, time: f64) {
        self.follow();
        self.course.show(time);
        self.note(Changes::PARAMETERS);
        self.note(Changes::TRANSPORT);
        self.frame_changed();
    }

    /// Makes the moment shown the front of the run; rows recorded after it become the ghost.
    pub(crate) fn branch(&mut self) {
        if !self.course.is_scrubbed() {
            return;
        }
        self.keep_ghost(self.course.rows_until_shown());
        self.course.resume();
        self.traces.truncate(self.course.rows());
        self.note_rewritten(self.course.front());
        self.full = false;
        self.note(Changes::PARAMETERS);
        self.note(Changes::TRANSPORT);
        self.frame_changed();
    }

    /// Restarts with these parameters (SI) and the model's own start, computes the run up to a time (SI) and shows its
    /// beginning.
    pub fn run_through(&mut self, parameters: Vec<f64>, to: f64) {
        self.stop();
        let setup = Setup { parameters, start: None, ..self.course.begun().clone() };
        self.restart(setup);
        self.clear_ghost();
        self.proceed(to, WORK_PER_STEP);
        self.show(0.0);
    }

    fn proceed(&mut self, to: f64, mut work: u64) {
        let before = self.status();
        match self.course.proceed(to, &mut work) {
            Outcome::Reached => {}
            Outcome::Behind(missing) => self.slippage += missing / (self.speed * self.pace.per_second),
            Outcome::Full => {
                self.full = true;
                self.stop();
                self.announce(Announcement::Full);
            }
            Outcome::Failed => {
                self.stop();
                self.note(Changes::TRANSPORT);
                self.announce(Announcement::Failed);
            }
        }
        if self.status() != before {
            self.note(Changes::TRANSPORT);
        }
        self.frame_changed();
    }
}

/// True if a time equals `end` up to rounding, which occurs for an event at the end.
fn is_at(time: f64, end: f64) -> bool {
    (end..=end * (1.0 + engine::ROUNDING)).contains(&time)
}
