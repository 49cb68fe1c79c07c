//! Checking of answers, and values hidden by questions.

use crate::controls::preset::assign;
use crate::questions::grade::{Grade, Verdict, grade};
use crate::{Announcement, Changes, Play, Refusal, number, words};

impl Play {
    /// Grades an answer: a number or arithmetic in the expected unit, or with its own units of the same dimension. An
    /// error after `±` is not graded, but compared with the actual error. The answer is stored with the question.
    pub fn check_answer(&mut self, question: usize, text: &str) -> Verdict {
        let verdict = self.judge(question, text);
        self.note_grade(question, text, verdict.grade);
        verdict
    }

    fn judge(&mut self, question: usize, text: &str) -> Verdict {
        let right = self.right_answer(question);
        let Some(asked) = self.basis.program().questions.get(question) else {
            return self.verdict(Grade::Unanswerable);
        };
        let answer = match self.basis.read_answer(&self.course, text, &asked.unit) {
            Err(refusal) => return Verdict { grade: Grade::Unreadable, text: self.basis.refusal_text(&refusal) },
            Ok(answer) => answer,
        };
        let mut verdict = self.verdict(grade(answer.value, right, asked.tolerance));
        let correct = verdict.grade == Grade::Correct;
        if let Some(error) = answer.error.filter(|_| verdict.grade != Grade::Unanswerable) {
            let within = (answer.value - right).abs() <= error;
            verdict.text = [&verdict.text, " ", words::stated_error(self.basis.language(), correct, within)].concat();
        }
        if correct {
            self.solve(question);
        }
        verdict
    }

    /// Right answer with its unit, for the present parameters or those assumed by the question; a dash if there is
    /// none. Marks the question as solved.
    pub fn reveal_answer(&mut self, question: usize) -> String {
        self.note_revealed(question);
        self.solve(question);
        self.computed_answer(question)
    }

    /// Right answer as in [`Play::reveal_answer`], without marking it as shown: for the teacher's view.
    pub fn computed_answer(&mut self, question: usize) -> String {
        let right = self.right_answer(question);
        let Some(asked) = self.basis.program().questions.get(question) else {
            return String::new();
        };
        number::with_unit(&number::plain(asked.unit.from_si(right), 4, self.basis.style()), &asked.unit)
    }

    /// Unit in which an answer is expected, as displayed.
    pub fn question_unit(&self, question: usize) -> String {
        self.basis
            .program()
            .questions
            .get(question)
            .map_or_else(String::new, |asked| number::unit_text(&asked.unit.text))
    }

    /// Names and values of the parameters that a question assumes, such as `b` and `0 kg/s`, and true if they are set
    /// now; `None` if it assumes none.
    pub fn question_setup(&mut self, question: usize) -> Option<(Vec<(String, String)>, bool)> {
        let parameters = self.supposed_parameters(question);
        let asked = self.basis.program().questions.get(question).filter(|asked| !asked.setup.is_empty())?;
        let set = self.course.parameters() == parameters;
        Some((self.basis.assigned(&asked.setup, &parameters), set))
    }

    /// Sets the parameters that a question assumes.
    pub fn apply_question_setup(&mut self, question: usize) -> Result<(), Refusal> {
        let parameters = self.supposed_parameters(question);
        let unknown = || Refusal::Unknown { name: question.to_string() };
        let asked = self.basis.program().questions.get(question).ok_or_else(unknown)?;
        let parameters = self.basis.admit_assignments(&asked.setup, parameters)?;
        self.overwrite_parameters(parameters);
        self.announce(Announcement::QuestionSetup(question));
        Ok(())
    }

    /// True if questions of the document hide values.
    pub fn hides_values(&self) -> bool {
        self.basis.program().questions.iter().any(|question| !question.hides.is_empty())
    }

    /// True if values hidden by questions are shown anyway.
    pub fn shows_hidden(&self) -> bool {
        self.shows_hidden
    }

    /// Shows the values that questions hide, or hides them again until the questions are answered. Links store this
    /// choice.
    pub fn show_hidden(&mut self, show: bool) {
        self.shows_hidden = show;
        self.note(Changes::FRAME);
    }

    /// True if the value of a quantity is hidden because an open question asks for it.
    pub(crate) fn is_hidden(&self, quantity: usize) -> bool {
        let open = self.basis.program().questions.iter().zip(&self.solved).filter(|(_, solved)| !**solved);
        !self.shows_hidden && open.map(|(question, _)| question).any(|question| question.hides.contains(&quantity))
    }

    /// Earlier questions that must be answered before this one appears.
    pub fn awaited_questions(&self, question: usize) -> Vec<usize> {
        let after = self.basis.program().questions.get(question).map_or(&[][..], |asked| &asked.after);
        let is_open = |other: &usize| self.solved.get(*other) == Some(&false);
        after.iter().copied().filter(is_open).collect()
    }

    /// Marks a question as solved: the values that it hides are shown.
    pub(crate) fn solve(&mut self, question: usize) {
        if let Some(solved) = self.solved.get_mut(question).filter(|solved| !**solved) {
            *solved = true;
            self.note(Changes::FRAME);
        }
    }

    fn verdict(&self, grade: Grade) -> Verdict {
        Verdict { grade, text: words::grade(self.basis.language(), grade).to_owned() }
    }

    /// Right answer (SI); NaN if there is none.
    fn right_answer(&mut self, question: usize) -> f64 {
        let parameters = self.supposed_parameters(question);
        let initial = self.initial_for(&parameters);
        let answers = self.evaluators.answers.at(&parameters, &initial, 0.0, &initial);
        answers.get(question).copied().unwrap_or(f64::NAN)
    }

    /// Present parameters (SI), replaced by the values that a question assumes.
    fn supposed_parameters(&mut self, question: usize) -> Vec<f64> {
        let questions = &self.basis.program().questions;
        let first = questions.iter().take(question).map(|question| question.setup.len()).sum();
        let setup = questions.get(question).map_or(&[][..], |asked| &asked.setup);
        assign(&mut self.evaluators.setups, first, setup, self.course.parameters(), self.course.initial())
    }
}
