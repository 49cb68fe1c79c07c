//! Questions: the user's answers and their grades.
//!
//! `grading.rs` makes every grade, from an answer, its `Conditions` and the seat.

mod answer;
mod answered;
pub(crate) mod given;
mod grade;
mod grading;
mod marker;
mod stored;

pub use answered::{AnswerView, Answers, Limit};
pub use given::{Answer, Attempt, Conditions, GradedAttempt};
pub use grade::{Grade, Verdict};
pub use marker::Marker;
