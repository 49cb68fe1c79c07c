//! Announcements of events for screen readers and the status line.

use crate::fits::NothingFound;
use play::Prominence;
use std::collections::VecDeque;

/// An event to be announced by a screen reader.
#[derive(Clone, Debug, PartialEq)]
pub enum Announcement {
    /// An event of the simulation itself.
    Play(play::Announcement),
    /// The record of this name was read.
    RecordAdded(String),
    /// The open film has been tracked; the text says which bodies were lost, empty if none was.
    FilmTracked(String),
    /// Reading the file of this name was cancelled.
    RecordCancelled(String),
    /// Velocity and acceleration were computed from a column of the record of this name.
    DerivativesMade(String),
    /// A row was left out of fits, or taken back (`counts`).
    RowLeftOut {
        /// Name of the record.
        record: String,
        /// Number of the row, from 1.
        row: usize,
        /// True if the row counts again.
        counts: bool,
    },
    /// The record of this name was removed.
    RecordRemoved(String),
    /// The fit of the theory of this title was removed.
    FitRemoved(String),
    /// The fit, or the last of several, is finished. If the result is doubtful: the reason why it was not applied to
    /// the sliders.
    FitFinished(Option<String>),
    /// Theories that could not be fitted, each with the reason, in one text.
    TheoriesLeftOut(String),
    /// The fit ended without a result.
    FitFailed(NothingFound),
    /// The fit was cancelled.
    FitCancelled,
    /// The fitted values were set on the sliders. After a fit of several records: the name of the record whose values
    /// were set, otherwise empty.
    FitApplied(String),
}

impl Announcement {
    /// Prominence of the announcement on the page.
    pub fn prominence(&self) -> Prominence {
        match self {
            Self::Play(announcement) => announcement.prominence(),
            // The plot and the number of rows beside the button show it.
            Self::RowLeftOut { .. } => Prominence::Spoken,
            Self::FitFailed(_) | Self::TheoriesLeftOut(_) => Prominence::Error,
            _ => Prominence::Shown,
        }
    }

    /// True if [`crate::Desk::undo`] can undo the event.
    pub fn can_be_undone(&self) -> bool {
        match self {
            Self::Play(announcement) => announcement.can_be_undone(),
            other => matches!(other, Self::RecordRemoved(_) | Self::FitRemoved(_)),
        }
    }
}

/// Capacity of the queue of announcements.
const MOST: usize = 16;

/// Queue of announcements that have not been taken yet.
#[derive(Debug, Default)]
pub(crate) struct Announcements(VecDeque<Announcement>);

impl Announcements {
    /// Adds an announcement. Drops the oldest one if the queue is full.
    pub fn push(&mut self, announcement: Announcement) {
        if self.0.len() == MOST {
            self.0.pop_front();
        }
        self.0.push_back(announcement);
    }

    /// Takes the oldest announcement.
    pub fn take(&mut self) -> Option<Announcement> {
        self.0.pop_front()
    }

    /// Drops all announcements that have not been taken.
    pub fn clear(&mut self) {
        self.0.clear();
    }
}
