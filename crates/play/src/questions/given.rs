//! An answer of the user, with its grade and all attempts.

use crate::questions::grade::Grade;
use serde::{Deserialize, Serialize};

/// Maximum number of attempts at a question that are kept: the latest ones.
const MOST_ATTEMPTS: usize = 100;

/// Maximum length of a stored answer, in characters.
const LONGEST: usize = 300;

/// An answer that has been checked.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Attempt {
    /// Text in the field.
    pub typed: String,
    /// Its grade.
    pub grade: Grade,
}

/// The user's answer to a question.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// Text in the field, at most 300 characters in one line.
    pub typed: String,
    /// Grade, if the answer has been checked.
    pub grade: Option<Grade>,
    /// True if the right answer has been shown.
    pub revealed: bool,
    /// True if a right answer had been given when the right answer was shown.
    pub found: bool,
    /// All answers that have been checked, in order; of more than 100 the latest.
    pub attempts: Vec<Attempt>,
}

impl Answer {
    /// Copy for a question whose right answer is another one now: without grade, attempts and the shown answer.
    pub(crate) fn unchecked(&self) -> Self {
        Self { typed: self.typed.clone(), ..Self::default() }
    }

    /// True if a right answer was given before it was shown.
    pub(crate) fn was_found(&self) -> bool {
        let right = |grade| grade == Grade::Correct;
        let is_right = self.grade.is_some_and(right) || self.attempts.iter().any(|attempt| right(attempt.grade));
        if self.revealed { self.found } else { is_right }
    }

    /// The answer once the right one is shown.
    pub(crate) fn shown(self) -> Self {
        Self { found: self.was_found(), revealed: true, ..self }
    }

    /// The answer with another text in the field, which has no grade yet.
    pub(crate) fn typed(self, text: &str) -> Self {
        Self { typed: one_line(text), grade: None, ..self }
    }

    /// The answer with a grade for the text in the field. The same text with the same grade twice in a row is one attempt.
    pub(crate) fn checked(self, grade: Grade) -> Self {
        let attempt = Attempt { typed: self.typed.clone(), grade };
        Self { grade: Some(grade), attempts: with_attempt(self.attempts, attempt), ..self }
    }

    /// Copy of a stored answer within the limits of length and number.
    pub(crate) fn bounded(&self) -> Self {
        let Self { typed, grade, revealed, found, attempts } = self;
        let attempts = attempts.iter().map(|one| Attempt { typed: one_line(&one.typed), grade: one.grade });
        let attempts = attempts.fold(Vec::new(), with_attempt);
        Self { typed: one_line(typed), grade: *grade, revealed: *revealed, found: *found, attempts }
    }

    /// Copy with the grades alone, of the attempts before the last one or of all.
    pub fn without_texts(&self, all: bool) -> Self {
        let mut answer = self.clone();
        let last = answer.attempts.len().saturating_sub(1);
        for (place, attempt) in answer.attempts.iter_mut().enumerate() {
            if all || place < last {
                attempt.typed.clear();
            }
        }
        if all {
            answer.typed.clear();
        }
        answer
    }

    /// Lines of text, the storage format of pages with a single simulation, which contain no JSON parser: the text, the
    /// grade, `revealed`, `found` (shown after it was found) or nothing, then a line for each attempt with its grade before its text.
    pub fn lines(&self) -> String {
        let grade = self.grade.map_or("", Grade::code);
        let revealed = match (self.revealed, self.found) {
            (false, _) => "",
            (true, false) => "revealed",
            (true, true) => "found",
        };
        let mut lines = format!("{}\n{grade}\n{revealed}", self.typed);
        for Attempt { typed, grade } in &self.attempts {
            lines.extend(["\n", grade.code(), " ", typed]);
        }
        lines
    }

    /// Parses the output of [`Answer::lines`]; `None` if a line is missing. An attempt without a known grade is left out.
    pub fn of_lines(text: &str) -> Option<Self> {
        let mut lines = text.split('\n');
        let (typed, grade, revealed) = (lines.next()?, lines.next()?, lines.next()?);
        let attempt = |line: &str| {
            let (grade, typed) = line.split_once(' ')?;
            Some(Attempt { typed: typed.to_owned(), grade: Grade::from_code(grade)? })
        };
        Some(Self {
            typed: typed.to_owned(),
            grade: Grade::from_code(grade),
            revealed: ["revealed", "found"].contains(&revealed),
            found: revealed == "found",
            attempts: lines.filter_map(attempt).collect(),
        })
    }
}

/// Attempts with one more; of more than the maximum the latest.
fn with_attempt(mut attempts: Vec<Attempt>, attempt: Attempt) -> Vec<Attempt> {
    if attempts.last() != Some(&attempt) {
        attempts.push(attempt);
        let extra = attempts.len().saturating_sub(MOST_ATTEMPTS);
        attempts.drain(..extra);
    }
    attempts
}

fn one_line(text: &str) -> String {
    text.replace(['\n', '\r'], " ").chars().take(LONGEST).collect()
}
