//! Physical dimensions and units: parse, convert, print. And the languages in which everything is said.

mod dimension;
mod exponent;
mod language;
mod parse;
mod quantity;
mod scale;
mod table;
mod unit;

pub use dimension::Dimension;
pub use exponent::Exponent;
pub use language::{Language, Words, words};
pub use parse::raised;
pub use unit::{Unit, UnitError};
