//! Runs of one model side by side, for those who take their rows.

use std::fmt::Debug;

/// Receiver of rows: index of the run, time (SI units), what is read.
pub(crate) type Take<'a> = &'a mut dyn FnMut(usize, f64, &[f64]);

/// Runs of one model side by side. Each has the bits of a single run.
pub trait SideBySide: Debug {
    /// Begins runs at 0 which end at `until` (SI units). For each run, at most [`LANES`] of them: its parameters and its initial values,
    /// in the order of the model, SI units. `take` gets the first row of each run.
    fn begin(&mut self, runs: &[[Vec<f64>; 2]], until: f64, take: Take);

    /// Continues the runs by about the work of `left` floating-point operations of the interpreter, which it reduces, but at least by one
    /// step. `take` gets each row of each run, in the order of time. True if the runs are at their ends.
    fn advance(&mut self, left: &mut u64, take: Take) -> bool;

    /// Time and state of the last row of a run, SI units; `None` if a state is not finite: the run fails, and rows may have been taken
    /// after that.
    fn end(&self, run: usize) -> Option<(f64, Vec<f64>)>;
}

/// Number of runs side by side.
pub const LANES: usize = 64;
