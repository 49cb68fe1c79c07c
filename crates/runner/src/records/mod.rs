//! Measured data: their columns, units and independent variables.

mod columns;
mod limits;
mod measured;
mod variable;

pub use columns::{columns_as_json, columns_as_text};
pub use limits::{limits, nothing_between};
pub use measured::{MOST_BYTES, Measured, bounded, measured, too_large};
pub use variable::{Stated, find};
