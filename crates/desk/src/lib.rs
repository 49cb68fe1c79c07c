//! Laboratory for one document as plain state and transitions: records beside a simulation, their cycles, fits of
//! theories, reports, and the data stored for the next visit. No DOM, no clock, no storage.
//!
//! | folder | content |
//! |---|---|
//! | `films` | open film, tracked objects, calibration, the resulting record, the model drawn over the film |
//! | `records` | reading of files, columns, derivatives, virtual measurements |
//! | `measured` | points over curves, residuals, the outline in the scene |
//! | `cycles` | an oscillation cycle by cycle |
//! | `fits` | fit settings, queue, results, application to the sliders, reports |
//! | `storing` | records, films, fits and answers stored for the next visit |
//! | `writing` | editing of the texts of the document |
//!
//! A [`Refusal`] is the error for rejected input; the state is then unchanged. Getters that return texts use the chosen
//! language. No method panics; an index that does not exist is ignored or refused.
//!
//! Records belong to no document: opening another one recognises their columns again. What is kept for the next visit has two
//! formats. The state of the simulation is the link of `play/src/share`; everything else is an item of the crate `saved`.
//!
//! - **Invariant:** no DOM, no clock, no storage. What the page can do is tested here and in `play` without a browser.
//! - **Invariant:** stored text is not trusted: every index is checked before it is used, and records without room stay where
//!   they are.
//! - **Invariant:** `xtask/tests/tidy/parts.rs` holds the rules of the parts of `Desk` and `Play`: no type with methods that
//!   change it has fields open beyond its folder, methods of `Desk` and of `Play` stand in one file each, and no type has
//!   more than 40 public ones.

mod announcement;
mod changes;
mod cycles;
mod desk;
mod films;
mod fits;
mod measured;
mod opened;
mod records;
mod refusal;
mod removed;
mod sizes;
mod storing;
mod words;
mod workbook;
mod writing;

pub use analysis::derivative::Differentiation;
pub use analysis::fit::Nearness;
pub use analysis::import::DateOrder;
pub use analysis::smoothing::WIDEST;
pub use analysis::tracker::{Gathering, gathering};
pub use document;
pub use film;
pub use play;
pub use saved;
pub use units::number;

pub use announcement::Announcement;
pub use changes::{Changes, Revision};
pub use cycles::{CycleColumn, Cycles, CyclesView, ShownCycles};
pub use desk::Desk;
pub use films::{
    BodyOutline, CalibrationForm, CameraSettings, Clip, FILMED_SIZE, FilmIdentity, FilmOpening, FilmRecipe, FilmTruth,
    FilmedBody, FilmedSurface, Films, Kept, Lacking, LengthsForm, MOST_BODIES, MOST_SURFACES, OpenFilm, POINT_SIGMA,
    ParallaxForm, ProjectFilm, ShownFilms, SpaceTimePicture, Subject, TrackingProgress, TruthComparison,
};
pub use fits::{
    ChoiceView, EstimateView, Export, ExportKind, Finding, FitComputation, FitData, FitDetail, FitNews, FitProgress,
    FitRecordView, FitView, FitWork, Fits, FittedCurve, Imprint, InProcess, KnownView, MOST_FITS, NothingFound,
    PeriodComparison, PeriodQuestion, ShownFits, TheoryCurve, Workers, write_varied,
};
pub use measured::{CurveAxis, MeasuredCurve, MeasuredData};
pub use opened::{OpenDocument, OpenedDocuments};
pub use records::{
    ColumnView, LONGEST_RECORD, LONGEST_SAVED, MEASUREMENT_FIELDS, MOST_RECORDS, MeasurementForm, RecordProgress,
    RecordView, Records, SAMPLES, Sample, ShownRecords, VariableView, measurement_units,
};
pub use refusal::Refusal;
pub use storing::{
    Visit, answer_of_item, document_data, facts, items_of_fit, merge_project_items, project_items, restore,
    restore_answer, saved_answers, take_project_items,
};
pub use workbook::{export_record, missing_in_link, workbook};
pub use writing::{
    DrawingPlaces, Insight, LineChanges, Mark, Proposals, TextChange, Writing, insight, line_changes, propose,
    superfluous_versions, text_changes,
};
