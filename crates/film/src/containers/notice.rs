//! Defects of a film file that do not prevent its use.

use super::error::size;
use units::{Words, words};

/// Defect of a film file that does not prevent its use.
#[derive(Clone, Debug, PartialEq)]
pub enum Notice {
    /// The file ends before the film does. The frames in the file were read.
    Truncated {
        /// Number of frames in the file.
        present: usize,
        /// Number of listed frames beyond the end of the file; 0 if the file has no list.
        lost: usize,
        /// Size of the file in bytes.
        bytes: u64,
    },
    /// The structure of the file is broken. The frames before that were read.
    Broken {
        /// Offset in bytes from the start of the file.
        at: u64,
    },
    /// Number of further video tracks, which are not read.
    FurtherVideos(usize),
    /// An edit list plays a part of the film at another rate. The times are those of the recording.
    Speed,
    /// The picture is to be turned by an angle that is not a multiple of 90 degrees, or skewed. It is left as it is.
    Skewed,
}

impl Notice {
    /// Message of one sentence.
    pub fn words(&self) -> Words {
        match self {
            Self::Truncated { present, lost: 0, bytes } => words!(
                "the file ends in the middle of the film: {present} frames in {} were read; if it was being copied, copy it again",
                size(*bytes)
            ),
            Self::Truncated { present, lost, bytes } => {
                let listed = present.saturating_add(*lost);
                words!(
                    "the file ends in the middle of the film: of {listed} frames, {present} are in its {} and were read; copy it again to get the others",
                    size(*bytes)
                )
            }
            Self::Broken { at } => words!("the file is damaged at byte {at}; the frames before it were read"),
            Self::FurtherVideos(1) => words("the file holds a second video, which is not read"),
            Self::FurtherVideos(count) => words!("the file holds {count} further videos, which are not read"),
            Self::Speed => {
                words("the film was edited so that a part plays faster or slower; the times are those of the recording")
            }
            Self::Skewed => {
                words("the film asks for its picture to be turned by an odd angle; it is shown as it was recorded")
            }
        }
    }
}
