//! Parts of the state that an operation has changed, and the counters made of them.

use crate::Announcement;
use crate::removed::Removed;
use std::ops::{BitOr, BitOrAssign};

/// Parts of the state that an operation has changed, the events to announce, and a removal that can be undone. The owner
/// of the part folds them into its [`Revision`].
#[must_use]
#[derive(Debug, Default)]
pub struct Changes {
    /// One bit per part.
    parts: u16,
    announcements: Vec<Announcement>,
    removed: Option<Removed>,
}

impl Changes {
    /// Nothing has changed.
    pub const NONE: Self = Self::of(0);
    /// Time or state shown: scene, readouts, plots, table.
    pub const FRAME: Self = Self::of(1);
    /// Parameters, method, step.
    pub const PARAMETERS: Self = Self::of(1 << 1);
    /// Status, speed, problem.
    pub const TRANSPORT: Self = Self::of(1 << 2);
    /// Rows recorded or discarded.
    pub const ROWS: Self = Self::of(1 << 3);
    /// Kept runs and ghost.
    pub const RUNS: Self = Self::of(1 << 4);
    /// Visibility, zoom and content of plots.
    pub const PLOTS: Self = Self::of(1 << 5);
    /// Answers to questions.
    pub const ANSWERS: Self = Self::of(1 << 6);
    /// Results of the author's claims.
    pub const CLAIMS: Self = Self::of(1 << 7);
    /// Language.
    pub const LANGUAGE: Self = Self::of(1 << 8);
    /// Answers to the survey.
    pub const SURVEY: Self = Self::of(1 << 9);
    /// All parts.
    pub const ALL: Self = Self::of((1 << 10) - 1);
    /// Another run has replaced the present one.
    pub(crate) const NEW_RUN: Self = Self::of(1 << 10);
    /// The part of the scene that is dragged is released.
    pub(crate) const RELEASED: Self = Self::of(1 << 11);
    /// Nothing was overwritten, and the user would not expect an older removal to be undone now.
    pub(crate) const SETTLED: Self = Self::of(1 << 12);

    const fn of(parts: u16) -> Self {
        Self { parts, announcements: Vec::new(), removed: None }
    }

    /// True if both have a part in common.
    pub(crate) fn touch(&self, other: &Self) -> bool {
        self.parts & other.parts != 0
    }

    /// These changes if `changed`, otherwise none.
    pub fn only_if(self, changed: bool) -> Self {
        if changed { self } else { Self::NONE }
    }

    /// These changes except for some parts.
    pub(crate) fn without(mut self, parts: &Self) -> Self {
        self.parts &= !parts.parts;
        self
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
        self |= other;
        self
    }
}

impl BitOrAssign for Changes {
    fn bitor_assign(&mut self, other: Self) {
        self.parts |= other.parts;
        self.announcements.extend(other.announcements);
        self.removed = other.removed.or(self.removed.take());
    }
}

/// Result of an operation on a part: its changes, which are of the type `C`, and the value for the caller. An operation that
/// is refused changes nothing. The default of `C` is no change.
pub trait Outcome<C> {
    /// Value for the caller.
    type Value;

    /// Splits the result.
    fn split(self) -> (C, Self::Value);
}

impl Outcome<Self> for Changes {
    type Value = ();

    fn split(self) -> (Self, ()) {
        (self, ())
    }
}

impl<T, C> Outcome<C> for (T, C) {
    type Value = T;

    fn split(self) -> (C, T) {
        (self.1, self.0)
    }
}

impl<C: Default, O: Outcome<C>, E> Outcome<C> for Result<O, E> {
    type Value = Result<O::Value, E>;

    fn split(self) -> (C, Self::Value) {
        match self.map(O::split) {
            Ok((changes, value)) => (changes, Ok(value)),
            Err(error) => (C::default(), Err(error)),
        }
    }
}

/// Change counters, so that the shell redraws only what has changed. See [`Changes`] for the parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Revision {
    /// [`Changes::FRAME`].
    pub frame: u64,
    /// [`Changes::PARAMETERS`].
    pub parameters: u64,
    /// [`Changes::TRANSPORT`].
    pub transport: u64,
    /// [`Changes::ROWS`].
    pub rows: u64,
    /// [`Changes::RUNS`].
    pub runs: u64,
    /// [`Changes::PLOTS`].
    pub plots: u64,
    /// [`Changes::ANSWERS`].
    pub answers: u64,
    /// [`Changes::CLAIMS`].
    pub claims: u64,
    /// [`Changes::LANGUAGE`].
    pub language: u64,
    /// [`Changes::SURVEY`].
    pub survey: u64,
}

impl Revision {
    /// Copy with the counters of these changes raised by one.
    pub(crate) fn after(self, changes: &Changes) -> Self {
        let next = |count: u64, part: Changes| count + u64::from(changes.touch(&part));
        Self {
            frame: next(self.frame, Changes::FRAME),
            parameters: next(self.parameters, Changes::PARAMETERS),
            transport: next(self.transport, Changes::TRANSPORT),
            rows: next(self.rows, Changes::ROWS),
            runs: next(self.runs, Changes::RUNS),
            plots: next(self.plots, Changes::PLOTS),
            answers: next(self.answers, Changes::ANSWERS),
            claims: next(self.claims, Changes::CLAIMS),
            language: next(self.language, Changes::LANGUAGE),
            survey: next(self.survey, Changes::SURVEY),
        }
    }
}
