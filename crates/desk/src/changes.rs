//! Parts of a desk that an operation has changed, and the counters made of them.

use crate::Announcement;
use crate::removed::Removed;
use play::Outcome;
use std::ops::BitOr;

/// Parts of a desk that an operation has changed, the events to announce, and a removal that can be undone. The desk
/// folds them into its [`Revision`].
#[must_use]
#[derive(Debug, Default)]
pub struct Changes {
    /// One bit per part.
    parts: u8,
    announcements: Vec<Announcement>,
    removed: Option<Removed>,
}

impl Changes {
    /// Nothing has changed.
    pub const NONE: Self = Self::of(0);
    /// Records, and the meanings of their columns.
    pub const RECORDS: Self = Self::of(1);
    /// Fit settings, running fits and results.
    pub const FITS: Self = Self::of(1 << 1);
    /// The open film and the work on it.
    pub const FILMS: Self = Self::of(1 << 2);
    /// The column whose cycles are searched.
    pub const CYCLES: Self = Self::of(1 << 3);
    /// The quantities in the plot of the cycles.
    pub const CYCLE_PLOT: Self = Self::of(1 << 4);

    const fn of(parts: u8) -> Self {
        Self { parts, announcements: Vec::new(), removed: None }
    }

    /// True if both have a part in common.
    pub(crate) fn touch(&self, other: &Self) -> bool {
        self.parts & other.parts != 0
    }

    /// These changes if `changed`, otherwise none.
    pub(crate) fn only_if(self, changed: bool) -> Self {
        if changed { self } else { Self::NONE }
    }

    /// These changes with an event to announce.
    pub(crate) fn announcing(mut self, announcement: Announcement) -> Self {
        self.announcements.push(announcement);
        self
    }

    /// These changes with a removal that can be undone.
    pub(crate) fn removing(mut self, removed: Removed) -> Self {
        self.removed = Some(removed);
        self
    }

    /// Splits off the events to announce and the removal.
    pub(crate) fn take_events(&mut self) -> (Vec<Announcement>, Option<Removed>) {
        (std::mem::take(&mut self.announcements), self.removed.take())
    }
}

impl BitOr for Changes {
    type Output = Self;

    fn bitor(mut self, other: Self) -> Self {
        self.parts |= other.parts;
        self.announcements.extend(other.announcements);
        self.removed = other.removed.or(self.removed);
        self
    }
}

impl Outcome<Self> for Changes {
    type Value = ();

    fn split(self) -> (Self, ()) {
        (self, ())
    }
}

/// Counters of changes, so that the page redraws only what has changed. See [`Changes`] for the parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Revision {
    /// Changes of the simulation.
    pub play: play::Revision,
    /// [`Changes::RECORDS`].
    pub records: u64,
    /// [`Changes::FITS`].
    pub fits: u64,
    /// [`Changes::FILMS`].
    pub films: u64,
}

impl Revision {
    /// Copy with the counters of these changes raised by one.
    pub(crate) fn after(self, changes: &Changes) -> Self {
        let next = |count: u64, part: Changes| count + u64::from(changes.touch(&part));
        Self {
            play: self.play,
            records: next(self.records, Changes::RECORDS),
            fits: next(self.fits, Changes::FITS),
            films: next(self.films, Changes::FILMS),
        }
    }
}
