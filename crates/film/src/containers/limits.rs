//! Upper bounds on the amount of data read from a file.

/// Maximum number of frames: nine hours at 60 frames per second.
pub const MOST_SAMPLES: usize = 2_000_000;
/// Maximum size of a table in bytes: enough for `MOST_SAMPLES` frames with all fields of MP4.
pub(super) const MOST_TABLE: u64 = 96 << 20;
/// Maximum number of parts at the outermost level: MP4 boxes, Matroska elements, AVI chunks. A Matroska frame has
/// several.
pub(super) const MOST_PARTS: usize = 16_000_000;
