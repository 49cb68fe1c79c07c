//! Fits a model to measured data. A [`Task`] names the measurements and the numbers to vary, [`Fit`] runs one trial at a
//! time, and [`Outcome`] holds the result. All numbers are SI; names and units are the model's.
//!
//! A [`Task`] has records and varied parameters. [`Fit`] (`driver.rs`) advances one trial at a time, so that the page stays
//! responsive. A trial has an upper bound of work (`MOST_WORK` in `search/motion.rs`); [`Fit::gave_up`] tells that it was
//! met. The parts:
//!
//! - `Problem` is what is asked and how it is computed: the model, its `curve`, the fitted points (`task/plan.rs`) with their
//!   weights, the columns that are varied, and the tolerances. `curve` gives values of the model and their derivatives:
//!   symbolic ones for formulas, sensitivities for equations of motion, which `motion` solves.
//! - `Search` is the state of one search for the least sum of squares. `window` begins one on a problem or on a part of it.
//! - Four files say where to search next, and each keeps what it must remember: `stages` from which starts (found by
//!   `start`), `moves` how a saddle is left and which frequencies (`tones` of the model, `line`s of the data and residuals)
//!   are tried again, `elsewhere` from where around the best answer, and `refine` how the best answer is gone on with, with
//!   `symmetry` and, for M-estimation by reweighting, `robust`.
//! - `covariance`, `hac` and `autoregression` give standard errors, also for autocorrelated residuals. `identify` names what
//!   the data do not determine; `exchange` tries which numbers can exchange their values, once the answer is known. `late`
//!   moves a clock that begins late.
//! - `judgement` tests the residuals, `verdict` says what that means, and `undersampled` finds aliases.
//!
//! None of them sees the [`Fit`]: they get a `Problem` and a `Search` and return a value. So do `outcome` and `trace`. Only
//! `profile`, which sends a fit to a lower minimum where it meets one, works on a whole [`Fit`], through its methods.
//!
//! A solver of many solutions can be given from outside (trait [`Lanes`], [`Fit::use_lanes`]; `runner` gives
//! `ensemble::Solutions` on all processors): the next points of all ends of a profile (`profile_end`) and the records of a
//! trial are then solved together before they are asked for one by one, and `curve` finds them.

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
