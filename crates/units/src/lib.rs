//! Physical dimensions and units: parse, convert, print.

mod dimension;
mod unit;

pub use dimension::{Dimension, Exponent};
pub use unit::{Unit, UnitError};
