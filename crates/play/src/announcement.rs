//! What happened, for screen readers: a short queue.

use std::collections::VecDeque;

/// Something happened that a screen reader should tell.
#[derive(Clone, Debug, PartialEq)]
pub enum Announcement {
    /// The run goes on.
    Playing,
    /// The run stands still at this time (SI).
    Paused(f64),
    /// The run has come to the end that the document gives it, at this time (SI).
    Ended(f64),
    /// A step was made or shown; the time now.
    Stepped(f64),
    /// An earlier time is shown.
    Scrubbed(f64),
    /// Back at time 0, with the parameters and the start as they are.
    BackAtStart,
    /// The run restarted because an initial value depends on this parameter.
    Restarted(usize),
    /// A parameter has this SI value now.
    ParameterSet(usize, f64),
    /// The reader has drawn this curve, and the run starts again.
    Drawn(usize),
    /// This curve is the document's own again, and the run starts again.
    DrawingCleared(usize),
    /// A button of the document was pressed at this time (SI).
    Pressed(usize, f64),
    /// All parameters and the start are the document's.
    DefaultsRestored,
    /// A preset was applied.
    Preset(usize),
    /// A state was given this SI value, and the run begins from there.
    StateSet(usize, f64),
    /// The start of a state was dragged to this SI value by changing parameters.
    StartSet {
        /// Which of [`program::Model::states`].
        state: usize,
        /// Its value at the start, SI.
        value: f64,
        /// The parameters before, SI.
        before: Vec<f64>,
    },
    /// The run is watched so many times as fast as the document says.
    Speed(f64),
    /// The run was kept under this name.
    Kept(String),
    /// The kept run of this name was removed.
    Removed(String),
    /// What was removed or overwritten last is back.
    Undone,
    /// The history is full.
    Full,
    /// The run cannot go on: see [`crate::Play::problem`].
    Failed,
    /// The method was chosen.
    Method(engine::Method),
    /// The step was set (SI).
    Step(f64),
    /// The parameters that question supposes were set.
    QuestionSetup(usize),
    /// A state was restored from a link or the last visit.
    Restored,
    /// Families have another size; what did not fit was dropped: what was set, kept or answered, in the chosen language.
    Resized(Vec<String>),
    /// Another program has taken the place of the former one ([`crate::Play::replace_program`]); what did not fit was
    /// dropped: what was set, kept or answered, in the chosen language.
    Replaced(Vec<String>),
}

/// How much attention an announcement asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prominence {
    /// The control that was used shows it already (the clock, a slider): it is only spoken.
    Spoken,
    /// It is shown for a while.
    Shown,
    /// It is shown until it is dismissed.
    Error,
}

impl Announcement {
    /// Whether it is shown besides being spoken. What changes while a control is being moved is not shown: the line of
    /// messages would flicker.
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
            // The transport shows why the run does not go on.
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
            | Self::Resized(_)
            | Self::Replaced(_) => Prominence::Shown,
        }
    }

    /// Whether [`crate::Play::undo`] takes it back.
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

/// Announcements that have not been taken.
#[derive(Debug, Default)]
pub(crate) struct Announcements(VecDeque<Announcement>);

/// More of them at once would not be listened to.
const MOST: usize = 16;

impl Announcements {
    /// Adds one. Of several of one kind in a row (a slider being moved) only the last is worth telling.
    pub fn push(&mut self, announcement: Announcement) {
        let same = |last: &Announcement| std::mem::discriminant(last) == std::mem::discriminant(&announcement);
        if self.0.back().is_some_and(same) || self.0.len() == MOST {
            self.0.pop_back();
        }
        self.0.push_back(announcement);
    }

    /// Takes the oldest one.
    pub fn take(&mut self) -> Option<Announcement> {
        self.0.pop_front()
    }

    /// Forgets those that have not been taken.
    pub fn clear(&mut self) {
        self.0.clear();
    }
}
