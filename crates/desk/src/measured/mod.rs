//! Measured values beside the simulation's: points over curves, residuals, and the outline in the scene.

pub(crate) mod data;
mod outline;
mod points;
mod residuals;
