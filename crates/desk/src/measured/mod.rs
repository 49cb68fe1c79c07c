//! Measured values beside the simulation's: points over curves, residuals, and the outline in the scene.

mod curves;
pub(crate) mod data;
mod outline;
mod points;
mod residuals;

pub use curves::{CurveAxis, FittedCurve, MeasuredCurve};
