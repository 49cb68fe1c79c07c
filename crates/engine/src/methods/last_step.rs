//! The last step of an adaptive method.

/// The last accepted step and everything else that determines the next one; SI units.
#[derive(Clone, Debug)]
pub(crate) struct LastStep {
    pub start: f64,
    pub size: f64,
    /// End of the step: `start + size`, or exactly the time of the row to be reached.
    pub end: f64,
    /// State at the start, one value per state.
    pub from: Vec<f64>,
    /// State at the end, one value per state.
    pub to: Vec<f64>,
    /// Coefficients of the continuous solution, see [`dense_value`](super::dormand_prince::dense_value).
    pub dense: [Vec<f64>; 5],
    /// Size proposed for the next step.
    pub proposed: f64,
    /// Error of the step in units of the allowed error, for the controller.
    pub error: f64,
    /// Greatest magnitude of each state so far.
    pub peaks: Vec<f64>,
}

impl LastStep {
    /// Memory, in bytes.
    pub fn bytes(&self) -> usize {
        size_of::<f64>() * 8 * self.to.len() + size_of::<Self>()
    }
}
