//! Operations on the time line and their announcements: play, pause, step, scrub, keep runs.

use super::removed::Removed;
use crate::time::course::Outcome;
use crate::{Announcement, Changes, Play, Refusal, WORK_PER_TICK, words};
use engine::Setup;

/// Maximum work for a single step by the user: less than half a second.
const WORK_PER_STEP: u64 = 50_000_000;

impl Play {
    /// Advances by `seconds` of wall time. Returns true if anything shown has changed.
    pub fn tick(&mut self, seconds: f64) -> bool {
        let Some(to) = self.line.due(seconds) else { return false };
        let end = self.end_ahead().filter(|end| *end <= to);
        let proceeded = self.line.proceed(&self.basis, end.unwrap_or(to), WORK_PER_TICK);
        self.proceeded(proceeded);
        if self.line.is_playing() && end.is_some_and(|end| self.course().time() >= end) {
            self.stop();
            self.announce(Announcement::Ended(self.course().time()));
        }
        true
    }

    /// Plays from the time shown. After scrubbing, the later rows are discarded and become the ghost.
    pub fn play(&mut self) {
        if self.line.is_playing() {
            return;
        }
        self.controls.hold(None);
        self.branch();
        let changes = self.line.play();
        self.note(changes);
        self.announce(if self.line.is_playing() {
            Announcement::Playing
        } else if self.line.is_full() {
            Announcement::Full
        } else {
            Announcement::Failed
        });
    }

    /// Pauses the run.
    pub fn pause(&mut self) {
        if self.line.is_playing() {
            self.stop();
            self.announce(Announcement::Paused(self.course().time()));
        }
    }

    /// Toggles between playing and paused.
    pub fn toggle(&mut self) {
        if self.line.is_playing() {
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
        self.step_on();
        self.announce(Announcement::Stepped(self.course().time()));
    }

    /// Pauses and shows the previous grid time.
    pub fn step_back(&mut self) {
        self.stop();
        self.show(self.course().previous_grid_time());
        self.announce(Announcement::Stepped(self.course().time()));
    }

    /// Restarts at time 0 with the present parameters, paused. A start set by hand stays ([`Play::restore_defaults`]
    /// discards it); the ghost is removed.
    pub fn back_to_start(&mut self) {
        self.stop();
        self.controls.hold(None);
        self.restart(self.setup());
        self.clear_ghost();
        self.announce(Announcement::BackAtStart);
    }

    /// Pauses and shows a recorded time (SI), clamped to the recording.
    pub fn scrub(&mut self, time: f64) {
        self.stop();
        self.show(time);
        self.announce(Announcement::Scrubbed(self.course().time()));
    }

    /// Computes one grid step towards a time (SI), from the end of the recording and without an announcement. Used when
    /// something other than the transport, such as a film, controls the time. Returns true if more remains to be
    /// computed; false while the run plays.
    pub fn compute_on(&mut self, until: f64) -> bool {
        let before = self.course().front();
        let is_stopped = self.line.is_playing() || self.line.is_full() || self.course().error().is_some();
        if is_stopped || before >= until {
            return false;
        }
        self.show(before);
        self.step_on();
        self.course().front() > before
    }

    /// Shows a recorded time (SI) without an announcement, unless the run plays.
    pub fn show_time(&mut self, time: f64) {
        let time = time.clamp(0.0, self.course().front());
        if !self.line.is_playing() && self.course().time() != time {
            self.show(time);
        }
    }

    /// Sets the playback speed to the nearest of [`SPEEDS`](crate::SPEEDS).
    pub fn set_speed(&mut self, speed: f64) {
        let changes = self.line.set_speed(speed);
        self.note(changes);
        if changes != Changes::NONE {
            self.announce(Announcement::Speed(self.line.speed()));
        }
    }

    /// Restarts with these parameters (SI) and the model's own start, computes the run up to a time (SI) and shows its
    /// beginning.
    pub fn run_through(&mut self, parameters: Vec<f64>, to: f64) {
        self.stop();
        self.restart(Setup { parameters, start: None, ..self.course().begun().clone() });
        self.clear_ghost();
        let proceeded = self.line.proceed(&self.basis, to, WORK_PER_STEP);
        self.proceeded(proceeded);
        self.show(0.0);
    }

    /// Keeps the present run; it is drawn behind later ones.
    pub fn keep(&mut self) -> Result<(), Refusal> {
        self.follow();
        let changes = self.line.keep()?;
        self.note(changes);
        let name = self.line.kept(&self.basis).pop().map(|kept| kept.name).unwrap_or_default();
        self.announce(Announcement::Kept(name));
        Ok(())
    }

    /// Shows or hides a kept run.
    pub fn show_kept(&mut self, id: u32, shown: bool) {
        let changes = self.line.show_kept(id, shown);
        self.note(changes);
    }

    /// Removes a kept run; can be undone.
    pub fn remove_kept(&mut self, id: u32) {
        let Some(view) = self.line.kept(&self.basis).into_iter().find(|view| view.id == id) else { return };
        if let Some((place, kept)) = self.line.take_kept(id) {
            self.can_undo(Removed::Run(place, kept));
        }
        self.note(Changes::RUNS);
        self.announce(Announcement::Removed(view.name));
    }

    /// Removes the ghost at the user's request; can be undone.
    pub fn remove_ghost(&mut self) {
        if let Some(ghost) = self.line.take_ghost() {
            self.can_undo(Removed::Ghost(ghost));
            self.note(Changes::RUNS);
            self.announce(Announcement::Removed(words::previous_run(self.language()).to_owned()));
        }
    }

    /// Removes the ghost; cannot be undone.
    pub fn clear_ghost(&mut self) {
        let removed = self.line.take_ghost();
        self.note(Changes::RUNS.only_if(removed.is_some()));
    }

    /// Turns all rows into the ghost, if there are enough to be seen.
    pub(super) fn keep_ghost(&mut self) {
        self.follow();
        let changes = self.line.keep_ghost(0);
        self.note(changes);
    }

    /// Makes the moment shown the front of the run; rows recorded after it become the ghost.
    pub(super) fn branch(&mut self) {
        if self.course().is_scrubbed() {
            self.follow();
            let changes = self.line.branch();
            self.note(changes);
        }
    }

    pub(super) fn stop(&mut self) {
        let changes = self.line.stop();
        self.note(changes);
    }

    fn show(&mut self, time: f64) {
        self.follow();
        let changes = self.line.show(time);
        self.note(changes);
    }

    /// End of the run set by the document (SI), if it is still ahead.
    fn end_ahead(&self) -> Option<f64> {
        self.program().until.filter(|end| *end > self.course().time())
    }

    /// Advances to the next grid time, beyond an event that ended the run.
    fn step_on(&mut self) {
        let to = self.course().next_grid_time();
        let to = self.end_ahead().map_or(to, |end| to.min(end));
        let proceeded = self.line.go_on(&self.basis, to, WORK_PER_STEP);
        self.proceeded(proceeded);
    }

    fn proceeded(&mut self, (outcome, changes): (Outcome, Changes)) {
        self.note(changes);
        match outcome {
            Outcome::Reached | Outcome::Behind(_) => {}
            Outcome::Full => self.announce(Announcement::Full),
            Outcome::Failed => self.announce(Announcement::Failed),
        }
    }
}
