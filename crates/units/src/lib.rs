//! Physical dimensions and units: parsing, conversion, printing. The crate also has the [languages](Language) of the
//! interface, the formatting of [numbers](number) for readers, and pseudorandom numbers ([`split_mix`]).

pub mod alphabet;
mod dimension;
mod exponent;
pub mod fnv;
// The macros of `wording` name this crate.
extern crate self as units;

mod language;
pub mod markup;
pub mod mathml;
mod name;
mod nearest;
pub mod number;
pub mod order;
mod parse;
mod percent;
mod prefix;
mod quantity;
mod scale;
pub mod split_mix;
mod table;
mod turns;
mod unit;
mod unit_error;

pub use dimension::Dimension;
pub use exponent::Exponent;
pub use language::{Catalogue, Conjunction, Language, ToWords, Words, provide, sentence, words};
pub use name::name_of;
pub use nearest::nearest;
pub use parse::raised;
pub use percent::percent_encoded;
pub use quantity::QuantityName;
pub use unit::Unit;
pub use unit_error::UnitError;
pub use wording::{say, words};
