//! Films of a desk.

use crate::films::clip::Clip;
use crate::films::project::ProjectFilm;
use crate::films::truth::FilmTruth;
use crate::films::work::Work;
use film::Plane;
use film::tracking::Following;
use film::tracking::column::SpaceTimePicture;
use units::Words;

/// Work on all films, and the open film.
#[derive(Debug, Default)]
pub(crate) struct Films {
    pub works: Vec<Work>,
    pub open: Option<Open>,
    /// Film in the archive of the last imported project, until it is taken.
    pub project: Option<ProjectFilm>,
}

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

impl Films {
    /// Open film and the work on it.
    pub fn current(&self) -> Option<(&Open, &Work)> {
        let open = self.open.as_ref()?;
        Some((open, self.works.get(open.work)?))
    }

    /// Open film and the work on it, mutable.
    pub fn current_mut(&mut self) -> Option<(&mut Open, &mut Work)> {
        let open = self.open.as_mut()?;
        let work = self.works.get_mut(open.work)?;
        Some((open, work))
    }

    /// Work from which a record comes.
    pub fn of_record(&self, id: u32) -> Option<&Work> {
        self.works.iter().find(|work| work.record == Some(id))
    }
}
