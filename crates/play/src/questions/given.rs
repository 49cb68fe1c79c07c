//! What stands in the field of a question, and what it was worth.

use crate::questions::grade::Grade;

/// What a person has answered to a question.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// What stands in the field.
    pub typed: String,
    /// What it is worth, if it has been checked.
    pub grade: Option<Grade>,
    /// Whether the right answer has been shown.
    pub revealed: bool,
}

impl Answer {
    /// The same before it was checked.
    pub(crate) fn unchecked(&self) -> Self {
        Self { typed: self.typed.clone(), grade: None, revealed: false }
    }

    /// As three lines, the form in which the pages of single simulations store it: those carry no reader of JSON.
    pub fn lines(&self) -> String {
        let grade = self.grade.map_or("", Grade::code);
        let revealed = if self.revealed { "revealed" } else { "" };
        format!("{}\n{grade}\n{revealed}", self.typed)
    }

    /// What [`Answer::lines`] has written. None where a line is missing.
    pub fn of_lines(text: &str) -> Option<Self> {
        let mut lines = text.splitn(3, '\n');
        let (typed, grade, revealed) = (lines.next()?, lines.next()?, lines.next()?);
        Some(Self { typed: typed.to_owned(), grade: Grade::from_code(grade), revealed: revealed == "revealed" })
    }
}
