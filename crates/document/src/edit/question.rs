//! Edits of questions: changing parts, adding and removing questions.

use super::blocks::{insert_block, remove_block};
use super::layout::{begin_line, line_end, result, with_line_ends_of};
use super::obstacle::Obstacle;
use super::{Edit, EditError};
use crate::asked;
use crate::blocks::questions;
use crate::text::outline::{Outline, read};
use crate::translating::question_at;
use crate::{Asked, BlockKind, QuestionPart};
use model::Span;

/// A new question whose answer the model computes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NewQuestion {
    /// Question text.
    pub prompt: String,
    /// Name of the quantity that is the answer, or an expression.
    pub answer: String,
    /// Tolerance of the answer in percent, as typed.
    pub percent: String,
    /// True if the value of the quantity is hidden until the question is answered.
    pub hides: bool,
    /// True if the question appears only after the one before it is answered.
    pub follows: bool,
    /// Hint; empty for none.
    pub hint: String,
}

/// Adds a question after the last one, or at the end of the document if there is none.
///
/// # Errors
///
/// [`EditError::NotOneCell`] if a text would not be parsed as its part of the question, and the errors of [`insert_block`].
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
    // A blank line before the question.
    let before = &outline.source()[..edit.span.start];
    if !before.ends_with("\n\n") && !before.ends_with("\r\n\r\n") && !before.is_empty() {
        edit.text.insert_str(0, line_end(outline.source()));
    }
    let text = result(outline, std::slice::from_ref(&edit))?;
    let count = asked(outline).len();
    let after = asked(&read(&text));
    let is_new =
        |one: &Asked| one.prompt == prompt && one.hint == hint && one.answer == format!("{answer} within {percent} %");
    if after.len() == count + 1 && after.last().is_some_and(is_new) {
        return Ok(edit);
    }
    let in_line = [answer, percent].map(|text| Obstacle::of(text, &["\n"]));
    let obstacles = in_line.into_iter().chain([prompt, hint].map(Obstacle::in_question));
    Err(EditError::NotOneCell(obstacles.into_iter().find(|one| *one != Obstacle::Other).unwrap_or(Obstacle::Other)))
}

/// Sets a part of the question with this index; an empty text removes the part.
///
/// # Errors
///
/// [`EditError::UnknownCell`] if there is no such question, [`EditError::NotOneCell`] if the text would not be parsed as
/// this part alone.
pub fn set_question(outline: &Outline, number: usize, part: QuestionPart, text: &str) -> Result<Vec<Edit>, EditError> {
    let text = match part {
        QuestionPart::Wrong | QuestionPart::Options => {
            text.lines().map(str::trim).filter(|line| !line.is_empty()).collect::<Vec<_>>().join("\n")
        }
        _ => text.trim().to_owned(),
    };
    let text = with_line_ends_of(outline.source(), &text);
    let before = asked(outline);
    let own = before.get(number).ok_or(EditError::UnknownCell)?;
    if own.text(part) == text {
        return Ok(Vec::new());
    }
    let written = match part {
        QuestionPart::Wrong | QuestionPart::Options => {
            text.replace('\n', &format!("\n{}: ", part.word().unwrap_or_default()))
        }
        _ => text.clone(),
    };
    let edit = write_part(outline.source(), own.place, part.word(), &written);
    let after = asked(&read(&result(outline, std::slice::from_ref(&edit))?));
    let is_other = |question: usize, one: QuestionPart| question != number || one != part;
    let others = |all: &[Asked]| -> Vec<String> {
        let texts = all.iter().enumerate().flat_map(|(question, asked)| {
            let parts = QuestionPart::ALL.into_iter().filter(move |one| is_other(question, *one));
            parts.map(|one| asked.text(one).to_owned())
        });
        texts.collect()
    };
    let stands = after.get(number).is_some_and(|own| own.text(part) == text);
    if stands && others(&before) == others(&after) {
        Ok(vec![edit])
    } else {
        Err(EditError::NotOneCell(Obstacle::in_question(&text)))
    }
}

/// Edit that sets a part of a question. `content`: content of its block. The text goes after the key `word`, or before all
/// keys for `None`.
pub(super) fn write_part(source: &str, content: Span, word: Option<&str>, text: &str) -> Edit {
    let end = line_end(source);
    let (span, text) = match (questions::part(source, content.range(), word), word) {
        (Some(place), None) if place.is_empty() => (content.start..content.start, format!("{text}{end}{end}")),
        (Some(place), Some(_)) if text.is_empty() => {
            let line = source[..place.start].rfind('\n').map_or(0, |at| at + 1);
            let next = source[place.end..].find('\n').map_or(source.len(), |at| place.end + at + 1);
            (line..next.min(content.end), String::new())
        }
        // A key without a text has no blank after it.
        (Some(place), Some(_)) if place.is_empty() => (place, format!(" {text}")),
        (Some(place), _) => (place, text.to_owned()),
        (None, word) => {
            let begin = begin_line(source, content.end);
            (content.end..content.end, format!("{begin}{}: {text}{end}", word.unwrap_or_default()))
        }
    };
    Edit { span: Span::new(span.start, span.end), text }
}

/// Removes the question with this index from a document and from its translations, which have their questions in the same
/// order. The edits of the document come first. References of other questions (`after:`) are updated.
///
/// # Errors
///
/// [`EditError::UnknownCell`] if there is no such question, and those of [`remove_block`].
pub fn remove_question(outline: &Outline, number: usize, translations: &[&str]) -> Result<Vec<Vec<Edit>>, EditError> {
    let mut own = vec![without(outline, number)?.ok_or(EditError::UnknownCell)?];
    for (place, later) in asked(outline).iter().enumerate().skip(number + 1) {
        let after = after_without(&later.after, number, place);
        if after != later.after {
            own.push(write_part(outline.source(), later.place, Some("after"), &after));
        }
    }
    let mut edits = vec![own];
    for translation in translations {
        edits.push(without(&read(translation), number)?.into_iter().collect());
    }
    Ok(edits)
}

/// Edit that removes the question with this index and the blank line after it; `None` if there is no such question.
fn without(outline: &Outline, number: usize) -> Result<Option<Edit>, EditError> {
    let Some(block) = question_at(outline, number) else { return Ok(None) };
    let mut edit = remove_block(outline, block)?;
    let (before, behind) = (&outline.source()[..edit.span.start], &outline.source()[edit.span.end..]);
    let empty = ["\n", "\r\n"].into_iter().find(|end| behind.starts_with(end));
    if let Some(end) = empty.filter(|end| before.ends_with(&end.repeat(2))) {
        edit.span.end += end.len();
    }
    Ok(Some(edit))
}

/// Text of `after:` without the question `removed`. `place`: index of the referring question before the removal. Both
/// indices count from 0.
fn after_without(after: &str, removed: usize, place: usize) -> String {
    let left = after.split(',').map(str::trim).filter_map(|one| match one.parse::<usize>() {
        Ok(number) if number == removed + 1 => None,
        Ok(number) if number > removed + 1 => Some((number - 1).to_string()),
        // The first question has no previous one.
        _ => (one != "previous" || place > 1).then(|| one.to_owned()),
    });
    left.collect::<Vec<_>>().join(", ")
}
