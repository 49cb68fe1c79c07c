//! What the session says, as values and in words.

use crate::Session;

/// Something happened that a screen reader should tell.
#[derive(Clone, Debug, PartialEq)]
pub enum Announcement {
    /// The run goes on.
    Playing,
    /// The run stands still at this time (SI).
    Paused(f64),
    /// A step was made or shown; the time now.
    Stepped(f64),
    /// An earlier time is shown.
    Scrubbed(f64),
    /// Back at the initial values.
    Reset,
    /// The run began anew because this parameter decides an initial value.
    Restarted(usize),
    /// A parameter has this SI value now.
    ParameterSet(usize, f64),
    /// All parameters have their defaults.
    ParametersReset,
    /// A preset was applied.
    Preset(usize),
    /// A state was given this SI value, and the run begins from there.
    StateSet(usize, f64),
    /// Model time passes so many times as fast as wall time.
    Speed(f64),
    /// The run was kept under this name.
    Kept(String),
    /// The kept run of this name was removed.
    Removed(String),
    /// The history is full.
    Full,
    /// The run cannot go on: see [`Session::problem`].
    Failed,
    /// The method was chosen, by its name in the engine.
    Method(&'static str),
    /// The step was set (SI).
    Step(f64),
    /// A state was restored from a link or the last visit.
    Restored,
}

/// Why input was not taken.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// There is no number in it.
    NotANumber {
        /// What was typed.
        typed: String,
    },
    /// The unit is unknown.
    UnknownUnit {
        /// The unit typed.
        typed: String,
    },
    /// The unit measures something else.
    WrongUnit {
        /// The unit typed.
        typed: String,
        /// A unit that would do.
        expected: String,
    },
    /// The value is below the least allowed one.
    TooSmall {
        /// The name of what was to be set.
        name: String,
        /// The least value, with its unit.
        least: String,
    },
    /// The value is above the greatest allowed one.
    TooLarge {
        /// The name of what was to be set.
        name: String,
        /// The greatest value, with its unit.
        greatest: String,
    },
    /// The value is not finite: an expression of a preset has no value here.
    NoValue {
        /// The name of what was to be set.
        name: String,
    },
    /// It must be greater than zero.
    NotPositive,
    /// The state can be set only while the run is paused.
    NotPaused,
    /// The method cannot integrate this model; why, from the engine.
    Method {
        /// The reason, for people.
        reason: String,
    },
    /// No more runs can be kept.
    TooManyRuns {
        /// How many there may be.
        most: usize,
    },
    /// Nothing of that number or name exists.
    Unknown {
        /// What was asked for.
        name: String,
    },
    /// A saved state was not written by this program, or for another version of it.
    UnreadableState,
    /// Parts of a saved state do not fit this document and were left out.
    PartlyRestored {
        /// Which.
        left_out: Vec<String>,
    },
}

impl Session {
    /// The next thing to tell, oldest first.
    pub fn take_announcement(&mut self) -> Option<Announcement> {
        None
    }

    /// An announcement in the session's language.
    pub fn announcement_text(&self, announcement: &Announcement) -> String {
        format!("{announcement:?}")
    }

    /// A refusal in the session's language.
    pub fn refusal_text(&self, refusal: &Refusal) -> String {
        format!("{refusal:?}")
    }
}
