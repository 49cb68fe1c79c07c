//! Physical dimensions and units: parse, convert, print.

mod dimension;
mod exponent;
mod parse;
mod quantity;
mod scale;
mod table;
mod unit;

pub use dimension::Dimension;
pub use exponent::Exponent;
pub use parse::raised;
pub use unit::{Unit, UnitError};
