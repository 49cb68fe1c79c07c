//! Contents of a project.

use super::clip::Clip;
use super::coordinates::Coordinates;
use std::ops::Range;

/// Project of one film.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Project {
    /// Film, if the project names one.
    pub film: Option<Film>,
    /// Frames of the film that belong to the project, and their times.
    pub clip: Clip,
    /// Conversion of pixels to lengths.
    pub coordinates: Coordinates,
    /// Unit of its lengths; `None` if not stated, which means metres in Tracker.
    pub length_unit: Option<String>,
    /// Point masses that are marked in at least one frame.
    pub masses: Vec<Mass>,
    /// Mass relative to which Tracker shows positions; those of this project are relative to the axes.
    pub reference: Option<String>,
    /// Tracks other than point masses: last part of the class, and name.
    pub others: Vec<(String, String)>,
    /// Information that the project does not state.
    pub missing: Missing,
    /// Filters of the pictures of the film, by the last part of their class: positions belong to the filtered picture.
    pub filters: Vec<String>,
}

impl Project {
    /// Film, if it can be tracked here.
    pub fn trackable(&self) -> Option<&Film> {
        self.film.as_ref().filter(|film| film.is_trackable())
    }
}

/// Information that a project does not state, as in those written by other programs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Missing {
    /// True if it has no video clip and so does not state which frames it uses; then all marked frames are used.
    pub clip: bool,
    /// True if it has no clip control, or one without the duration of a frame.
    pub duration: bool,
}

/// Project that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct Opened {
    /// Contents.
    pub project: Project,
    /// Name in the archive, if it was there with others.
    pub name: Option<String>,
}

/// Film of a project.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Film {
    /// Path stated by the project, usually relative to its file.
    pub path: String,
    /// True if it is a sequence of pictures, of which the path names the first, or an animated picture.
    pub pictures: bool,
    /// Location in the archive of the project, if it is there.
    pub packed: Option<PackedFilm>,
}

impl Film {
    /// True if the stated film can be tracked here.
    pub fn is_trackable(&self) -> bool {
        !self.pictures && !self.path.is_empty()
    }
}

/// Film in the archive of its project.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PackedFilm {
    /// Name in the archive, with folders.
    pub name: String,
    /// Range of bytes in the archive.
    pub range: Range<u64>,
    /// True if these bytes are compressed (Deflate), false if they are the film.
    pub deflated: bool,
    /// Size of the film in bytes, as stated by the archive.
    pub size: u64,
}

/// Point mass.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mass {
    /// Name, for example `mass A`.
    pub name: String,
    /// Marks, by ascending frames.
    pub marks: Vec<Mark>,
    /// True if the project distinguishes key frames; older ones do not.
    pub has_keys: bool,
}

/// Position of a mass in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Frame, counted as in the project.
    pub frame: u32,
    /// Position in pixels, to the right and down from the top left corner of the picture.
    pub pixel: [f64; 2],
    /// True for a key frame: marked by hand, or confirmed in the autotracker.
    pub key: bool,
}
