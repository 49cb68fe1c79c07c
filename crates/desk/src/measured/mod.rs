//! Measured values beside the simulation's: points over curves, residuals, and the outline in the scene.

pub(crate) mod outline;
pub(crate) mod points;
mod residuals;
