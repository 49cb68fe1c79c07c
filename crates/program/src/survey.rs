//! The survey of a document: opinions that are collected without names.

use serde::{Deserialize, Serialize};

/// Kind of an item of a survey.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum SurveyKind {
    /// The group to which the person belongs, such as students or teachers.
    Role,
    /// Agreement with a statement, in steps.
    Scale,
    /// One of several texts.
    Choice,
    /// Free text.
    Text,
}

impl SurveyKind {
    /// All kinds.
    pub const ALL: [Self; 4] = [Self::Role, Self::Scale, Self::Choice, Self::Text];

    /// Keyword of the kind, in documents and in files with answers.
    pub fn word(self) -> &'static str {
        match self {
            Self::Role => "role",
            Self::Scale => "scale",
            Self::Choice => "choice",
            Self::Text => "text",
        }
    }
}

/// An item of a survey.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SurveyItem {
    /// Kind of the item.
    pub kind: SurveyKind,
    /// Number of steps of a scale, or of alternatives; 0 for free text.
    pub answers: usize,
}

impl SurveyItem {
    /// Maximum number of items of a document.
    pub const MOST: usize = 50;
    /// Maximum number of steps of a scale.
    pub const MOST_STEPS: usize = 11;
    /// Maximum number of alternatives of a role or a choice.
    pub const MOST_ALTERNATIVES: usize = 20;
    /// Maximum length of each text of an item, in characters.
    pub const LONGEST: usize = 300;

    /// True if the number of answers is allowed and the text has the words for them.
    pub(crate) fn is_sound(self, text: &SurveyText) -> bool {
        let words = text.words.len();
        match self.kind {
            SurveyKind::Role | SurveyKind::Choice => {
                (2..=Self::MOST_ALTERNATIVES).contains(&self.answers) && words == self.answers
            }
            SurveyKind::Scale => (2..=Self::MOST_STEPS).contains(&self.answers) && words == 2,
            SurveyKind::Text => self.answers == 0 && words == 0,
        }
    }
}

/// Texts of an item of a survey, as plain text.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct SurveyText {
    /// The question or statement.
    pub asked: String,
    /// The alternatives; the words at the lower and the upper end of a scale; empty for free text.
    pub words: Vec<String>,
}
