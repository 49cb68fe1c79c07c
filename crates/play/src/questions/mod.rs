//! Questions: what was answered, and what an answer is worth.

mod answer;
pub(crate) mod answered;
mod grade;
mod question;

pub use answered::AnswerView;
pub use grade::{Grade, Verdict};
