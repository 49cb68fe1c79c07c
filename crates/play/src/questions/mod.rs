//! Questions: the user's answers and their grades.

mod answer;
mod answered;
pub(crate) mod given;
mod grade;
mod question;

pub use answered::AnswerView;
pub use given::Answer;
pub use grade::{Grade, Verdict};
