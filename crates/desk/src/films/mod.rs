//! Films: what a person says of one, its tracking, lengths, the record that it becomes, and the model over its pictures.
//!
//! A person works on one film at a time, the *open* one. Coordinates are pixels of the upright picture, `x` to the right and `y` down
//! from the corner of the first pixel; frames count from 0 in the order in which they are shown.

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
