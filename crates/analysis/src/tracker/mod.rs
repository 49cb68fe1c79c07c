//! Projects of Tracker, the video analysis of Open Source Physics: `.trk`, the XML of its `XMLControl`, and `.trz` or
//! `.zip`, an archive with such a file, its film and pages about it.
//!
//! The meaning of the XML, and the computation of times and coordinates, follow the source of Tracker
//! (github.com/OpenSourcePhysics/tracker, `TrackerPanel.Loader`, `PointMass.Loader`) and of its library
//! (github.com/OpenSourcePhysics/osp, `VideoClip`, `StepperClipControl`, `MovieVideo`, `ImageCoordSystem`,
//! `XMLControlElement`).
//!
//! A file is read in slices and as a stream. Memory is bounded by the size of the file or, in an archive, by its allowed
//! expansion.
//!
//! A [`Project`] has pixels, calibration and times; its table is a text that [`import`](crate::import) reads as that of a
//! sheet.

mod builder;
mod clip;
mod coordinates;
mod opening;
mod project;
mod refusal;
mod remark;
mod table;
mod wording;
mod xml_reader;

pub use clip::Clip;
pub use coordinates::{Coordinates, Placement};
pub use opening::{Opening, gathering, read};
pub use packed::Gathering;
pub use project::{Film, Mark, Mass, Missing, Opened, PackedFilm, Project};
pub use refusal::TrackerError;
pub use remark::{LeftOut, Remark};

/// Number of bytes examined at the beginning of a file.
const LOOK: usize = 4096;

/// True if a text begins like the XML of Open Source Physics, whose root is an object of a class.
pub fn is_project(start: &[u8]) -> bool {
    let start = start.get(..LOOK).unwrap_or(start);
    let start = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(start).trim_ascii_start();
    let contains = |text: &[u8]| start.windows(text.len()).any(|window| window == text);
    start.starts_with(b"<") && contains(b"<object class=\"org.opensourcephysics.")
}
