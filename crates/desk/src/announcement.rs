//! What happened, for screen readers and the line of messages.

use play::Prominence;
use std::collections::VecDeque;

/// Something happened that a screen reader should tell.
#[derive(Clone, Debug, PartialEq)]
pub enum Announcement {
    /// What happened to the simulation itself.
    Play(play::Announcement),
    /// A record of this name was read.
    RecordAdded(String),
    /// The open film has been tracked.
    FilmTracked,
    /// A file of this name was given up before it was read.
    RecordCancelled(String),
    /// Velocity and acceleration were made of a column of this record.
    DerivativesMade(String),
    /// The record of this name was removed.
    RecordRemoved(String),
    /// The fit of this theory was removed.
    FitRemoved(String),
    /// The fit, or the last of several, is finished; why its numbers are not in the sliders, where there is a doubt about them.
    FitFinished(Option<String>),
    /// Theories that could not be fitted, each with the reason.
    TheoriesLeftOut(String),
    /// A fit has found nothing.
    FitFailed,
    /// The fit was given up.
    FitCancelled,
    /// What a fit has found stands in the sliders; of several records, what belongs to the one of this name.
    FitApplied(String),
}

impl Announcement {
    /// Whether it is shown besides being spoken.
    pub fn prominence(&self) -> Prominence {
        match self {
            Self::Play(announcement) => announcement.prominence(),
            Self::FitFailed | Self::TheoriesLeftOut(_) => Prominence::Error,
            _ => Prominence::Shown,
        }
    }

    /// Whether [`crate::Desk::undo`] takes it back.
    pub fn can_be_undone(&self) -> bool {
        match self {
            Self::Play(announcement) => announcement.can_be_undone(),
            other => matches!(other, Self::RecordRemoved(_) | Self::FitRemoved(_)),
        }
    }
}

/// No more announcements than this wait at once.
const MOST: usize = 16;

/// Announcements that have not been taken.
#[derive(Debug, Default)]
pub(crate) struct Announcements(VecDeque<Announcement>);

impl Announcements {
    /// Adds one; where too many wait, the oldest gives way.
    pub fn push(&mut self, announcement: Announcement) {
        if self.0.len() == MOST {
            self.0.pop_front();
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
