//! An oscillation, cycle by cycle, before any theory.

mod cycle;
mod damped;
mod estimate;
mod lobes;

pub use cycle::{Cycle, Cycles, Measured, cycles};
pub use estimate::{Estimate, estimate};
pub(crate) use lobes::median;
