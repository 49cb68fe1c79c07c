//! The part of a file that is at hand, and what a reader says when it needs another one.

use super::FilmError;
use super::film::Film;
use std::ops::Range;

/// Bytes of a file and where they stand in it.
#[derive(Debug, Default)]
pub(super) struct Piece {
    /// The offset of the first byte.
    pub(super) start: u64,
    /// The bytes.
    pub(super) bytes: Vec<u8>,
    /// The size of the whole file.
    pub(super) size: u64,
}

/// Why a reader stopped before the film is complete.
#[derive(Debug)]
pub(super) enum Stop {
    /// It needs these bytes.
    Need(Range<u64>),
    /// There is no film.
    Failed(FilmError),
}

impl From<FilmError> for Stop {
    fn from(error: FilmError) -> Self {
        Self::Failed(error)
    }
}

/// A reader of one format. It changes its state only when all bytes of a step were there, so that it can be called again
/// with other ones.
pub(super) trait Reader {
    /// Reads on with the bytes at hand.
    fn advance(&mut self, piece: &Piece) -> Result<Film, Stop>;
}

impl Piece {
    /// The `length` bytes at `at`, fewer only at the end of the file. If they are not at hand, this many or, if more, `ahead` are
    /// asked for.
    pub(super) fn get(&self, at: u64, length: u64, ahead: u64) -> Result<&[u8], Stop> {
        let end = at.saturating_add(length).min(self.size);
        if at >= end {
            return Ok(&[]);
        }
        let inside = at
            .checked_sub(self.start)
            .zip(end.checked_sub(self.start))
            .and_then(|(from, to)| self.bytes.get(usize::try_from(from).ok()?..usize::try_from(to).ok()?));
        inside.ok_or_else(|| Stop::Need(at..at.saturating_add(length.max(ahead)).min(self.size)))
    }
}
