//! What a person has answered: kept with the question, whichever language it is read in, and for the next visit.

use crate::name_of;
use crate::questions::given::Answer;
use crate::questions::grade::{Grade, Verdict};
use crate::{Play, words};

/// An answer as its question shows it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AnswerView {
    /// What stands in the field.
    pub typed: String,
    /// What it is worth, if it has been checked.
    pub verdict: Option<Verdict>,
    /// Whether the right answer has been shown.
    pub revealed: bool,
}

/// The longest answer that is kept, in characters.
const LONGEST: usize = 300;

impl Play {
    /// What has been answered to a question.
    pub fn answer(&self, question: usize) -> AnswerView {
        let Some(answer) = self.answers.get(question) else { return AnswerView::default() };
        let verdict = |grade| Verdict { grade, text: words::grade(self.language, grade).to_owned() };
        AnswerView { typed: answer.typed.clone(), verdict: answer.grade.map(verdict), revealed: answer.revealed }
    }

    /// Notes what stands in the field of a question; it has not been checked.
    pub fn type_answer(&mut self, question: usize, text: &str) {
        self.note_answer(question, |answer| {
            answer.typed = text.replace(['\n', '\r'], " ").chars().take(LONGEST).collect();
            answer.grade = None;
        });
    }

    /// Notes what the text in the field of a question is worth.
    pub(crate) fn note_grade(&mut self, question: usize, text: &str, grade: Grade) {
        self.type_answer(question, text);
        self.note_answer(question, |answer| answer.grade = Some(grade));
    }

    /// Notes that the right answer has been shown.
    pub(crate) fn note_revealed(&mut self, question: usize) {
        self.note_answer(question, |answer| answer.revealed = true);
    }

    /// The answers for the next visit, with the names of their questions, which are the same in all languages of the document.
    pub fn saved_answers(&self) -> Vec<(String, Answer)> {
        let given = self.question_names().into_iter().zip(self.answers.iter().cloned());
        given.filter(|(_, answer)| *answer != Answer::default()).collect()
    }

    /// Brings back the answer to the question of this name. Whether there is one.
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
        if question < self.program.questions.len() {
            self.answers.resize(self.program.questions.len(), Answer::default());
            if let Some(answer) = self.answers.get_mut(question) {
                note(answer);
            }
            self.revision.answers += 1;
        }
    }

    /// Names of the questions by their words in the document's own language, so that an answer stays with its question when
    /// others are put before it; questions with the same words are distinguished by their order.
    pub(crate) fn question_names(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for index in 0..self.program.questions.len() {
            let prompt = &self.program.question_text(&self.program.language, index).prompt;
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
