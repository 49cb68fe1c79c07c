//! An oscillation cycle by cycle.

pub(crate) mod plot;
pub(crate) mod view;

pub use view::{CycleColumn, CyclesView};
