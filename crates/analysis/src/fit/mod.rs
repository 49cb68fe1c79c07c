//! Fits a model to measured data: a [`Task`] says what is measured and what may vary, [`Fit`] works on it in slices, and
//! [`Outcome`] is what is known in the end. All numbers are SI; names and units are the model's.

mod apart;
pub(crate) mod autoregression;
mod bind;
mod check;
mod columns;
mod covariance;
mod criteria;
mod curve;
mod driver;
mod elsewhere;
mod estimate;
mod exchange;
mod film_scale;
mod hac;
mod identify;
mod judgement;
pub(crate) mod linear;
mod loss;
mod observed;
mod outcome;
mod outliers;
mod plan;
mod problem;
mod profile;
mod rank;
mod refine;
mod robust;
mod scale;
mod search;
mod stages;
mod start;
mod statistics;
mod student;
mod symmetry;
mod task;
mod trace;
mod undersampled;
mod verdict;
mod weights;
mod window;
mod words;

pub use bind::{BindError, observation};
pub use driver::Fit;
pub use elsewhere::Rival;
pub use estimate::Estimate;
pub use film_scale::FilmScale;
pub use identify::{Lack, Undetermined};
pub use judgement::Outlier;
pub use loss::Loss;
pub use observed::{ObservationFit, Outside};
pub use outcome::Outcome;
pub use profile::{Interval, profile, profiles};
pub use rank::{Ranked, rank, ties, worth};
pub use robust::Reweighted;
pub use statistics::RunsTest;
pub use task::{FitError, Observation, Record, Target, Task, Varied};
pub use trace::Trace;
pub use verdict::Verdict;

/// The greatest number of varied numbers, over all records.
pub const MOST_VARIED: usize = 64;
/// The greatest number of measured values.
pub const MOST_VALUES: usize = 200_000;
