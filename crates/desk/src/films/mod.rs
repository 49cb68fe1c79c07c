//! Films: subject, tracking, calibration, record, and the model shown over the pictures.
//!
//! One film is open at a time. Coordinates are px of the upright picture, `x` to the right and `y` down from the corner
//! of the first pixel. Frames count from 0 in order of presentation.

mod calibrating;
pub(crate) mod clip;
mod doubt;
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
pub(crate) mod state;
mod subject;
mod times;
mod tracking;
mod truth;
mod view;
pub(crate) mod work;

pub use clip::Clip;
pub use doubt::{Doubt, DoubtfulFrame};
pub use identity::FilmIdentity;
pub use lengths::{CalibrationForm, Lacking, LengthsForm, ParallaxForm};
pub use opening::FilmOpening;
pub use project::ProjectFilm;
pub use recipe::{CameraSettings, FILMED_SIZE, FilmRecipe};
pub use subject::{FilmedBody, FilmedSurface, MOST_BODIES, MOST_SURFACES, POINT_SIGMA, Subject};
pub use tracking::TrackingProgress;
pub use truth::{FilmTruth, TruthComparison};
pub use view::{BodyOutline, OpenFilm};

pub use film::tracking::column::SpaceTimePicture;
