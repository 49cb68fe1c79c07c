//! Questions and how their answers are judged.

use crate::{Assignment, Compiled};
use serde::{Deserialize, Serialize};
use units::Unit;

/// A question whose answer the document computes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Question {
    /// Parameter values that the question supposes. Its answer is computed with these in place of the present ones,
    /// and the laboratory offers to set them.
    pub setup: Vec<Assignment>,
    /// Which of [`crate::Model::quantities`] would give the answer away: their values are hidden until it is given.
    pub hides: Vec<usize>,
    /// The earlier questions that must be answered before this one appears.
    pub after: Vec<usize>,
    /// The answer, in terms of parameters only; always a number.
    pub answer: Compiled,
    /// The unit in which the answer is asked for.
    pub unit: Unit,
    /// How far off an answer may be.
    pub tolerance: Tolerance,
}

/// How far off an answer may be.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Tolerance {
    /// A fraction of the right answer: 0.02 for `within 2 %`.
    Relative(f64),
    /// An SI number: `within 0.1 [s]`.
    Absolute(f64),
}

impl Tolerance {
    /// Whether `given` is near enough to `right` (both SI).
    pub fn accepts(self, given: f64, right: f64) -> bool {
        let allowed = match self {
            Self::Relative(fraction) => fraction * right.abs(),
            Self::Absolute(amount) => amount,
        };
        (given - right).abs() <= allowed
    }
}

/// The words of a question, as HTML.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct QuestionText {
    /// What is asked.
    pub prompt: String,
    /// Help towards it.
    pub hint: Option<String>,
    /// Why the answer is what it is; for after answering.
    pub explanation: Option<String>,
}
