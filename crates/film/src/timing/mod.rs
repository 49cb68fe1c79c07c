//! When the frames of a film were taken: how regular their times are, and what slow motion and converted films do to them.

mod cadence;
mod finding;
mod intervals;
mod repeats;
mod time_base;

pub use finding::Finding;
pub use intervals::{Gap, Intervals};
pub use repeats::repeats;
pub use time_base::{LARGEST_FACTOR, TimeBase, slow_motion};
