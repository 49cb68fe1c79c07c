//! An oscillation, cycle by cycle, before any theory.

mod constancy;
mod cycle;
mod damped;
mod estimate;
mod lobes;
mod quantity;
mod rows;
mod shape;
mod sinusoids;

pub use constancy::{Constancy, mean};
pub use cycle::{Cycle, Measured};
pub use estimate::{Estimate, estimate};
pub use quantity::{Quantity, columns, well_known};
pub use sinusoids::{Cycles, cycles};
