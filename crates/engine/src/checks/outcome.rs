//! What came of a claim.

use crate::RunError;

/// What came of a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Whether it held.
    pub verdict: Verdict,
    /// The moment that speaks most against it; none if it was not reached, or if a condition was always true.
    pub worst: Option<Worst>,
}

/// Whether a claim held.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// It did.
    Held,
    /// It did not.
    Failed,
    /// The run stopped before the claim was decided.
    Stopped(RunError),
    /// The run ends before the moment of the claim.
    NotReached,
    /// The runs of the document's claims take more than [`super::MOST_WORK`].
    TooLong,
}

impl Outcome {
    /// Whether the claim held.
    pub fn held(&self) -> bool {
        self.verdict == Verdict::Held
    }
}

/// A moment of a run, and what a claim meets there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// The independent variable, SI.
    pub time: f64,
    /// What was measured there; none if the claim is a condition other than one comparison of numbers.
    pub measured: Option<Measured>,
}

/// What was measured for a claim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The claimed number or the left side of a comparison; of [`program::Test::HalvedStep`] that with the document's step. SI.
    pub value: f64,
    /// What it should be, the right side of a comparison, or what it is with the finer step. SI.
    pub expected: f64,
    /// How far off it is: a fraction where the tolerance is one, else SI. Of a comparison with `<` or `>`, how far the value
    /// is on the wrong side; negative on the right one.
    pub off: f64,
    /// How far off it may be, a fraction or SI as `off`. None of a comparison.
    pub allowed: Option<f64>,
}
