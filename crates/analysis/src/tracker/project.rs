//! What a project says.

use super::clip::Clip;
use super::coordinates::Coordinates;
use std::ops::Range;

/// A project of one film.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Project {
    /// Its film, if it names one.
    pub film: Option<Film>,
    /// Which frames of the film belong to it, and when they were taken.
    pub clip: Clip,
    /// How pixels become lengths.
    pub coordinates: Coordinates,
    /// The unit of its lengths. Tracker means metres where none is stated.
    pub length_unit: Option<String>,
    /// The point masses that are marked in at least one frame.
    pub masses: Vec<Mass>,
    /// The mass that Tracker shows positions relative to; those of this project are relative to the axes.
    pub reference: Option<String>,
    /// Tracks that are no point masses, by the last part of their class and their name.
    pub others: Vec<(String, String)>,
    /// What the project does not state.
    pub missing: Missing,
    /// Filters of the film's pictures, by the last part of their class: positions belong to the filtered picture.
    pub filters: Vec<String>,
}

impl Project {
    /// The film, if it can be tracked here.
    pub fn trackable(&self) -> Option<&Film> {
        self.film.as_ref().filter(|film| film.is_trackable())
    }
}

/// What a project does not state, as those that other programs write do not.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Missing {
    /// Which frames of the film it uses: it has no video clip. All marked frames are used then.
    pub clip: bool,
    /// How long a frame lasts: it has no clip control, or one without a duration.
    pub duration: bool,
}

/// A project that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct Opened {
    /// What it says.
    pub project: Project,
    /// Its name in the archive, if it was in one with others.
    pub name: Option<String>,
}

/// The film of a project.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Film {
    /// Where it is, as the project states it: as a rule relative to the project's file.
    pub path: String,
    /// Whether it is a sequence of pictures, of which the path names the first, or an animated picture.
    pub pictures: bool,
    /// Where it is in the archive of the project, if it is there.
    pub packed: Option<PackedFilm>,
}

impl Film {
    /// Whether it is a film that can be tracked here, as far as the project states.
    pub fn is_trackable(&self) -> bool {
        !self.pictures && !self.path.is_empty()
    }
}

/// A film in the archive of its project.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PackedFilm {
    /// Its name in the archive, with folders.
    pub name: String,
    /// The bytes of the archive that hold it.
    pub range: Range<u64>,
    /// Whether these bytes are compressed (Deflate); otherwise they are the film.
    pub deflated: bool,
    /// The film's size in bytes, as the archive states it.
    pub size: u64,
}

/// A point mass.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mass {
    /// Its name, `mass A`.
    pub name: String,
    /// Its marks, by rising frames.
    pub marks: Vec<Mark>,
    /// Whether the project distinguishes key frames; older ones do not.
    pub has_keys: bool,
}

/// The position of a mass in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// The frame, counted as the project does.
    pub frame: u32,
    /// The position in pixels, to the right and down from the top left corner of the picture.
    pub pixel: [f64; 2],
    /// Whether it is a key frame: marked by hand, or confirmed in the autotracker.
    pub key: bool,
}
