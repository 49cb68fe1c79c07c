//! The films of a desk.

use crate::films::clip::Clip;
use crate::films::project::ProjectFilm;
use crate::films::truth::FilmTruth;
use crate::films::work::Work;
use film::Plane;
use film::tracking::Following;
use film::tracking::column::SpaceTimePicture;
use units::Words;

/// All films that a person has worked on, and the one that is open.
#[derive(Debug, Default)]
pub(crate) struct Films {
    pub works: Vec<Work>,
    pub open: Option<Open>,
    /// The film in the archive of a project that has become a record, until it is taken.
    pub project: Option<ProjectFilm>,
}

/// The film that is open.
#[derive(Debug)]
pub(crate) struct Open {
    /// Its place among the works.
    pub work: usize,
    pub clip: Clip,
    /// The tracking, from its beginning on; it stays for corrections.
    pub following: Option<Following>,
    /// Whether the tracking is to go on.
    pub running: bool,
    /// Whether only strips are read: what was found at an earlier visit stays.
    pub reading: bool,
    /// Whether the tracking has been finished, so that another result is a correction of it.
    pub finished: bool,
    /// What is known of a filmed simulation.
    pub truth: Option<FilmTruth>,
    /// What a person should know of the project of Tracker by which it was opened.
    pub notes: Vec<Words>,
    /// The space-time picture of each surface.
    pub pictures: Vec<SpaceTimePicture>,
    /// The first frame that was tracked, for reports.
    pub still: Option<Still>,
}

/// A frame as it is stored.
#[derive(Debug)]
pub(crate) struct Still {
    pub frame: usize,
    pub plane: Plane,
}

impl Films {
    /// The open film and the work on it.
    pub fn current(&self) -> Option<(&Open, &Work)> {
        let open = self.open.as_ref()?;
        Some((open, self.works.get(open.work)?))
    }

    /// The same, to be changed.
    pub fn current_mut(&mut self) -> Option<(&mut Open, &mut Work)> {
        let open = self.open.as_mut()?;
        let work = self.works.get_mut(open.work)?;
        Some((open, work))
    }

    /// The work that a record comes from.
    pub fn of_record(&self, id: u32) -> Option<&Work> {
        self.works.iter().find(|work| work.record == Some(id))
    }
}
