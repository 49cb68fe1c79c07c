//! Films of experiments: containers, frame times, tracking and calibration.
//!
//! No pictures are decoded here. A browser or `ffmpeg` supplies each frame as a [`Plane`] of grey values, perhaps with
//! colours, with its presentation time.
//!
//! | module | content |
//! |---|---|
//! | [`containers`] | what a file says of its video: coding, size, orientation, offset and presentation time of each frame |
//! | [`timing`] | rate, spread, gaps and doubled times; slow motion; pictures that repeat |
//! | [`tracking`] | positions with standard errors; `tracking::Following` joins all that is followed in a film |
//! | [`calibration`], [`table`] | pixels to metres and back; tracks as columns with standard errors |
//! | [`y4m`], [`camera`] | uncompressed films; films of drawings, with exposure and noise, of which the truth is known |
//!
//! - **Invariant:** the time of a frame is the presentation time of the container after its edit list, as ticks over a time
//!   scale. Times are never computed from a rate, except in AVI, which has nothing else.
//! - **Invariant:** a file is treated as hostile. A table must fit into its box before it is read, at most
//!   [`containers::MOST_SAMPLES`] frames are listed, and every sample lies inside the file. Of a file that is cut off, what
//!   is there is read, with a [`containers::Notice`].
//! - **Invariant:** memory is bounded by the strips and pixels that are kept. A refusal is a value with words
//!   (`Refusal::words`), and numbers without sense lead to a refusal or a track, never to a panic.
//! - **Invariant:** work is divided into steps of about one frame, and its division changes no bit of the result.
//!
//! ```
//! use film::timing::Intervals;
//!
//! let intervals = Intervals::of(&[0.0, 0.5, 1.0, 1.5]).expect("times that differ");
//! assert!((intervals.rate - 2.0).abs() < 1e-9 && intervals.gaps.is_empty());
//! ```

pub mod calibration;
pub mod camera;
pub mod capacity;
pub mod containers;
mod plane;
pub mod table;
pub mod timing;
pub mod tracking;
pub mod y4m;

pub use plane::{Colour, Plane};
