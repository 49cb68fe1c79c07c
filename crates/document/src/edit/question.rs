//! Further questions.

use super::blocks::insert_block;
use super::layout::result;
use super::{Edit, EditError};
use crate::outline::{Outline, read};
use crate::{BlockKind, asked};

/// A question whose answer the model computes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NewQuestion {
    /// What is asked.
    pub prompt: String,
    /// The quantity that is the answer, or an expression.
    pub answer: String,
    /// How far off an answer may be, in percent, as its author typed it.
    pub percent: String,
    /// Whether the value of the quantity is hidden until then.
    pub hides: bool,
    /// Whether it appears when the question before it is answered.
    pub follows: bool,
    /// The hint; none if it is empty.
    pub hint: String,
}

/// Adds a question behind the last one, or else at the end of the document.
///
/// # Errors
///
/// [`EditError::NotOneCell`] if a text would not be read as the part of the question that it is, and those of [`insert_block`].
pub fn add_question(outline: &Outline, question: &NewQuestion) -> Result<Edit, EditError> {
    let parts = [&question.prompt, &question.answer, &question.percent, &question.hint].map(|text| text.trim());
    let [prompt, answer, percent, hint] = parts;
    let mut lines = vec![prompt.to_owned(), String::new()];
    lines.extend(question.follows.then(|| "after: previous".to_owned()));
    lines.extend(question.hides.then(|| format!("hide: {answer}")));
    lines.push(format!("answer: {answer} within {percent} %"));
    lines.extend((!hint.is_empty()).then(|| format!("hint: {hint}")));
    let blocks = outline.blocks();
    let after = blocks.iter().rposition(|block| block.kind == BlockKind::Question).or(blocks.len().checked_sub(1));
    let mut edit = insert_block(outline, after, BlockKind::Question, &lines.join("\n"))?;
    // A free line between it and what stands before.
    let before = &outline.source()[..edit.span.start];
    if !before.ends_with("\n\n") && !before.ends_with("\r\n\r\n") && !before.is_empty() {
        edit.text.insert_str(0, super::layout::line_end(outline.source()));
    }
    let text = result(outline, std::slice::from_ref(&edit))?;
    let count = asked(outline).len();
    let after = asked(&read(&text));
    let is_new = |one: &crate::Asked| {
        one.prompt == prompt && one.hint == hint && one.answer == format!("{answer} within {percent} %")
    };
    if after.len() == count + 1 && after.last().is_some_and(is_new) { Ok(edit) } else { Err(EditError::NotOneCell) }
}
