//! An oscillation, cycle by cycle, before any theory.

mod constancy;
mod cycle;
mod damped;
mod estimate;
mod lobes;
mod quantity;
mod rows;
mod shape;

pub use constancy::{Constancy, mean};
pub use cycle::{Cycle, Cycles, Measured, cycles};
pub use estimate::{Estimate, estimate};
pub(crate) use lobes::median;
pub use quantity::{Quantity, columns, well_known};
