//! Films of experiments: where a film keeps its frames and when each was taken, where something is in each of them, and how
//! large it is.
//!
//! Nothing here decodes pictures. Whoever can (a browser, `ffmpeg`) hands over each frame as a [`Plane`] of grey values
//! together with its presentation time.

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
