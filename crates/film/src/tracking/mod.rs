//! Positions of surfaces and bodies in each frame.

mod backdrop;
pub mod body;
pub mod column;
mod crossing;
mod doubt;
mod errors;
mod following;
mod linear;
mod loss;
mod marks;
mod median;
mod motion;
mod readout;
mod refusal;
mod similarity;
mod smooth;
mod spline;
mod track;

pub use doubt::{Doubt, DoubtfulFrame, doubts, is_plainly_in_doubt, lost_from};
pub use following::{Following, Plan, Surface};
pub use loss::{Loss, LossReason};
pub use marks::Marks;
pub use refusal::Refusal;
pub use similarity::Similarity;
pub use track::{CameraShift, Exposure, Known, Outline, Point, Readout, Track, of_several};
