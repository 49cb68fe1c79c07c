//! The run, its time line and its clock.

pub(crate) mod course;
mod problem;
pub(crate) mod recipe;
pub(crate) mod transport;

pub use course::Course;
pub use problem::Problem;
pub use transport::{LONGEST_GAP, SPEEDS, Status, WORK_PER_TICK};
