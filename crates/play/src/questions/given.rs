//! An answer of the user, with its grade and all attempts.

use crate::questions::grade::Grade;
use serde::{Deserialize, Serialize};
use units::number::compact as exact;

/// Maximum number of attempts at a question that are kept.
const MOST_ATTEMPTS: usize = 100;

/// Maximum length of a stored answer, in characters.
const LONGEST: usize = 300;

/// Maximum number of values of an attempt, and maximum length of a name and of a language tag, in characters.
const MOST_VALUES: usize = 100;
const LONGEST_WORD: usize = 100;

/// Conditions under which an answer was given. With the values of the seat they decide its grade.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Conditions {
    /// Tag of the language in which the answer was typed. It decides between decimal point and comma.
    pub language: String,
    /// Names and values (SI) of the parameters that the reader sets and on which the right answer depends.
    pub values: Vec<(String, f64)>,
}

/// An answer that has been checked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attempt {
    /// Text in the field; empty if it was left out because the storage has no room.
    pub typed: String,
    /// The grade that was stated when it was checked.
    pub grade: Grade,
    /// Its conditions; `None` if they are unknown, as in work of versions up to 0.2.0.
    pub conditions: Option<Conditions>,
}

/// An answer that has been checked, with its grades.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GradedAttempt {
    /// Text in the field.
    pub typed: String,
    /// Grade that was stated when it was checked.
    pub stated: Grade,
    /// Grade that follows from the text and its conditions; `None` if those are unknown.
    pub computed: Option<Grade>,
    /// Its conditions; `None` if they are unknown.
    pub conditions: Option<Conditions>,
    /// The right answer with its unit under these conditions; empty if they are unknown.
    pub right: String,
}

impl GradedAttempt {
    /// The computed grade, or the stated one if none can be computed.
    pub fn grade(&self) -> Grade {
        self.computed.unwrap_or(self.stated)
    }
}

/// The user's answer to a question.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// Text in the field, at most 300 characters in one line.
    pub typed: String,
    /// Grade, if the answer has been checked.
    pub grade: Option<Grade>,
    /// Number of attempts before the right answer was shown; `None` if it was not shown.
    pub shown: Option<usize>,
    /// All answers that have been checked, in order, at most 100.
    pub attempts: Vec<Attempt>,
}

impl Answer {
    /// Copy for a question whose right answer is another one now: without grade, attempts and the shown answer.
    pub(crate) fn unchecked(&self) -> Self {
        Self { typed: self.typed.clone(), ..Self::default() }
    }

    /// The answer with the attempts that another device has stored: those that both have at the beginning, then the other's, then one's
    /// own. The right answer was shown where one of them has shown it first.
    pub(crate) fn merged(&self, other: &Self) -> Self {
        let common = self.attempts.iter().zip(&other.attempts).take_while(|(one, other)| one == other).count();
        let moved = |place: usize| if place > common { place - common + other.attempts.len() } else { place };
        let own_shown = self.shown.map(moved);
        let shown = other.shown.into_iter().chain(own_shown).min();
        let own = self.attempts.get(common..).unwrap_or_default();
        let field = if self.typed.is_empty() { other } else { self };
        let attempts = [&other.attempts[..], own].concat();
        Self { typed: field.typed.clone(), grade: field.grade, shown, attempts }.bounded()
    }

    /// The last attempt, if it is the text in the field.
    pub(crate) fn checked_attempt(&self) -> Option<&Attempt> {
        self.grade?;
        self.attempts.last().filter(|attempt| attempt.typed == self.typed)
    }

    /// The answer once the right one is shown.
    pub(crate) fn shown(self) -> Self {
        Self { shown: self.shown.or(Some(self.attempts.len())), ..self }
    }

    /// The answer with another text in the field, which has no grade yet.
    pub(crate) fn typed(self, text: &str) -> Self {
        Self { typed: one_line(text), grade: None, ..self }
    }

    /// The answer with a grade for the text in the field. The same text with the same grade twice in a row is one attempt.
    pub(crate) fn checked(self, grade: Grade, conditions: Conditions) -> Self {
        let attempt = Attempt { typed: self.typed.clone(), grade, conditions: Some(conditions) };
        Self { grade: Some(grade), ..self }.with_attempt(attempt)
    }

    /// Copy of a stored answer within the limits of length and number.
    pub(crate) fn bounded(&self) -> Self {
        let Self { typed, grade, shown, attempts } = self;
        let bounded = |one: &Attempt| Attempt {
            typed: one_line(&one.typed),
            grade: one.grade,
            conditions: one.conditions.as_ref().map(Conditions::bounded),
        };
        let empty = Self { typed: one_line(typed), grade: *grade, shown: *shown, attempts: Vec::new() };
        attempts.iter().map(bounded).fold(empty, Self::with_attempt)
    }

    /// The answer with one more attempt. Of more than the maximum the first is left out that is no attempt, so that a limited number
    /// of attempts cannot be had again; without such ones the first of all.
    fn with_attempt(mut self, attempt: Attempt) -> Self {
        if self.attempts.last() != Some(&attempt) {
            self.attempts.push(attempt);
            if self.attempts.len() > MOST_ATTEMPTS {
                let place = self.attempts.iter().position(|one| !one.grade.is_attempt()).unwrap_or(0);
                self.attempts.remove(place);
                self.shown = self.shown.map(|before| if place < before { before - 1 } else { before });
            }
        }
        self
    }

    /// Copy with the grades alone, of the attempts before the last one or of all.
    pub fn without_texts(&self, all: bool) -> Self {
        let mut answer = self.clone();
        let last = answer.attempts.len().saturating_sub(1);
        for (place, attempt) in answer.attempts.iter_mut().enumerate() {
            if all || place < last {
                attempt.typed.clear();
                attempt.conditions = None;
            }
        }
        if all {
            answer.typed.clear();
        }
        answer
    }

    /// Lines of text, the storage format of pages with a single simulation, which contain no JSON parser: the text, the
    /// grade, `shown` with the number of attempts before or nothing, then a line for each attempt: its grade, conditions such as
    /// `;es;k:20,m:0.5` if they are known, and its text after a blank.
    pub fn lines(&self) -> String {
        let grade = self.grade.map_or_else(Default::default, Grade::code);
        let shown = self.shown.map_or_else(String::new, |before| format!("shown {before}"));
        let mut lines = format!("{}\n{grade}\n{shown}", self.typed);
        for Attempt { typed, grade, conditions } in &self.attempts {
            let conditions = conditions.as_ref().map_or_else(String::new, |own| format!(";{}", own.text()));
            lines.extend(["\n", &grade.code(), &conditions, " ", typed]);
        }
        lines
    }

    /// Parses the output of [`Answer::lines`]; `None` if a line is missing. An attempt without a known grade is left out.
    pub fn of_lines(text: &str) -> Option<Self> {
        let mut lines = text.split('\n');
        let (typed, grade, revealed) = (lines.next()?, lines.next()?, lines.next()?);
        let attempt = |line: &str| {
            let (grade, typed) = line.split_once(' ')?;
            let (grade, conditions) = match grade.split_once(';') {
                Some((grade, conditions)) => (grade, Some(Conditions::of_text(conditions)?)),
                None => (grade, None),
            };
            Some(Attempt { typed: typed.to_owned(), grade: Grade::from_code(grade)?, conditions })
        };
        let attempts: Vec<Attempt> = lines.filter_map(attempt).collect();
        let shown = match revealed {
            "revealed" => Self::shown_of_0_2(true, false, attempts.len()),
            "found" => Self::shown_of_0_2(true, true, attempts.len()),
            _ => revealed.strip_prefix("shown ").and_then(|before| before.parse().ok()),
        };
        Some(Self { typed: typed.to_owned(), grade: Grade::from_code(grade), shown, attempts })
    }

    /// Number of attempts before the right answer was shown, from what versions up to 0.2.0 stored: true if it was shown, and true
    /// if it had been found then.
    pub fn shown_of_0_2(revealed: bool, found: bool, attempts: usize) -> Option<usize> {
        revealed.then_some(if found { attempts } else { 0 })
    }
}

impl Conditions {
    fn bounded(&self) -> Self {
        let word = |text: &str| one_line(text).chars().take(LONGEST_WORD).collect();
        let values = self.values.iter().take(MOST_VALUES).map(|(name, value)| (word(name), *value)).collect();
        Self { language: word(&self.language), values }
    }

    /// Language and values in one word: `es;k:20,m:0.5`.
    pub fn text(&self) -> String {
        let values = self.values.iter().map(|(name, value)| format!("{name}:{}", exact(*value)));
        format!("{};{}", self.language, values.collect::<Vec<_>>().join(","))
    }

    /// Reads the output of [`Conditions::text`].
    fn of_text(text: &str) -> Option<Self> {
        let (language, values) = text.split_once(';')?;
        let value = |one: &str| {
            let (name, value) = one.split_once(':')?;
            Some((name.to_owned(), units::number::decimal(value)?))
        };
        let values = values.split(',').filter(|one| !one.is_empty()).map(value).collect::<Option<_>>()?;
        Some(Self { language: language.to_owned(), values })
    }
}

fn one_line(text: &str) -> String {
    text.replace(['\n', '\r'], " ").chars().take(LONGEST).collect()
}
