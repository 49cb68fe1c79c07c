//! Questions: what an answer is worth.

use crate::controls::preset::assign;
use crate::questions::grade::{Grade, Verdict, grade};
use crate::{Announcement, Play, Refusal, number, words};

impl Play {
    /// Judges an answer: a number or arithmetic in the unit asked for, or with units of its own of the same dimension; with an
    /// error after `±` that is not graded, but compared with the truth. It is kept with the question.
    pub fn check_answer(&mut self, question: usize, text: &str) -> Verdict {
        let verdict = self.judge(question, text);
        self.note_grade(question, text, verdict.grade);
        verdict
    }

    fn judge(&mut self, question: usize, text: &str) -> Verdict {
        let right = self.right_answer(question);
        let Some(asked) = self.program.questions.get(question) else {
            return self.verdict(Grade::Unanswerable);
        };
        let answer = match self.read_answer(text, &asked.unit) {
            Err(refusal) => return Verdict { grade: Grade::Unreadable, text: self.refusal_text(&refusal) },
            Ok(answer) => answer,
        };
        let mut verdict = self.verdict(grade(answer.value, right, asked.tolerance));
        let correct = verdict.grade == Grade::Correct;
        if let Some(error) = answer.error.filter(|_| verdict.grade != Grade::Unanswerable) {
            let within = (answer.value - right).abs() <= error;
            verdict.text = [&verdict.text, " ", words::stated_error(self.language, correct, within)].concat();
        }
        if correct {
            self.solve(question);
        }
        verdict
    }

    /// The right answer with its unit, for the parameters as they are (or as the question supposes); a dash if there is
    /// none.
    pub fn reveal_answer(&mut self, question: usize) -> String {
        self.note_revealed(question);
        self.solve(question);
        self.computed_answer(question)
    }

    /// The same without showing it to who answers: for the teacher's view.
    pub fn computed_answer(&mut self, question: usize) -> String {
        let right = self.right_answer(question);
        let Some(asked) = self.program.questions.get(question) else {
            return String::new();
        };
        self.with_unit(number::plain(asked.unit.from_si(right), 4, self.style), &asked.unit)
    }

    /// The unit in which an answer is asked for, for people.
    pub fn question_unit(&self, question: usize) -> String {
        self.program.questions.get(question).map_or_else(String::new, |asked| number::unit_text(&asked.unit.text))
    }

    /// The names and values of the parameters that a question supposes, `b` and `0 kg/s`, and whether they are set now;
    /// `None` if it supposes none.
    pub fn question_setup(&mut self, question: usize) -> Option<(Vec<(String, String)>, bool)> {
        let parameters = self.supposed_parameters(question);
        let asked = self.program.questions.get(question).filter(|asked| !asked.setup.is_empty())?;
        let set = self.course.parameters() == parameters;
        Some((self.assigned(&asked.setup, &parameters), set))
    }

    /// Sets the parameters that a question supposes.
    pub fn apply_question_setup(&mut self, question: usize) -> Result<(), Refusal> {
        let parameters = self.supposed_parameters(question);
        let unknown = || Refusal::Unknown { name: question.to_string() };
        let asked = self.program.questions.get(question).ok_or_else(unknown)?;
        let parameters = self.admit_assignments(&asked.setup, parameters)?;
        self.overwrite_parameters(parameters);
        self.announce(Announcement::QuestionSetup(question));
        Ok(())
    }

    /// Whether questions of the document hide values.
    pub fn hides_values(&self) -> bool {
        self.program.questions.iter().any(|question| !question.hides.is_empty())
    }

    /// Whether the values that questions hide are shown all the same.
    pub fn shows_hidden(&self) -> bool {
        self.shows_hidden
    }

    /// Shows the values that questions hide, or hides them again until the questions are answered. Links say which.
    pub fn show_hidden(&mut self, show: bool) {
        self.shows_hidden = show;
        self.revision.frame += 1;
    }

    /// Whether the value of a quantity is hidden: an open question asks for it.
    pub(crate) fn is_hidden(&self, quantity: usize) -> bool {
        let open = self.program.questions.iter().zip(&self.solved).filter(|(_, solved)| !**solved);
        !self.shows_hidden && open.map(|(question, _)| question).any(|question| question.hides.contains(&quantity))
    }

    /// The earlier questions that must be answered before this one appears.
    pub fn awaited_questions(&self, question: usize) -> Vec<usize> {
        let after = self.program.questions.get(question).map_or(&[][..], |asked| &asked.after);
        let is_open = |other: &usize| self.solved.get(*other) == Some(&false);
        after.iter().copied().filter(is_open).collect()
    }

    /// The answer to a question is known: what it hides is shown.
    pub(crate) fn solve(&mut self, question: usize) {
        if let Some(solved) = self.solved.get_mut(question).filter(|solved| !**solved) {
            *solved = true;
            self.revision.frame += 1;
        }
    }

    fn verdict(&self, grade: Grade) -> Verdict {
        Verdict { grade, text: words::grade(self.language, grade).to_owned() }
    }

    /// The answer (SI), not a number if there is none.
    fn right_answer(&mut self, question: usize) -> f64 {
        let parameters = self.supposed_parameters(question);
        let initial = self.initial_for(&parameters);
        let answers = self.evaluators.answers.at(&parameters, &initial, 0.0, &initial);
        answers.get(question).copied().unwrap_or(f64::NAN)
    }

    /// The present parameters with those that a question supposes in their place.
    fn supposed_parameters(&mut self, question: usize) -> Vec<f64> {
        let questions = &self.program.questions;
        let first = questions.iter().take(question).map(|question| question.setup.len()).sum();
        let setup = questions.get(question).map_or(&[][..], |asked| &asked.setup);
        assign(&mut self.evaluators.setups, first, setup, self.course.parameters(), self.course.initial())
    }
}
