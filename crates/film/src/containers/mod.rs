//! What a film's file says of it: where each frame is, how it is coded, when it is shown. MP4, QuickTime, WebM, Matroska and AVI.
//!
//! Own code, since none of the crates there are fits: `re_mp4`, `mp4` and `matroska-demuxer` want a file that can be read at any
//! place at once, which a browser does not give, read a header of any size into memory, and are larger together (a tenth of a
//! megabyte, gzipped) than this. Nothing here reads pictures: [`Opening`] asks for headers only, so that a film of two
//! gigabytes opens as quickly as a small one.

mod avi;
mod bytes;
mod codec;
mod error;
mod film;
mod limits;
mod matroska;
mod mp4;
mod notice;
mod opening;
mod piece;
mod signature;

pub use codec::{Codec, Coding};
pub use error::FilmError;
pub use film::{Container, Film, Orientation, Sample};
pub use limits::MOST_SAMPLES;
pub use notice::Notice;
pub use opening::{Opening, Request};
