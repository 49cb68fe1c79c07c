//! What a measurer and an author do in the laboratory, as plain state and transitions: records beside a simulation, their cycles, fits
//! of theories to them, reports, and what is kept for the next visit. No DOM, no clock, no storage.
//!
//! | folder | what it holds |
//! |---|---|
//! | `films` | films: what is followed in one, lengths, the record that it becomes, the model over it |
//! | `records` | files that are read, their columns, derivatives, virtual measurements |
//! | `measured` | points over curves, residuals, the outline in the scene |
//! | `cycles` | an oscillation cycle by cycle |
//! | `fits` | what is varied, the queue, the results, the fit in the sliders, reports |
//! | `saved` | records, fits and answers for the next visit, in one format |
//! | `writing` | the texts of the document while they are written |
//!
//! A [`Refusal`] is the answer to input that cannot be taken; nothing has changed then. Getters that return texts use
//! the chosen language. No method panics; an index that does not exist is ignored or refused.

mod announcement;
mod cycles;
mod desk;
mod films;
mod fits;
mod measured;
mod records;
mod refusal;
mod removed;
mod saved;
mod sizes;
mod undo;
mod words;
mod workbook;
mod writing;

pub use analysis::derivative::Differentiation;
pub use analysis::tracker::{Gathering, gathering};
pub use document;
pub use film;
pub use play;
pub use units::number;

pub use announcement::Announcement;
pub use cycles::{CycleColumn, CyclesView};
pub use desk::{Desk, Revision};
pub use films::{
    CalibrationForm, CameraSettings, Clip, Doubt, DoubtfulFrame, FILMED_SIZE, FilmIdentity, FilmOpening, FilmRecipe,
    FilmTruth, FilmedBody, FilmedSurface, Lacking, LengthsForm, MOST_BODIES, MOST_SURFACES, OpenFilm, POINT_SIGMA,
    ParallaxForm, ProjectFilm, SpaceTimePicture, Subject, TrackingProgress, TruthComparison,
};
pub use fits::{
    ChoiceView, EstimateView, Export, ExportKind, FitDetail, FitProgress, FitRecordView, FitView, Imprint, KnownView,
    MOST_FITS,
};
pub use records::{
    ColumnView, LONGEST_RECORD, MEASUREMENT_FIELDS, MOST_RECORDS, MeasurementForm, RecordProgress, RecordView, SAMPLES,
    Sample, VariableView,
};
pub use refusal::Refusal;
pub use saved::{Change, Item, Left, Shelf, own_document_key};
pub use writing::{
    DrawingPlaces, Insight, LineChanges, Mark, Proposals, TextChange, Writing, insight, line_changes,
    superfluous_versions, text_changes,
};
