//! Questions: answers, their grades, and kinds of questions.

mod answers;
mod kinds;
