//! The user's answers: kept with their questions across languages and stored for the next visit.

use crate::questions::given::Answer;
use crate::questions::grade::{Grade, Verdict};
use crate::{Changes, Play, name_of, words};

/// An answer, for display with its question.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AnswerView {
    /// Text in the field.
    pub typed: String,
    /// Grade, if the answer has been checked.
    pub verdict: Option<Verdict>,
    /// True if the right answer has been shown.
    pub revealed: bool,
}

/// Maximum length of a stored answer, in characters.
const LONGEST: usize = 300;

impl Play {
    /// The user's answer to a question; empty if there is none.
    pub fn answer(&self, question: usize) -> AnswerView {
        let Some(answer) = self.answers.get(question) else { return AnswerView::default() };
        let verdict = |grade| Verdict { grade, text: words::grade(self.basis.language(), grade).to_owned() };
        AnswerView { typed: answer.typed.clone(), verdict: answer.grade.map(verdict), revealed: answer.revealed }
    }

    /// Stores the text in the field of a question as an unchecked answer.
    pub fn type_answer(&mut self, question: usize, text: &str) {
        self.note_answer(question, |answer| {
            answer.typed = text.replace(['\n', '\r'], " ").chars().take(LONGEST).collect();
            answer.grade = None;
        });
    }

    /// Stores the text in the field of a question together with its grade.
    pub(crate) fn note_grade(&mut self, question: usize, text: &str, grade: Grade) {
        self.type_answer(question, text);
        self.note_answer(question, |answer| answer.grade = Some(grade));
    }

    /// Records that the right answer has been shown.
    pub(crate) fn note_revealed(&mut self, question: usize) {
        self.note_answer(question, |answer| answer.revealed = true);
    }

    /// Answers to be stored for the next visit, with the names of their questions. The names do not depend on the
    /// language.
    pub fn saved_answers(&self) -> Vec<(String, Answer)> {
        let given = self.question_names().into_iter().zip(self.answers.iter().cloned());
        given.filter(|(_, answer)| *answer != Answer::default()).collect()
    }

    /// Restores the answer to the question with this name. Returns false if there is no such question.
    pub fn restore_answer(&mut self, name: &str, saved: &Answer) -> bool {
        let Some(question) = self.question_names().iter().position(|own| own == name) else { return false };
        self.type_answer(question, &saved.typed);
        self.note_answer(question, |answer| (answer.grade, answer.revealed) = (saved.grade, saved.revealed));
        if saved.revealed || saved.grade == Some(Grade::Correct) {
            self.solve(question);
        }
        true
    }

    pub(crate) fn note_answer(&mut self, question: usize, note: impl FnOnce(&mut Answer)) {
        if question < self.basis.program().questions.len() {
            self.answers.resize(self.basis.program().questions.len(), Answer::default());
            if let Some(answer) = self.answers.get_mut(question) {
                note(answer);
            }
            self.note(Changes::ANSWERS);
        }
    }

    /// Names of the questions, derived from their texts in the document's own language, so that an answer stays with
    /// its question if others are inserted before it. Questions with equal texts are numbered.
    pub(crate) fn question_names(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for index in 0..self.basis.program().questions.len() {
            let prompt = &self.basis.program().question_text(&self.basis.program().language, index).prompt;
            let mut again = 0;
            let mut name = name_of(&[prompt]);
            while names.contains(&name) {
                again += 1;
                name = name_of(&[prompt, &again.to_string()]);
            }
            names.push(name);
        }
        names
    }
}
