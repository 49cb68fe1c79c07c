//! Available part of a file, and requests for further parts.

use super::FilmError;
use super::film::Film;
use std::ops::Range;

/// Contiguous bytes of a file.
#[derive(Debug, Default)]
pub(super) struct Piece {
    /// Offset of the first byte in the file.
    pub(super) start: u64,
    pub(super) bytes: Vec<u8>,
    /// Size of the whole file in bytes.
    pub(super) size: u64,
}

/// Reason why a reader stopped before the end of the film.
#[derive(Debug)]
pub(super) enum Stop {
    /// This byte range is needed.
    Need(Range<u64>),
    /// The film cannot be opened.
    Failed(FilmError),
}

impl From<FilmError> for Stop {
    fn from(error: FilmError) -> Self {
        Self::Failed(error)
    }
}

/// Reader of one container format. A step changes the state only if all of its bytes are available, so that it can be
/// repeated with other bytes.
pub(super) trait Reader {
    /// Reads as far as the available bytes allow.
    ///
    /// # Errors
    ///
    /// [`Stop::Need`] with the missing range, [`Stop::Failed`] if the film cannot be opened.
    fn advance(&mut self, piece: &Piece) -> Result<Film, Stop>;
}

impl Piece {
    /// Returns `length` bytes from offset `at`, fewer only at the end of the file.
    ///
    /// # Errors
    ///
    /// [`Stop::Need`] if they are not available; it requests at least `ahead` bytes.
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
