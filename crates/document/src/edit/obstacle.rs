//! Reasons why a text does not fit into a cell or an element.

use crate::blocks::questions::key_in;
use model::{lexemes, outside};
use units::{Words, words};

/// Part of a text that would be parsed as part of the surrounding text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// The text is empty.
    Empty,
    /// A line end.
    LineEnd,
    /// A character or word.
    Mark(String),
    /// Something else.
    Other,
}

impl Obstacle {
    /// First of these marks in the text; `\n` is a line end, and letters are matched as whole words.
    pub(super) fn of(text: &str, marks: &[&str]) -> Self {
        let words = lexemes(text, 0..text.len());
        let is_in = |mark: &&&str| match mark.chars().all(char::is_alphabetic) {
            true => outside(text, &words).any(|(_, word)| word.text(text) == **mark),
            false => text.contains(**mark),
        };
        if text.is_empty() {
            return Self::Empty;
        }
        match marks.iter().find(is_in) {
            Some(&"\n") => Self::LineEnd,
            Some(mark) => Self::Mark((*mark).to_owned()),
            None => Self::Other,
        }
    }

    /// Obstacle in a part of a question, which may have several lines.
    pub(super) fn in_question(text: &str) -> Self {
        match key_in(text) {
            Some(key) => Self::Mark(format!("{key}:")),
            None => Self::in_prose(text),
        }
    }

    /// Obstacle in prose: a fence ends the surrounding block or begins another one.
    pub(super) fn in_prose(text: &str) -> Self {
        let fence = ["```", "~~~"].into_iter().find(|fence| text.contains(fence));
        fence.map_or(Self::Other, |fence| Self::Mark(fence.to_owned()))
    }

    /// Message in one sentence without a full stop.
    pub(super) fn words(&self) -> Words {
        match self {
            Self::Empty => words("this cannot be empty"),
            Self::LineEnd => words("this cannot contain a line break: it must stay on one line"),
            Self::Mark(mark) => {
                words!("this cannot contain `{mark}`, which would be read as part of the text around it")
            }
            Self::Other => words("this would be read as more than this one entry; write it in the text"),
        }
    }
}
