//! Pictures of a film, decoded by the browser.

pub mod codecs;
mod decoder;
mod picture;
mod player;
mod source;
mod trouble;

pub use decoder::Reader;
pub use picture::{Greys, drawn};
pub use player::Player;
pub use source::{Source, object};
pub use trouble::Trouble;
