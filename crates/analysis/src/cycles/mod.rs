//! An oscillation, cycle by cycle, before any theory.

mod damped;
mod estimate;
mod lobes;

pub use estimate::{Estimate, estimate};
pub(crate) use lobes::median;
