//! What is read at most of a file, whatever it says.

/// A film that has more frames is refused: nine hours at 60 a second.
pub const MOST_SAMPLES: usize = 2_000_000;
/// Bytes of a table of frames: enough for `MOST_SAMPLES` with all that MP4 can say of each.
pub(super) const MOST_TABLE: u64 = 96 << 20;
/// Parts of a file at its outermost level: boxes of MP4, elements of Matroska, chunks of AVI. A frame of Matroska has a few.
pub(super) const MOST_PARTS: usize = 16_000_000;
