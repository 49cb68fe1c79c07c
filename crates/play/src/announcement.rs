//! Short queue of announcements for screen readers and for the line of messages.

use std::collections::VecDeque;

/// An event that a screen reader announces.
#[derive(Clone, Debug, PartialEq)]
pub enum Announcement {
    /// The run is playing.
    Playing,
    /// The run is paused at this time (SI).
    Paused(f64),
    /// The run has reached the end set by the document, at this time (SI).
    Ended(f64),
    /// A step was computed or shown; see the time shown (SI).
    Stepped(f64),
    /// An earlier time (SI) is shown.
    Scrubbed(f64),
    /// The run is back at time 0. Parameters and start are unchanged.
    BackAtStart,
    /// The run restarted because an initial value depends on the parameter with this index.
    Restarted(usize),
    /// The parameter with this index has this SI value now.
    ParameterSet(usize, f64),
    /// The reader has drawn the curve with this index; the run restarts.
    Drawn(usize),
    /// The curve with this index is the document's own again; the run restarts.
    DrawingCleared(usize),
    /// The button with this index was pressed at this time (SI).
    Pressed(usize, f64),
    /// All parameters and the start are those of the document.
    DefaultsRestored,
    /// The preset with this index was applied.
    Preset(usize),
    /// The state with this index was set to this SI value; the run starts from there.
    StateSet(usize, f64),
    /// The start of a state was dragged to this SI value by changing parameters.
    StartSet {
        /// Index into [`program::Model::states`].
        state: usize,
        /// Initial value of the state, SI.
        value: f64,
        /// Parameter values before the drag, SI.
        before: Vec<f64>,
    },
    /// Playback speed, as a multiple of the document's speed.
    Speed(f64),
    /// The run was kept under this name.
    Kept(String),
    /// The kept run of this name was removed.
    Removed(String),
    /// The last removal or replacement was undone.
    Undone,
    /// The recording is full.
    Full,
    /// The run failed: see [`crate::TimeLine::problem`].
    Failed,
    /// This integration method was chosen.
    Method(engine::Method),
    /// The step was set to this value (SI).
    Step(f64),
    /// The parameters assumed by the question with this index were set.
    QuestionSetup(usize),
    /// A state was restored from a link or from the last visit.
    Restored,
    /// The assigned parameters have the values of this seat, or without one those of the document.
    Seated(Option<u32>),
    /// The sizes of families have changed. Lists what was dropped (settings, kept runs, answers), in the chosen
    /// language.
    Resized(Vec<String>),
    /// Another program replaced the former one ([`crate::Play::replace_program`]). Lists what was dropped (settings,
    /// kept runs, answers), in the chosen language.
    Replaced(Vec<String>),
}

/// Level of attention of an announcement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prominence {
    /// Spoken only: the control that was used already shows it (the clock, a slider).
    Spoken,
    /// Shown for a while.
    Shown,
    /// Shown until dismissed.
    Error,
}

impl Announcement {
    /// Returns the level of attention. Changes while a control is being moved are only spoken: the line of messages
    /// would flicker otherwise.
    pub fn prominence(&self) -> Prominence {
        match self {
            Self::Playing
            | Self::Paused(_)
            | Self::Stepped(_)
            | Self::Scrubbed(_)
            | Self::BackAtStart
            | Self::ParameterSet(..)
            | Self::Pressed(..)
            | Self::Drawn(_)
            | Self::StateSet(..)
            | Self::StartSet { .. }
            | Self::Speed(_)
            | Self::Method(_)
            | Self::Step(_)
            // The transport shows the reason.
            | Self::Ended(_)
            | Self::Full
            | Self::Failed => Prominence::Spoken,
            Self::Replaced(lost) | Self::Resized(lost) if lost.is_empty() => Prominence::Spoken,
            Self::Restarted(_)
            | Self::DefaultsRestored
            | Self::DrawingCleared(_)
            | Self::Preset(_)
            | Self::Kept(_)
            | Self::Removed(_)
            | Self::Undone
            | Self::QuestionSetup(_)
            | Self::Restored
            | Self::Seated(_)
            | Self::Resized(_)
            | Self::Replaced(_) => Prominence::Shown,
        }
    }

    /// True if [`crate::Play::undo`] can undo it.
    pub fn can_be_undone(&self) -> bool {
        matches!(
            self,
            Self::DefaultsRestored
                | Self::DrawingCleared(_)
                | Self::Preset(_)
                | Self::QuestionSetup(_)
                | Self::Removed(_)
        )
    }
}

/// Queue of pending announcements.
#[derive(Debug, Default)]
pub(crate) struct Announcements(VecDeque<Announcement>);

/// Maximum length of the queue.
const MOST: usize = 16;

impl Announcements {
    /// Adds an announcement. Consecutive announcements of one kind (a slider being moved) are merged into the last one.
    /// In a full queue it replaces the newest one.
    pub fn push(&mut self, announcement: Announcement) {
        let same = |last: &Announcement| std::mem::discriminant(last) == std::mem::discriminant(&announcement);
        if self.0.back().is_some_and(same) || self.0.len() == MOST {
            self.0.pop_back();
        }
        self.0.push_back(announcement);
    }

    /// Removes and returns the oldest announcement.
    pub fn take(&mut self) -> Option<Announcement> {
        self.0.pop_front()
    }

    /// Discards all pending announcements.
    pub fn clear(&mut self) {
        self.0.clear();
    }
}
