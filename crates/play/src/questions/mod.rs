//! Questions: the user's answers and their grades.

mod answer;
mod answered;
pub(crate) mod given;
mod grade;

pub use answered::{AnswerView, Answers};
pub use given::{Answer, Attempt};
pub use grade::{Grade, Verdict};
