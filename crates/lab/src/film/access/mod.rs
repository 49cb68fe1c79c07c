//! Pictures of a film, decoded by the browser.
//!
//! `Source` reads the file in ranges, `Reader` feeds WebCodecs (one decoder on the main thread, pictures known by their time
//! stamp, closed at once), `Greys` turns a picture into a `film::Plane`, `Player` shows single frames.

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
