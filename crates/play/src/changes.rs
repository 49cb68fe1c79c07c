//! Parts of the state that an operation has changed, and the counters made of them.

use std::ops::{BitOr, BitOrAssign};

/// Parts of the state that an operation has changed. The owner of the part folds them into its [`Revision`].
#[must_use]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changes(u16);

impl Changes {
    /// Nothing has changed.
    pub const NONE: Self = Self(0);
    /// Time or state shown: scene, readouts, plots, table.
    pub const FRAME: Self = Self(1);
    /// Parameters, method, step.
    pub const PARAMETERS: Self = Self(1 << 1);
    /// Status, speed, problem.
    pub const TRANSPORT: Self = Self(1 << 2);
    /// Rows recorded or discarded.
    pub const ROWS: Self = Self(1 << 3);
    /// Kept runs and ghost.
    pub const RUNS: Self = Self(1 << 4);
    /// Visibility, zoom and content of plots.
    pub const PLOTS: Self = Self(1 << 5);
    /// Answers to questions.
    pub const ANSWERS: Self = Self(1 << 6);
    /// Results of the author's claims.
    pub const CLAIMS: Self = Self(1 << 7);
    /// Language.
    pub const LANGUAGE: Self = Self(1 << 8);
    /// Answers to the survey.
    pub const SURVEY: Self = Self(1 << 9);
    /// All parts.
    pub const ALL: Self = Self((1 << 10) - 1);

    /// True if both have a part in common.
    pub(crate) fn touch(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// These changes if `changed`, otherwise none.
    pub fn only_if(self, changed: bool) -> Self {
        if changed { self } else { Self::NONE }
    }
}

impl BitOr for Changes {
    type Output = Self;

    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl BitOrAssign for Changes {
    fn bitor_assign(&mut self, other: Self) {
        *self = *self | other;
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
    pub(crate) fn after(self, changes: Changes) -> Self {
        let next = |count: u64, part: Changes| count + u64::from(changes.touch(part));
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
