//! Analysis of an oscillation cycle by cycle.

pub(crate) mod drawn;
pub(crate) mod found;
mod plot;
mod view;

pub use view::{CycleColumn, CyclesView};
