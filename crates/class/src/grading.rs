//! Grades of answers by a document, which is the teacher's own if there is one. The report, the dashboard, the verification and the
//! class server count these grades.

use desk::answer_of_item;
use desk::play::{Grade, GradedAttempt, Marker};
use document::page::Source;
use program::{Program, Seat};
use saved::Item;
use serde::{Deserialize, Serialize};

/// A question, and the answer of the group.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GivenAnswer {
    /// Title of the document.
    pub document: String,
    /// Index of the question.
    pub question: usize,
    /// Text of the question.
    pub prompt: String,
    /// Text in the field; empty if nothing was typed.
    pub typed: String,
    /// All answers that were checked, in order, with their grades.
    pub attempts: Vec<GradedAttempt>,
    /// Number of attempts before the right answer was shown; `None` if it was not shown.
    pub shown: Option<usize>,
    /// True if a right answer was given, and before the right answer was shown.
    pub found: bool,
    /// Share of the credit, from 0 to 1.
    pub credit: f64,
}

impl GivenAnswer {
    /// True if the first attempt is right, and the right answer was not shown before it.
    pub fn is_first_right(&self) -> bool {
        self.shown != Some(0) && self.attempts.first().is_some_and(|attempt| attempt.grade() == Grade::Correct)
    }
}

/// Grades answers to the questions of a document.
#[derive(Debug)]
pub struct Grader(Marker);

impl Grader {
    /// Grades by a document with its translations; `None` if it has errors.
    pub fn open(sources: &[Source], language: &str) -> Option<Self> {
        let (first, translations) = sources.split_first()?;
        let translations: Vec<&str> = translations.iter().map(|source| source.text.as_str()).collect();
        Some(Self::new(document::open(&first.text, &translations).sound()?.program, language))
    }

    /// Grades by a program. `language`: tag of the language of its texts.
    pub fn new(program: Program, language: &str) -> Self {
        Self(Marker::new(program, language))
    }

    /// All questions, each with the answer among these items of a work, for a seat.
    pub fn answers(&mut self, seat: Option<Seat>, items: &[(String, String)]) -> Vec<GivenAnswer> {
        let count = self.0.program().questions.len();
        let mut given: Vec<desk::play::Answer> = vec![desk::play::Answer::default(); count];
        for (name, text) in items {
            let answer = Item::read(text).and_then(|(_, item)| answer_of_item(&item));
            if let (Some(answer), Some(place)) = (answer, self.0.question(name).and_then(|place| given.get_mut(place)))
            {
                *place = answer;
            }
        }
        given.iter().enumerate().map(|(question, answer)| self.marked(seat, question, answer)).collect()
    }

    /// The answer in the text of an item to the question of this name, for a seat; `None` if it is no answer, or if there is no such
    /// question.
    pub fn answer(&mut self, seat: Option<Seat>, name: &str, item: &str) -> Option<GivenAnswer> {
        let answer = answer_of_item(&Item::read(item)?.1)?;
        Some(self.marked(seat, self.0.question(name)?, &answer))
    }

    fn marked(&mut self, seat: Option<Seat>, question: usize, answer: &desk::play::Answer) -> GivenAnswer {
        let view = self.0.marked(seat, question, answer);
        let program = self.0.program();
        GivenAnswer {
            document: program.title.clone(),
            question,
            prompt: program.question_text(self.0.language(), question).prompt.clone(),
            typed: view.typed,
            attempts: view.attempts,
            shown: view.shown,
            found: view.found,
            credit: view.credit,
        }
    }
}
