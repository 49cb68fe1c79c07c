//! Passing a simulation on to another program of the page, which has opened the same document.

use crate::time::PassedLine;
use serde::{Deserialize, Serialize};

/// State of a simulation: everything that shows, except answers, which the page stores.
#[derive(Debug, Serialize, Deserialize)]
pub struct Passed {
    /// State as in a link, with every change during the run.
    pub(crate) state: String,
    pub(crate) line: PassedLine,
    /// Greatest magnitudes so far of quantities and of values of the scene, SI; they decide the digits.
    pub(crate) scales: [Vec<f64>; 2],
}
