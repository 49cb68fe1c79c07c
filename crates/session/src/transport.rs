//! The clock and the transport: play, pause, step, scrub.

use crate::Session;

/// What the run is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Standing still.
    Paused,
    /// Going on with the clock.
    Playing,
    /// Standing still because the history is full; reset or scrub back to go on.
    Full,
    /// Standing still because the run cannot go on; [`Session::problem`] says why.
    Failed,
}

/// Why the run cannot go on, in the session's language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// A stable name.
    pub code: &'static str,
    /// What is wrong.
    pub message: String,
    /// What to do; may be empty.
    pub hint: String,
    /// Where in the document's source, if there is a place.
    pub span: Option<model::Span>,
}

/// The speeds that are offered.
pub const SPEEDS: [f64; 7] = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0];

impl Session {
    /// Lets `seconds` of wall time pass. Returns whether anything that is shown has changed.
    pub fn tick(&mut self, seconds: f64) -> bool {
        let _ = seconds;
        false
    }

    /// Goes on from the time shown.
    pub fn play(&mut self) {}

    /// Stands still.
    pub fn pause(&mut self) {}

    /// Plays if paused, pauses if playing.
    pub fn toggle(&mut self) {}

    /// Pauses and goes one step of the grid forward.
    pub fn step_forward(&mut self) {}

    /// Pauses and shows the time one step of the grid earlier.
    pub fn step_back(&mut self) {}

    /// Back to time 0 with the initial values of the present parameters; paused.
    pub fn reset(&mut self) {}

    /// Pauses and shows an earlier time (clamped to what is recorded).
    pub fn scrub(&mut self, time: f64) {
        let _ = time;
    }

    /// How many simulated seconds pass in one second.
    pub fn speed(&self) -> f64 {
        1.0
    }

    /// Sets the speed to the nearest of [`SPEEDS`].
    pub fn set_speed(&mut self, speed: f64) {
        let _ = speed;
    }

    /// What the run is doing.
    pub fn status(&self) -> Status {
        Status::Paused
    }

    /// Whether the run goes on with the clock.
    pub fn is_playing(&self) -> bool {
        self.status() == Status::Playing
    }

    /// The time shown (SI).
    pub fn time(&self) -> f64 {
        0.0
    }

    /// The last time that can be scrubbed to (SI): the front of the run, and where it was before scrubbing.
    pub fn end(&self) -> f64 {
        0.0
    }

    /// Whether an earlier time than the front of the run is shown.
    pub fn is_scrubbed(&self) -> bool {
        false
    }

    /// `12,35 s`: the time shown, with a steady number of decimals.
    pub fn time_text(&self) -> String {
        String::new()
    }

    /// Wall seconds by which the run has fallen behind the clock since it was last started or reset, because the
    /// machine could not compute fast enough.
    pub fn slippage(&self) -> f64 {
        0.0
    }

    /// Why the run cannot go on.
    pub fn problem(&self) -> Option<Problem> {
        None
    }
}
