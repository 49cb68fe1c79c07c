//! The result of a claim.

use crate::RunError;

/// The result of a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The verdict.
    pub verdict: Verdict,
    /// The moment of the greatest violation; `None` if no moment was reached or a condition was always true.
    pub worst: Option<Worst>,
}

/// Verdict on a claim.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The claim holds.
    Held,
    /// The claim does not hold.
    Failed,
    /// The run stopped before the claim was decided.
    Stopped(RunError),
    /// The run ends before the moment of the claim.
    NotReached,
    /// The work limit of all checks, [`super::MOST_WORK`], is used up.
    TooLong,
}

impl Outcome {
    /// True if the claim holds.
    pub fn held(&self) -> bool {
        self.verdict == Verdict::Held
    }
}

/// A moment of a run and the values of a claim there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// The independent variable, SI units.
    pub time: f64,
    /// The values there; `None` if the claim is a condition other than one comparison of numbers.
    pub measured: Option<Measured>,
}

/// Values measured for a claim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The claimed number or the left side of a comparison, SI units; for [`program::Test::HalvedStep`] the value with the
    /// step of the document.
    pub value: f64,
    /// The expected value, the right side of a comparison, or the value with the finer step; SI units.
    pub expected: f64,
    /// Difference: a fraction if the tolerance is relative, else in SI units. For `<` and `>`, the distance on the wrong
    /// side, negative on the right side.
    pub off: f64,
    /// Allowed difference, in the same unit as `off`; `None` for a comparison.
    pub allowed: Option<f64>,
}
