//! Physical dimensions and units, numbers as people read and type them, and texts in every language of the interface.
//!
//! | module or type | content |
//! |---|---|
//! | [`Unit`], [`Dimension`] | units with prefixes; seven rational exponents and that of the pixel |
//! | [`number`] | formatting of numbers for readers, parsing of typed numbers; its first lines state the rules |
//! | [`Language`], [`Words`] | the languages, and a message in all of them |
//! | [`alphabet`], [`nearest()`], [`percent_encoded`] | Greek letters, primes and capitals; "did you mean"; names in addresses |
//! | [`markup`], [`mathml`] | escaping for HTML and XML; MathML of names, numbers and units |
//! | [`order`], [`fnv`], [`split_mix`] | medians, the hash FNV-1a and the generator SplitMix64, once for all crates |
//!
//! Hertz count cycles and `rad/s` angles, in one dimension. Where a number stated in the one is taken for a quantity stated
//! in the other, [`Unit::to_si_of`] or [`Unit::turning`] converts it; `model::turned` does so in expressions.
//!
//! - **Invariant:** no equations. A scale is a quotient of exact numbers as long as possible, so that 40 cm is exactly 0.4 m.
//! - **Invariant:** numbers for people are written by [`number`] alone. [`number::shortest`] writes them for programs and
//!   reads back as the same bits.
//!
//! ```
//! use units::number::{Style, with_error};
//! use units::Unit;
//!
//! let centimetre = Unit::parse("cm").unwrap();
//! assert_eq!(centimetre.to_si(40.0), 0.4);
//! assert_eq!(with_error(0.386_718, Some(0.003_12), Style::POINT), "0.387 ± 0.003");
//! ```

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
