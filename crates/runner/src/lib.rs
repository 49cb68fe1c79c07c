//! Many runs of one model with other parameters. A [`Plan`] says with which; a [`Sweep`] computes them on all processors and
//! gives what is taken of each, in the order of the plan and with the same bits on any number of processors.

mod plan;
mod sweep;

pub use plan::{Axis, Plan, PlanError, Points, Values};
pub use sweep::{Outcome, Sweep, threads, use_threads};
