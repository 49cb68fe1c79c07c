//! Questions and the evaluation of answers.

use crate::{Assignment, Compiled};
use serde::{Deserialize, Serialize};
use units::Unit;

/// A question whose answer the document computes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Question {
    /// Parameter values that the question assumes. Its answer is computed with them instead of the current ones, and the
    /// laboratory offers to set them.
    pub setup: Vec<Assignment>,
    /// Quantities that would reveal the answer, as indices in [`crate::Model::quantities`]: hidden until it is given.
    pub hides: Vec<usize>,
    /// Indices of the earlier questions that must be answered before this one appears.
    pub after: Vec<usize>,
    /// Correct answer; depends on parameters only and is always a number.
    pub answer: Compiled,
    /// Unit in which the answer is asked for.
    pub unit: Unit,
    /// Allowed error of an answer.
    pub tolerance: Tolerance,
    /// Number of attempts that count; `None` for any number. From 1 to [`Question::MOST_ATTEMPTS`].
    pub attempts: Option<u32>,
}

impl Question {
    /// Maximum limit of the attempts at a question.
    pub const MOST_ATTEMPTS: u32 = 50;
}

/// Allowed difference between two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Tolerance {
    /// Fraction of the correct number: 0.02 for `within 2 %`.
    Relative(f64),
    /// Amount in SI units: `within 0.1 [s]`.
    Absolute(f64),
}

impl Tolerance {
    /// True if `given` is close enough to `right`, both in SI units.
    pub fn accepts(self, given: f64, right: f64) -> bool {
        let allowed = match self {
            Self::Relative(fraction) => fraction * right.abs(),
            Self::Absolute(amount) => amount,
        };
        (given - right).abs() <= allowed
    }
}

/// Texts of a question, as HTML.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct QuestionText {
    /// The question.
    pub prompt: String,
    /// Help for finding the answer, if any.
    pub hint: Option<String>,
    /// Explanation shown after answering, if any.
    pub explanation: Option<String>,
}
