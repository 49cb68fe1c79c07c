//! Fits a model to measured data. A [`Task`] names the measurements and the numbers to vary, [`Fit`] runs one trial at a
//! time, and [`Outcome`] holds the result. All numbers are SI; names and units are the model's.

pub(crate) mod autoregression;
mod driver;
mod judgement;
mod lanes;
pub(crate) mod linear;
mod observed;
mod outcome;
mod search;
mod task;
mod trace;
mod uncertainty;

pub use driver::Fit;
pub use judgement::Outlier;
pub use judgement::rank::{Ranked, rank, ties, worth};
pub use judgement::statistics::RunsTest;
pub use judgement::verdict::{Nearness, Share, Verdict};
pub use lanes::{Lanes, Solution, Sought};
pub use observed::{ObservationFit, Outside};
pub use outcome::{Outcome, Scan};
pub use search::elsewhere::Rival;
pub use search::loss::Loss;
pub use search::robust::Reweighted;
pub use task::bind::{BindError, observation};
pub use task::film_scale::FilmScale;
pub use task::offset::lacks_constant;
pub use task::{FitError, Observation, Record, Target, Task, TiedParameter, Varied};
pub use trace::Trace;
pub use uncertainty::estimate::Estimate;
pub use uncertainty::identify::{Lack, Undetermined};
pub use uncertainty::profile::{Interval, profile, profiles};
pub use uncertainty::student::student;

/// Upper bound of the number of varied numbers, over all records.
pub const MOST_VARIED: usize = 64;
/// Upper bound of the number of measured values.
pub const MOST_VALUES: usize = 200_000;
