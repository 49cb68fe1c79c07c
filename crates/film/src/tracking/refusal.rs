//! Errors of tracking.

use units::number::fixed;
use units::{Words, words};

/// Reason why a film, or one of its frames, cannot be tracked.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// A number of the settings is not finite, or a click lies outside the picture.
    Click {
        /// Coordinate to the right, px.
        x: f64,
        /// Coordinate downwards, px.
        y: f64,
    },
    /// The two points of a tube are too close together.
    Tube {
        /// Their distance, px.
        length: f64,
        /// Minimum distance, px.
        least: f64,
    },
    /// The frame differs in size from the first one.
    Size {
        /// Frame number.
        frame: usize,
    },
    /// The time of a frame is not finite, or not in order.
    Order {
        /// Frame number.
        frame: usize,
    },
    /// The film has more frames than fit into the memory of tracking.
    Long {
        /// Maximum number of frames.
        frames: usize,
    },
    /// The film has too few frames.
    Short {
        /// Minimum number of frames.
        frames: usize,
    },
    /// The clicked place shows nothing that can be tracked.
    Plain,
    /// The picture shows nothing that can be tracked within the given radius.
    PlainDisc {
        /// Given radius, px.
        radius: f64,
    },
    /// The clicked place does not exceed the noise.
    Noise {
        /// Frame number of the click.
        frame: usize,
    },
    /// The other frames show nothing that resembles the clicked place.
    Left {
        /// Frame number of the click.
        frame: usize,
    },
    /// A mark lies on a place that cannot be recognised.
    PlainMark {
        /// Number of the mark, from 1.
        number: usize,
    },
    /// A fixed mark was lost.
    Mark {
        /// Number of the mark, from 1.
        number: usize,
        /// Frame number.
        frame: usize,
    },
    /// The radius of a body is not finite, or outside the bounds.
    Radius {
        /// Minimum radius, px.
        least: f64,
        /// Maximum radius, px.
        greatest: f64,
    },
    /// Too many bodies or marks.
    Many {
        /// Maximum number.
        greatest: usize,
    },
}

impl Refusal {
    /// Message: what happened, and what to do.
    pub fn words(&self) -> Words {
        match self {
            Self::Click { x, y } => words!(
                "The point ({x}, {y}) lies outside the picture. Click inside the picture.",
                x = rounded(*x, 1),
                y = rounded(*y, 1)
            ),
            Self::Tube { length, least } => words!(
                "The two points of the tube are {length} pixels apart. Choose points at least {least} pixels apart.",
                length = rounded(*length, 1),
                least = rounded(*least, 0)
            ),
            Self::Size { frame } => words!(
                "Frame {frame} does not have the size of the first one. Cut the film there and track each part.",
                frame = counted(*frame)
            ),
            Self::Order { frame } => words!(
                "The time of frame {frame} does not follow that of the frame before it. Convert the film with ffmpeg.",
                frame = counted(*frame)
            ),
            Self::Long { frames } => {
                words!("The film is too long to be tracked at once. Choose a part of at most {frames} frames.")
            }
            Self::Short { frames } => {
                words!("Tracking needs at least {frames} frames. Choose a longer part of the film.")
            }
            Self::Plain => words("The picture is uniform at the clicked place. Click an edge that moves."),
            Self::PlainDisc { radius } => words!(
                "The picture is uniform around the clicked place, within the radius of {radius} px. Enter a larger radius, or click an edge that moves.",
                radius = rounded(*radius, 0)
            ),
            Self::Noise { frame } => words!(
                "The clicked place in frame {frame} does not stand out of the noise of the film. Click the edge of the surface.",
                frame = counted(*frame)
            ),
            Self::Left { frame } => words!(
                "The other frames do not show what was clicked in frame {frame}. Click the edge of the surface where it is sharp.",
                frame = counted(*frame)
            ),
            Self::PlainMark { number } => {
                words!("The picture is uniform at mark {number}. Choose marks with an edge on all sides, such as dots.")
            }
            Self::Mark { number, frame } => words!(
                "Mark {number} cannot be found in frame {frame}. Choose marks that stay in the picture.",
                frame = counted(*frame)
            ),
            Self::Radius { least, greatest } => words!(
                "The radius of a body must be a number from {least} to {greatest} px in this picture. Correct it, or clear it to find it around the click.",
                least = rounded(*least, 0),
                greatest = rounded(*greatest, 0)
            ),
            Self::Many { greatest } => words!("There are more than {greatest} marks. Choose at most {greatest}."),
        }
    }
}

/// Number of pixels with this many decimals.
fn rounded(pixels: f64, decimals: usize) -> Words {
    Words::each(move |language| fixed(pixels, decimals, language.style()))
}

/// Frame number for the user, from 1.
fn counted(frame: usize) -> Words {
    Words::same((frame + 1).to_string())
}
