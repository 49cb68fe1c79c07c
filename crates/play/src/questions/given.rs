//! What stands in the field of a question, and what it was worth.

use crate::questions::grade::Grade;

/// What a person has answered to a question.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Answer {
    /// What stands in the field.
    pub typed: String,
    /// What it is worth, if it has been checked.
    pub grade: Option<Grade>,
    /// Whether the right answer has been shown.
    pub revealed: bool,
}

impl Answer {
    /// The same before it was checked.
    pub fn unchecked(&self) -> Self {
        Self { typed: self.typed.clone(), grade: None, revealed: false }
    }
}
