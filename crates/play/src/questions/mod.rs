//! Questions: what was answered, and what an answer is worth.

mod answer;
pub(crate) mod answered;
mod question;

pub use answered::AnswerView;
pub use question::{Grade, Verdict};
