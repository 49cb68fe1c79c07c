//! Stated values that are not the computed ones.

use crate::grades::grade_name;
use desk::play::{Grade, UNKNOWN_GRADE};
use saved::Number;
use saved::hand_in::{Fact, FactValue, Part, quantity_text};
use units::{Language, say};

/// A stated value that does not follow from the work.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Part of the work.
    pub part: Part,
    /// Name of the record, fit, question or film.
    pub item: String,
    /// Identifier of the quantity.
    pub quantity: String,
    /// The stated value; `None` if the hand-in does not state it.
    pub stated: Option<FactValue>,
    /// The computed value; `None` if the work does not give it.
    pub computed: Option<FactValue>,
}

/// An answer whose stated grade is not the one that follows from it and from its values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GradeDifference {
    /// Number of the question.
    pub question: String,
    /// Number of the attempt.
    pub attempt: String,
    /// The grade that the page of the student stated.
    pub stated: Grade,
    /// The grade that follows.
    pub computed: Grade,
}

impl GradeDifference {
    /// One line: question, attempt and both grades.
    pub fn text(&self, language: Language) -> String {
        let (question, attempt) = (shortened(&self.question), shortened(&self.attempt));
        let (stated, computed) = (grade_name(self.stated, language), grade_name(self.computed, language));
        say!(language, "question {question}, attempt {attempt}: stated \"{stated}\", computed \"{computed}\"")
    }

    /// Grades given in the page that differ from the computed ones, and the number of those that cannot be computed. `computed`:
    /// facts of the answers.
    pub(super) fn all(computed: &[Fact]) -> (Vec<Self>, usize) {
        let text = |quantity: &str, item: &str| {
            let found = computed
                .iter()
                .find(|fact| fact.part == Part::Answer && fact.item == item && fact.quantity == quantity);
            found.and_then(|fact| match &fact.value {
                FactValue::Text(text) => Some(text.as_str()),
                FactValue::Number(_) => None,
            })
        };
        let (mut differences, mut unknown) = (Vec::new(), 0);
        for fact in computed.iter().filter(|fact| fact.part == Part::Answer) {
            let Some(attempt) = fact.quantity.strip_prefix("grade:") else { continue };
            let given = text(&format!("given:{attempt}"), &fact.item).and_then(Grade::from_code);
            let follows = text(&fact.quantity, &fact.item);
            unknown += usize::from(follows == Some(UNKNOWN_GRADE));
            if let (Some(stated), Some(follows)) = (given, follows.and_then(Grade::from_code))
                && stated != follows
            {
                let (question, attempt) = (fact.item.clone(), attempt.to_owned());
                differences.push(Self { question, attempt, stated, computed: follows });
            }
        }
        (differences, unknown)
    }
}

/// Attempts at a question beyond the number that the document allows. They do not count; two devices of one student can make them
/// without a network.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BeyondLimit {
    /// Number of the question.
    pub question: String,
    /// Number of attempts.
    pub made: usize,
    /// Number of attempts that count.
    pub allowed: usize,
}

impl BeyondLimit {
    /// One line: question and both numbers.
    pub fn text(&self, language: Language) -> String {
        let (question, made, allowed) = (shortened(&self.question), self.made, self.allowed);
        say!(language, "question {question}: {made} attempts, of which only the first {allowed} count")
    }

    /// Questions with more attempts than allowed. `computed`: facts of the answers.
    pub(super) fn all(computed: &[Fact]) -> Vec<Self> {
        let number = |item: &str, quantity: &str| {
            let is_it = |fact: &&Fact| fact.part == Part::Answer && fact.item == item && fact.quantity == quantity;
            match computed.iter().find(is_it)?.value {
                FactValue::Number(Number(number)) => Some(number as usize),
                FactValue::Text(_) => None,
            }
        };
        let limits = computed.iter().filter(|fact| fact.part == Part::Answer && fact.quantity == "allowed");
        let questions = limits.filter_map(|fact| {
            let question = fact.item.clone();
            let (allowed, made) = (number(&question, "allowed")?, number(&question, "made")?);
            (made > allowed).then_some(Self { question, made, allowed })
        });
        questions.collect()
    }
}

impl Difference {
    /// One line: place, stated and computed value.
    pub fn text(&self, language: Language) -> String {
        let nothing = language.say("nothing");
        let value = |value: &Option<FactValue>| match value {
            None => nothing.to_owned(),
            Some(FactValue::Number(Number(number))) => format!("{number}"),
            Some(FactValue::Text(text)) => format!("\"{}\"", shortened(text)),
        };
        let (stated, computed) = (language.say("stated"), language.say("computed"));
        let quantity = quantity_text(&self.quantity, language);
        let (part, item, quantity) = (self.part.words(), shortened(&self.item), shortened(&quantity));
        let part = part.text(language);
        format!("{part} \"{item}\", {quantity}: {stated} {}, {computed} {}", value(&self.stated), value(&self.computed))
    }
}

/// Text of a stranger in one line of bounded length.
pub(super) fn shortened(text: &str) -> String {
    const MOST: usize = 120;
    let line: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).take(MOST).collect();
    if text.chars().nth(MOST).is_some() { format!("{line}…") } else { line }
}
