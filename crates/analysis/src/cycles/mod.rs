//! Analysis of an oscillation cycle by cycle, without a theory.

mod constancy;
mod cut_off;
mod cycle;
pub(crate) mod damped;
mod drift;
mod estimate;
mod lobes;
mod quantity;
mod record;
mod rows;
mod shape;
mod sinusoids;
mod words;

pub use constancy::{Constancy, mean};
pub use cut_off::CutOff;
pub use cycle::{Cycle, Measured};
pub use drift::Drift;
pub use estimate::{Estimate, estimate};
pub use quantity::{Quantity, columns, well_known};
pub(crate) use record::is_white_noise;
pub use record::{Cycles, NoCycles, cycles};
pub use words::Writing;
