//! Films of experiments: containers, frame times, tracking and calibration.
//!
//! No pictures are decoded here. A browser or `ffmpeg` supplies each frame as a [`Plane`] of grey values with its
//! presentation time.

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
