//! Measured values beside the simulation's: points over curves, residuals, and the outline in the scene.

mod curves;
pub(crate) mod data;
mod outline;
mod points;
mod residuals;
mod theory;

pub use curves::{CurveAxis, FittedCurve, MeasuredCurve};
pub use theory::TheoryCurve;
