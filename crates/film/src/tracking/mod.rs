//! Positions of surfaces and bodies in each frame.
//!
//! [`Following`] joins all that is followed in a film, asks for frames and leaves out repeated ones, whose clicks then belong
//! to the frame before. [`Marks`] finds how the camera moves; positions are corrected by it, and pixels are not. `errors.rs`
//! scales the formal errors to the scatter of the sixth differences. `readout.rs` finds the readout time of a rolling shutter
//! from an oscillation. `doubt.rs` has the doubts of two tracks at one place. `smooth.rs` tells where the neighbours of a
//! point lead, also at a bounce.

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
