//! The clock and the transport: play, pause, step, scrub.

use crate::time::course::Outcome;
use crate::{Announcement, Play, number};
use engine::Setup;

/// What the run is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Standing still.
    Paused,
    /// Going on with the clock.
    Playing,
    /// Standing still because the history is full; back to the start, or scrub back, to go on.
    Full,
    /// Standing still because the run cannot go on; [`Play::problem`] says why.
    Failed,
    /// Standing still where the document or an event of it ends the run; [`Play::play`] goes on beyond it.
    Ended,
}

/// The speeds that are offered, as multiples of the one that the document begins with ([`program::Speed`]).
pub const SPEEDS: [f64; 7] = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0];

/// The longest gap between ticks, in seconds, that the run makes up. Browsers wake a hidden page about once a second, at
/// worst once a minute: its run goes on with the clock. A longer gap is a machine that slept, and its run slept too.
pub const LONGEST_GAP: f64 = 60.0;

/// The work done in one tick, in floating-point operations: some milliseconds. What is missing then is
/// [`Play::slippage`].
pub const WORK_PER_TICK: u64 = 1_000_000;

/// The work done when a person asks for one step: less than half a second.
const WORK_PER_STEP: u64 = 50_000_000;

/// The time line, and a plot against the independent variable, begin with room for so many steps.
const STEPS_AT_FIRST: f64 = 200.0;

impl Play {
    /// Lets `seconds` of wall time pass. Returns whether anything that is shown has changed.
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

    /// Goes on from the time shown. After scrubbing the rows after it are given up and stay as a ghost.
    pub fn play(&mut self) {
        if self.playing {
            return;
        }
        self.hold = None;
        self.branch();
        self.course.go_on();
        self.playing = !self.full && self.course.history().is_some();
        self.slippage = 0.0;
        self.revision.transport += 1;
        self.announce(if self.playing {
            Announcement::Playing
        } else if self.full {
            Announcement::Full
        } else {
            Announcement::Failed
        });
    }

    /// Stands still.
    pub fn pause(&mut self) {
        if self.playing {
            self.stop();
            self.announce(Announcement::Paused(self.course.time()));
        }
    }

    /// Plays if paused, pauses if playing.
    pub fn toggle(&mut self) {
        if self.playing {
            self.pause();
        } else {
            self.play();
        }
    }

    /// Pauses and goes to the next time of the grid. After scrubbing the run goes on from the time shown, as with
    /// [`Play::play`].
    pub fn step_forward(&mut self) {
        self.stop();
        self.branch();
        self.course.go_on();
        let to = self.course.next_grid_time();
        self.proceed(self.end_ahead().map_or(to, |end| to.min(end)), WORK_PER_STEP);
        self.announce(Announcement::Stepped(self.course.time()));
    }

    /// Pauses and shows the previous time of the grid.
    pub fn step_back(&mut self) {
        self.stop();
        self.show(self.course.previous_grid_time());
        self.announce(Announcement::Stepped(self.course.time()));
    }

    /// Back to time 0 with the present parameters; paused. A start set by hand stays the start
    /// ([`Play::restore_defaults`] gives it up); the ghost is removed.
    pub fn back_to_start(&mut self) {
        self.stop();
        self.hold = None;
        let parameters = self.course.parameters().to_vec();
        let setup = Setup { parameters, ..self.course.begun().clone() };
        self.restart(setup);
        self.clear_ghost();
        self.announce(Announcement::BackAtStart);
    }

    /// Pauses and shows an earlier time (clamped to what is recorded).
    pub fn scrub(&mut self, time: f64) {
        self.stop();
        self.show(time);
        self.announce(Announcement::Scrubbed(self.course.time()));
    }

    /// Computes on towards a time by one step of the grid, from the end of what is recorded and without an announcement: something
    /// beside the run, such as a film, leads. Whether there is more to compute; not while the run plays.
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

    /// Shows a time of what is recorded without an announcement, unless the run plays.
    pub fn show_time(&mut self, time: f64) {
        let time = time.clamp(0.0, self.course.front());
        if !self.playing && self.course.time() != time {
            self.show(time);
        }
    }

    /// How many times as fast the run is watched as the document says.
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// How fast a run is watched at one of [`SPEEDS`]: `2 ×` in real time, else with its unit, `2 d/s`.
    pub fn speed_text(&self, speed: f64) -> String {
        self.pace.text(speed, self.style)
    }

    /// Sets the speed to the nearest of [`SPEEDS`].
    pub fn set_speed(&mut self, speed: f64) {
        let distance = |offered: &f64| (libm::log2(*offered) - libm::log2(speed.max(f64::MIN_POSITIVE))).abs();
        let nearest = SPEEDS.into_iter().min_by(|one, other| distance(one).total_cmp(&distance(other)));
        if let Some(nearest) = nearest.filter(|&nearest| nearest != self.speed && speed.is_finite()) {
            self.speed = nearest;
            self.revision.transport += 1;
            self.announce(Announcement::Speed(nearest));
        }
    }

    /// What the run is doing.
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
        } else if self.program.until.is_some_and(|end| is_at(self.course.time(), end)) {
            Status::Ended
        } else {
            Status::Paused
        }
    }

    /// Where the document ends the run (SI), if that is still ahead.
    fn end_ahead(&self) -> Option<f64> {
        self.program.until.filter(|end| *end > self.course.time())
    }

    /// Whether the run goes on with the clock.
    pub fn is_playing(&self) -> bool {
        self.playing
    }

    /// The time shown (SI).
    pub fn time(&self) -> f64 {
        self.course.time()
    }

    /// The last time that can be scrubbed to (SI): how far the run has come.
    pub fn end(&self) -> f64 {
        self.course.front()
    }

    /// The end of the time line (SI): as long as a plot against time at first, and twice as long whenever the run gets
    /// there, but no longer than the document's run. So the line shows how far the run has come and does not stretch in
    /// every frame.
    pub fn horizon(&self) -> f64 {
        let mut horizon = self.step() * STEPS_AT_FIRST;
        while horizon < self.end() {
            horizon *= 2.0;
        }
        self.program
            .until
            .filter(|end| *end >= self.end() || is_at(self.end(), *end))
            .map_or(horizon, |end| horizon.min(end))
    }

    /// What a plot against the independent variable shows at least (SI).
    pub(crate) fn first_part(&self) -> f64 {
        let first = self.step() * STEPS_AT_FIRST;
        self.program.until.map_or(first, |end| first.min(end))
    }

    /// Whether an earlier time than [`Play::end`] is shown.
    pub fn is_scrubbed(&self) -> bool {
        self.course.is_scrubbed()
    }

    /// `12,35 s`: the time shown, with as many decimals as the step has, at least two.
    pub fn time_text(&self) -> String {
        self.time_words(self.course.time())
    }

    /// Any time in the same way, for the ends of the time line and for `aria-valuetext`.
    pub fn time_words(&self, time: f64) -> String {
        if let Some(group) = self.small_times() {
            return group.quantity(time);
        }
        let unit = &self.model().independent.unit;
        let number = self.time_number(time);
        if unit.text.is_empty() { number } else { format!("{number} {}", number::unit_text(&unit.text)) }
    }

    /// How times are written that would need more than six decimals, or are all short of a tenth of their unit: in a unit with a
    /// prefix.
    pub(crate) fn small_times(&self) -> Option<number::Group> {
        let longest = self.program.until.unwrap_or_else(|| self.horizon());
        let unit = &self.model().independent.unit;
        let is_small = self.step_decimals() > 6 || unit.from_si(longest) < 0.1;
        is_small.then(|| number::Group::of_scale(unit, longest, 4, self.style))
    }

    /// As many decimals of a time as the step has, from two to six.
    pub(crate) fn time_decimals(&self) -> usize {
        self.step_decimals().clamp(2, 6)
    }

    /// As many decimals as the step needs for three digits.
    fn step_decimals(&self) -> usize {
        number::decimals(self.model().independent.unit.from_si(self.step()), 3)
    }

    pub(crate) fn time_number(&self, time: f64) -> String {
        if self.model().independent.counts {
            return number::fixed(time.floor(), 0, self.style);
        }
        let unit = &self.model().independent.unit;
        number::fixed(unit.from_si(time), self.time_decimals(), self.style)
    }

    /// Wall seconds by which the run has fallen behind the clock since it was last started or taken back to the start,
    /// because no more than [`WORK_PER_TICK`] is done in each tick.
    pub fn slippage(&self) -> f64 {
        self.slippage
    }

    pub(crate) fn stop(&mut self) {
        if self.playing {
            self.playing = false;
            self.revision.transport += 1;
        }
    }

    fn show(&mut self, time: f64) {
        self.follow();
        self.course.show(time);
        self.revision.parameters += 1;
        self.revision.transport += 1;
        self.frame_changed();
    }

    /// Makes the moment shown the front of the run: what was recorded after it becomes the ghost.
    pub(crate) fn branch(&mut self) {
        if !self.course.is_scrubbed() {
            return;
        }
        self.keep_ghost(self.course.rows_until_shown());
        self.course.resume();
        self.traces.truncate(self.course.rows());
        self.note_rewritten(self.course.front());
        self.full = false;
        self.revision.parameters += 1;
        self.revision.transport += 1;
        self.frame_changed();
    }

    /// Begins again with these parameters (SI) and the model's own start, computes the run up to a time and shows its
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
                self.revision.transport += 1;
                self.announce(Announcement::Failed);
            }
        }
        if self.status() != before {
            self.revision.transport += 1;
        }
        self.frame_changed();
    }
}

/// True if a time is `end` but for rounding, as that of an event at the end can be.
fn is_at(time: f64, end: f64) -> bool {
    (end..=end * (1.0 + engine::ROUNDING)).contains(&time)
}
