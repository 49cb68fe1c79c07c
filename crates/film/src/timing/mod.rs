//! Frame times: regularity, slow motion, and repeated pictures of converted films.

mod cadence;
mod displayed;
mod finding;
mod intervals;
mod repeats;
mod time_base;

pub use displayed::{RESOLUTION, displayed};
pub use finding::Finding;
pub use intervals::{Gap, Intervals};
pub use repeats::repeats;
pub use time_base::{LARGEST_FACTOR, TimeBase, slow_motion};
