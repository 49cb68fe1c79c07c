//! Physical dimensions and units: parse, convert, print. And what every crate needs to speak: the [languages](Language), and the
//! one writer of [numbers](number) for people. Numbers that look random are there, too ([`split_mix`]).

pub mod alphabet;
mod dimension;
mod exponent;
mod language;
pub mod markup;
pub mod mathml;
mod nearest;
pub mod number;
mod parse;
mod prefix;
mod quantity;
mod scale;
pub mod split_mix;
mod table;
mod unit;
mod unit_error;

pub use dimension::Dimension;
pub use exponent::Exponent;
pub use language::{Language, Words, sentence, words};
pub use nearest::nearest;
pub use parse::raised;
pub use quantity::QuantityName;
pub use unit::Unit;
pub use unit_error::UnitError;
