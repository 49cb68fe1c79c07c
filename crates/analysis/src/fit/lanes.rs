//! Solutions of equations of motion side by side, by a solver that is given from outside.

use std::fmt::Debug;

/// A solution that is asked for.
#[derive(Clone, Debug)]
pub struct Sought {
    /// One value per parameter of the model, SI units.
    pub parameters: Vec<f64>,
    /// Times at which values are read, SI units: ascending, at least 0.
    pub times: Vec<f64>,
}

/// A solution up to its last time.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Values of each reading in turn at all times, SI units.
    pub values: Vec<f64>,
    /// Approximate number of floating-point operations, as [`engine::Stepper::work`] counts them.
    pub work: u64,
}

/// Solver of the equations of motion of one model for several sets of parameters.
pub trait Lanes: Debug {
    /// Solutions with the error tolerance `tolerance` of each step, relative to the greatest value of each state so far. They have the
    /// bits of [`engine::Stepper::advance_to`]. `None` for a solution that the engine must compute by itself.
    fn solve(&mut self, tolerance: f64, sought: &[Sought]) -> Vec<Option<Solution>>;
}
