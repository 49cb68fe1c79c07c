//! An answer to a question as an item of a project. A field can be added at any time: readers ignore unknown fields and use defaults
//! for missing ones.

use crate::Number;
use crate::json::{self, Object};
use serde::Deserialize;

/// Version of the format of items.
pub const ITEM_VERSION: u32 = 3;

/// Answer to a question.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
pub struct Answer {
    /// Text in the field.
    pub typed: String,
    /// `Grade::code`; `None` if the answer has not been graded.
    pub grade: Option<String>,
    /// Number of attempts before the right answer was shown; `None` if it was not shown, or in items of versions up to 0.2.0.
    pub shown: Option<usize>,
    /// True if the right answer has been shown. Read in items of versions up to 0.2.0, and written for them.
    pub revealed: bool,
    /// True if a right answer had been given when the right answer was shown. Read in items of versions up to 0.2.0.
    pub found: bool,
    /// Answers that have been checked, in order.
    pub attempts: Vec<Attempt>,
}

/// An answer that has been checked.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
pub struct Attempt {
    /// Text in the field.
    pub typed: String,
    /// `Grade::code` of the grade that was stated.
    pub grade: String,
    /// Tag of the language in which it was typed; `None` in items of versions up to 0.2.0.
    pub language: Option<String>,
    /// Values (SI) of the parameters that the reader sets and on which the right answer depends, by name.
    pub values: Vec<(String, Number)>,
}

impl Answer {
    /// The answer in JSON.
    pub fn json(&self) -> String {
        let truth = |is: bool| is.then(|| "true".to_owned());
        let attempts = || json::list(self.attempts.iter().map(Attempt::json));
        Object::default()
            .with("typed", json::text(&self.typed))
            .with_some("grade", self.grade.as_deref().map(json::text))
            .with_some("shown", self.shown.map(|before| before.to_string()))
            .with_some("revealed", truth(self.revealed))
            .with_some("found", truth(self.found))
            .with_some("attempts", (!self.attempts.is_empty()).then(attempts))
            .end()
    }
}

impl Attempt {
    fn json(&self) -> String {
        let value = |(name, Number(value)): &(String, Number)| json::list([json::text(name), json::number(*value)]);
        let values = || json::list(self.values.iter().map(value));
        Object::default()
            .with("typed", json::text(&self.typed))
            .with("grade", json::text(&self.grade))
            .with_some("language", self.language.as_deref().map(json::text))
            .with_some("values", (!self.values.is_empty()).then(values))
            .end()
    }
}

/// Text of a stored item: content of this kind, and the time when it was first stored, in milliseconds.
pub fn item(kind: &str, content: &str, since: u64) -> String {
    Object::default()
        .with("meniscus", ITEM_VERSION.to_string())
        .with("since", since.to_string())
        .with("item", Object::default().with(kind, content).end())
        .end()
}
