//! Films: subject, tracking, calibration, record, and the model shown over the pictures.
//!
//! One film is open at a time. Coordinates are px of the upright picture, `x` to the right and `y` down from the corner
//! of the first pixel. Frames count from 0 in order of presentation.

mod calibrating;
mod clip;
mod filming;
mod identity;
mod lengths;
mod opening;
mod overlay;
mod plan;
mod project;
mod project_opening;
mod recipe;
pub(crate) mod record;
mod reporting;
mod state;
mod subject;
mod times;
mod tracking;
mod truth;
mod view;
pub(crate) mod work;

pub use clip::Clip;
pub use identity::FilmIdentity;
pub use lengths::{CalibrationForm, Lacking, LengthsForm, ParallaxForm};
pub use opening::FilmOpening;
pub use project::ProjectFilm;
pub use recipe::{CameraSettings, FILMED_SIZE, FilmRecipe};
pub use record::Kept;
pub use subject::{FilmedBody, FilmedSurface, MOST_BODIES, MOST_SURFACES, POINT_SIGMA, Subject};
pub use tracking::TrackingProgress;
pub use truth::{FilmTruth, TruthComparison};
pub use view::{BodyOutline, OpenFilm};

pub use film::tracking::column::SpaceTimePicture;

pub(crate) use project_opening::remarks;
pub(crate) use record::FilmRecord;
pub(crate) use tracking::Tracked;

use crate::opened::OpenDocument;
use crate::records::Records;
use crate::{Changes, Refusal};
use document::Document;
use play::Play;
use state::Open;
use units::{Words, words};
use work::Work;

/// Work on all films, and the open film.
#[derive(Debug, Default)]
pub struct Films {
    works: Vec<Work>,
    open: Option<Open>,
    /// Film in the archive of the last imported project, until it is taken.
    project: Option<ProjectFilm>,
}

/// The films as shown with the open document and the records.
#[derive(Clone, Copy, Debug)]
pub struct ShownFilms<'a> {
    films: &'a Films,
    play: &'a Play,
    document: &'a Document,
    records: &'a Records,
}

impl Films {
    /// The films as shown with the open document and the records.
    pub(crate) fn shown<'a>(&'a self, open: OpenDocument<'a>, records: &'a Records) -> ShownFilms<'a> {
        ShownFilms { films: self, play: open.play, document: open.document, records }
    }

    /// Work from which a record comes.
    pub(crate) fn of_record(&self, id: u32) -> Option<&Work> {
        self.works.iter().find(|work| work.record == Some(id))
    }

    /// Adds work of an earlier visit. Returns false if the work on this film is already there.
    pub(crate) fn restore(&mut self, work: Work) -> (bool, Changes) {
        if self.works.iter().any(|other| other.identity.is_same_film(&work.identity)) {
            return (false, Changes::NONE);
        }
        self.works.push(work);
        (true, Changes::FILMS)
    }

    /// Keeps the film of a project that has become a record. `None` if the last import was none.
    pub(crate) fn keep_project(&mut self, film: Option<ProjectFilm>) {
        self.project = film;
    }

    /// Open film and the work on it.
    fn current(&self) -> Option<(&Open, &Work)> {
        let open = self.open.as_ref()?;
        Some((open, self.works.get(open.work)?))
    }

    /// Open film and the work on it, mutable.
    fn current_mut(&mut self) -> Option<(&mut Open, &mut Work)> {
        let open = self.open.as_mut()?;
        let work = self.works.get_mut(open.work)?;
        Some((open, work))
    }
}

impl<'a> ShownFilms<'a> {
    /// Work on all films, oldest first.
    pub(crate) fn works(self) -> &'a [Work] {
        &self.films.works
    }

    /// Description of the film of a record, without pictures.
    pub(crate) fn described(self, record: u32) -> Option<report::Film> {
        self.films.described(self.play, record)
    }

    /// The records.
    pub(crate) fn records(self) -> &'a Records {
        self.records
    }
}

/// Refusal with the reason in the chosen language.
pub(crate) fn refused(play: &Play, why: &Words) -> Refusal {
    Refusal::Film { why: why.text(play.basis().language()).into_owned() }
}

/// Refusal because no film is open.
pub(crate) fn no_film(play: &Play) -> Refusal {
    refused(play, &words("No film is open. Open one first."))
}
