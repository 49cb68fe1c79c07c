//! The last step of an adaptive method.

/// The last accepted step and everything else that determines the next one; SI units.
#[derive(Clone, Debug)]
pub struct LastStep {
    /// Start of the step.
    pub start: f64,
    /// Its size.
    pub size: f64,
    /// End of the step: `start + size`, or exactly the time of the row to be reached.
    pub end: f64,
    /// State at the start, one value per state.
    pub from: Vec<f64>,
    /// State at the end, one value per state.
    pub to: Vec<f64>,
    /// Coefficients of the continuous solution, one list per degree: c_0 + p (c_1 + q (c_2 + p (c_3 + q c_4))) at the part p of
    /// the step, with q = 1 - p.
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
    pub(crate) fn bytes(&self) -> usize {
        size_of::<f64>() * 8 * self.to.len() + size_of::<Self>()
    }
}
