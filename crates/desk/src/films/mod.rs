//! Films: subject, tracking, calibration, record, and the model shown over the pictures.
//!
//! One film is open at a time. Coordinates are px of the upright picture, `x` to the right and `y` down from the corner
//! of the first pixel. Frames count from 0 in order of presentation.
//!
//! A `Work` is what a person has said of a film (what is followed, resting marks, time base, lengths) and the tracks in
//! numbers. The `Clip` of the open film has the times of the container, and its `film::tracking::Following` asks for frames,
//! takes them as they are stored, and computes in portions. It stays for corrections (`anchor_surface`), which need no
//! frames. What was found at an earlier visit is not computed again: only strips are read (`take_up_tracking`). A film itself
//! is never stored: it is known again by size and hash of its first MiB.
//!
//! From film to record:
//!
//! 1. `opening.rs`: `Films::open` finds the work on the film, or begins one. `Films::follow` takes the clicks,
//!    `begin_tracking` makes a `film::tracking::Plan` of them in stored pixels (`plan.rs`).
//! 2. `tracking.rs`: as long as `wanted_frame` names one, the page decodes it and calls `give_frame`. `Following::take`
//!    corrects for the camera (`Marks`) and keeps strips of tubes (`Column::take`) or the pixels around bodies
//!    (`Body::take`).
//! 3. After the last frame `film::timing::repeats` may ask for a second reading without repeated pictures. Then
//!    `advance_tracking` computes path, refinement, exposure, readout and standard errors.
//! 4. `found` (`plan.rs`) turns the tracks upright. `record_to_write` (`record.rs`) makes columns of them by
//!    `film::table::Table` and the `Calibration` that `Films::calibrate` has set, and writes them as CSV.
//!    `Desk::write_film_record` inserts or replaces the record, so that inspection, recognition, cycles and fits treat it as
//!    any other. A change of lengths or times replaces its table in place.
//! 5. `Record::errors_as` gives fits the columns `sigma_`, and `scale_error` of the table the error that all lengths share, a
//!    line above the headings (`analysis::scale_line`): `fit/task/scale.rs` of `analysis` makes a number with a prior of it.
//!
//! `project.rs` takes the film in a project of Tracker, with its positions and axes. `recipe.rs` has all that decides the
//! film of a simulation, and `truth.rs` compares tracks with where the parts of the scene were. `overlay.rs` goes the other
//! way, from the model to pixels and from its time to a frame. `reporting.rs` gives a report what it shows of a film.

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
