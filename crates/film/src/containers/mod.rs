//! Film containers: offset, coding and presentation time of each frame. MP4, QuickTime, WebM, Matroska and AVI.
//!
//! No existing crate fits. `re_mp4`, `mp4` and `matroska-demuxer` need random access to the file, which a browser does
//! not give, read headers of any size into memory, and together are larger than this code (0.1 MB gzipped). No pictures
//! are read: [`Opening`] asks only for headers, so that a film of two gigabytes opens as quickly as a small one.
//!
//! [`Opening`] is a state machine without I/O: it asks for ranges of the file, and the page answers with `File.slice`, the
//! command line with a seek. Each format has a `Reader` that takes one box, element or chunk at a time and changes nothing
//! until all bytes of it are at hand, so that it can be called again after a request. MP4 reads `moov` and `moof` whole;
//! Matroska and AVI without an index walk their blocks by the headers.

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
