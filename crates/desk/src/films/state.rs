//! The open film.

use crate::films::clip::Clip;
use crate::films::truth::FilmTruth;
use film::Plane;
use film::tracking::Following;
use film::tracking::column::SpaceTimePicture;
use units::Words;

/// Open film.
#[derive(Debug)]
pub(crate) struct Open {
    /// Index of its work.
    pub work: usize,
    pub clip: Clip,
    /// Tracking since its start, kept for corrections.
    pub following: Option<Following>,
    /// True while the tracking runs.
    pub running: bool,
    /// True if only strips are read, and the results of an earlier visit are kept.
    pub reading: bool,
    /// True if the tracking has finished once, so that a further result is a correction.
    pub finished: bool,
    /// True positions, for a filmed simulation.
    pub truth: Option<FilmTruth>,
    /// Notes on the Tracker project of the film.
    pub notes: Vec<Words>,
    /// Space-time picture of each surface.
    pub pictures: Vec<SpaceTimePicture>,
    /// First tracked frame, for reports.
    pub still: Option<Still>,
}

/// Stored frame.
#[derive(Debug)]
pub(crate) struct Still {
    pub frame: usize,
    pub plane: Plane,
}
