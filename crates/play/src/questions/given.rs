//! An answer of the user, with its grade.

use crate::questions::grade::Grade;

/// The user's answer to a question.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// Text in the field.
    pub typed: String,
    /// Grade, if the answer has been checked.
    pub grade: Option<Grade>,
    /// True if the right answer has been shown.
    pub revealed: bool,
}

impl Answer {
    /// Copy without grade and without the shown answer.
    pub(crate) fn unchecked(&self) -> Self {
        Self { typed: self.typed.clone(), grade: None, revealed: false }
    }

    /// Three lines of text, the storage format of pages with a single simulation: these contain no JSON parser.
    pub fn lines(&self) -> String {
        let grade = self.grade.map_or("", Grade::code);
        let revealed = if self.revealed { "revealed" } else { "" };
        format!("{}\n{grade}\n{revealed}", self.typed)
    }

    /// Parses the output of [`Answer::lines`]; `None` if a line is missing.
    pub fn of_lines(text: &str) -> Option<Self> {
        let mut lines = text.splitn(3, '\n');
        let (typed, grade, revealed) = (lines.next()?, lines.next()?, lines.next()?);
        Some(Self { typed: typed.to_owned(), grade: Grade::from_code(grade), revealed: revealed == "revealed" })
    }
}
