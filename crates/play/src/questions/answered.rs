//! The user's answers, their grades, and values hidden by open questions. Answers are kept with their questions across
//! languages and stored for the next visit.

use crate::questions::given::{Answer, Attempt, Conditions, GradedAttempt};
use crate::questions::grade::{Grade, Verdict};
use crate::questions::grading::{Grading, verdict_of};
use crate::{Basis, Changes, Course, OpenRun, Refusal, name_of, number, words};
use program::{ChoiceAnswer, Program, QuestionKind};

/// Significant digits of the right answer.
const RIGHT_DIGITS: usize = 4;

/// An answer, for display with its question.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AnswerView {
    /// Text in the field.
    pub typed: String,
    /// Grade, if the answer has been checked.
    pub verdict: Option<Verdict>,
    /// Grade that was stated, if the answer has been checked.
    pub stated: Option<Grade>,
    /// Number of attempts before the right answer was shown; `None` if it was not shown.
    pub shown: Option<usize>,
    /// True if a right answer was given, and before the right answer was shown.
    pub found: bool,
    /// Share of the credit, from 0 to 1: the best of the attempts that count.
    pub credit: f64,
    /// Answers that have been checked, in order.
    pub attempts: Vec<GradedAttempt>,
    /// Limit of the attempts; `None` if the question has none.
    pub limit: Option<Limit>,
}

/// Limited attempts at a question. An answer that cannot be read is no attempt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limit {
    /// Number of attempts that count.
    pub allowed: usize,
    /// Number of attempts that were made, perhaps on several devices, so that they can be more.
    pub made: usize,
}

impl Limit {
    /// Number of attempts that are left.
    pub fn left(self) -> usize {
        self.allowed.saturating_sub(self.made)
    }
}

/// The user's answers, and the values hidden by open questions.
#[derive(Debug)]
pub struct Answers {
    /// One per question.
    given: Vec<Answer>,
    /// For each question, true if it has been answered or its answer shown.
    solved: Vec<bool>,
    /// True if values hidden by questions are shown anyway.
    shows_hidden: bool,
    grading: Grading,
}

impl Answers {
    /// No answers.
    pub(crate) fn new(program: &Program) -> Self {
        let count = program.questions.len();
        Self {
            given: vec![Answer::default(); count],
            solved: vec![false; count],
            shows_hidden: false,
            grading: Grading::new(program),
        }
    }

    /// Must be called when the model has changed.
    pub(crate) fn model_changed(&mut self, program: &Program) {
        self.grading = Grading::new(program);
    }

    /// The user's answer to a question; empty if there is none.
    pub fn answer(&self, basis: &Basis, question: usize) -> AnswerView {
        self.given.get(question).map_or_else(AnswerView::default, |answer| self.marked(basis, question, answer))
    }

    /// An answer to a question with its grades.
    pub(crate) fn marked(&self, basis: &Basis, question: usize, answer: &Answer) -> AnswerView {
        AnswerView {
            typed: answer.typed.clone(),
            verdict: self.present_verdict(basis, question, answer),
            stated: answer.grade,
            shown: answer.shown,
            found: self.credit(basis, question, answer) >= 1.0,
            credit: self.credit(basis, question, answer),
            attempts: answer.attempts.iter().map(|attempt| self.graded(basis, question, attempt)).collect(),
            limit: self.limit(basis, question, answer),
        }
    }

    /// Limit of the attempts at a question.
    fn limit(&self, basis: &Basis, question: usize, answer: &Answer) -> Option<Limit> {
        let allowed = basis.program().questions.get(question)?.attempts? as usize;
        let attempts = answer.attempts.iter().filter(|attempt| self.grade(basis, question, attempt).is_attempt());
        Some(Limit { allowed, made: attempts.count() })
    }

    /// The computed grade of an attempt, or the stated one if none can be computed.
    fn grade(&self, basis: &Basis, question: usize, attempt: &Attempt) -> Grade {
        self.grading.grade(basis, question, attempt).unwrap_or(attempt.grade)
    }

    fn graded(&self, basis: &Basis, question: usize, attempt: &Attempt) -> GradedAttempt {
        let conditions = self.grading.known_conditions(basis, question, attempt);
        let right = conditions.as_ref().map(|conditions| self.right_under(basis, question, conditions));
        GradedAttempt {
            typed: attempt.typed.clone(),
            stated: attempt.grade,
            computed: self.grading.grade(basis, question, attempt),
            conditions: attempt.conditions.clone(),
            right: right.unwrap_or_default(),
        }
    }

    /// Grade of the text in the field: computed if its conditions are known, otherwise as it was stated.
    fn present_verdict(&self, basis: &Basis, question: usize, answer: &Answer) -> Option<Verdict> {
        let stated = answer.grade?;
        let computed = answer.checked_attempt().and_then(|attempt| {
            let conditions = self.grading.known_conditions(basis, question, attempt)?;
            Some(self.grading.judge(basis, question, &attempt.typed, &conditions))
        });
        Some(computed.unwrap_or_else(|| verdict_of(stated, basis.language())))
    }

    /// Best credit of the attempts before the right answer was shown, and within the limit of the attempts.
    fn credit(&self, basis: &Basis, question: usize, answer: &Answer) -> f64 {
        let allowed = basis.program().questions.get(question).and_then(|asked| asked.attempts);
        let before = answer.attempts.iter().take(answer.shown.unwrap_or(usize::MAX));
        let grades = before.map(|attempt| self.grade(basis, question, attempt)).filter(|grade| grade.is_attempt());
        // An answer may have been stored without its attempts.
        let stated = answer.grade.filter(|_| answer.attempts.is_empty() && answer.shown.is_none());
        let counted = grades.take(allowed.map_or(usize::MAX, |allowed| allowed as usize)).chain(stated);
        counted.map(Grade::credit).fold(0.0, f64::max)
    }

    /// Stores the text in the field of a question as an unchecked answer.
    pub fn type_text(&mut self, question: usize, text: &str) -> Changes {
        let Some(answer) = self.given.get_mut(question) else { return Changes::NONE };
        *answer = std::mem::take(answer).typed(text);
        Changes::ANSWERS
    }

    /// Grades an answer: a number or arithmetic in the expected unit, or with its own units of the same dimension. An
    /// error after `±` is not graded, but compared with the actual error. The answer is stored with the question and with the
    /// present values on which its grade depends. If no attempt is left, it is neither graded nor stored, and the text says so.
    pub fn check(&mut self, run: OpenRun<'_>, question: usize, text: &str) -> (Verdict, Changes) {
        let given = self.given.get(question);
        if given.and_then(|answer| self.limit(run.basis, question, answer)).is_some_and(|limit| limit.left() == 0) {
            let grade = given.and_then(|answer| answer.grade).unwrap_or(Grade::Unanswerable);
            let text = words::no_attempts_left(run.basis.language()).to_owned();
            return (Verdict { grade, text, remarks: Vec::new() }, Changes::NONE);
        }
        let conditions = self.grading.conditions(run.basis, run.course(), question);
        let verdict = self.grading.judge(run.basis, question, text, &conditions);
        let mut changes = self.type_text(question, text);
        if let Some(answer) = self.given.get_mut(question) {
            *answer = std::mem::take(answer).checked(verdict.grade, conditions);
        }
        if verdict.grade == Grade::Correct {
            changes |= self.solve(question);
        }
        (verdict, changes)
    }

    /// Grade that an answer would get for the present values.
    pub(crate) fn end_grade(&self, basis: &Basis, at: &Course, question: usize, typed: &str) -> Grade {
        let conditions = self.grading.conditions(basis, at, question);
        self.grading.judge(basis, question, typed, &conditions).grade
    }

    /// Marks the right answer as shown and the question as solved. Returns the right answer; see [`Answers::right_text`].
    pub fn reveal(&mut self, run: OpenRun<'_>, question: usize) -> (String, Changes) {
        let Some(answer) = self.given.get_mut(question) else { return (String::new(), Changes::NONE) };
        *answer = std::mem::take(answer).shown();
        let changes = self.solve(question) | Changes::ANSWERS;
        (self.right_text(run.basis, run.course(), question), changes)
    }

    /// Mean credit of the questions, from 0 to 1, of what was answered before the right answer was shown; `None` without questions.
    pub fn score(&self, basis: &Basis) -> Option<f64> {
        let given = self.given.iter().enumerate();
        let credit: f64 = given.map(|(question, answer)| self.credit(basis, question, answer)).sum();
        (!self.given.is_empty()).then(|| credit / self.given.len() as f64)
    }

    /// True if every question has been answered, rightly or not, or its right answer has been shown.
    pub fn are_complete(&self) -> bool {
        self.given.iter().all(|answer| answer.shown.is_some() || answer.grade.is_some() || !answer.attempts.is_empty())
    }

    /// Number in an answer in the unit that the question asks for, to 12 digits; `None` if the text is no number or states an
    /// error as well.
    pub fn number(&self, basis: &Basis, question: usize, text: &str) -> Option<f64> {
        let unit = &basis.program().questions.get(question)?.number()?.unit;
        let answer = basis.read_answer(text, unit, basis.style()).ok().filter(|answer| answer.error.is_none())?;
        units::number::decimal(&format!("{:.11e}", unit.from_si(answer.value)))
    }

    /// Right answer with its unit, or the letters of the right options, for the values of the seat, those assumed by the question, and otherwise the present ones; a
    /// dash if there is none.
    pub fn right_text(&self, basis: &Basis, at: &Course, question: usize) -> String {
        self.right_under(basis, question, &self.grading.conditions(basis, at, question))
    }

    fn right_under(&self, basis: &Basis, question: usize, conditions: &Conditions) -> String {
        match basis.program().questions.get(question).map(|asked| &asked.kind) {
            Some(QuestionKind::Number(asked)) => {
                let right = self.grading.values(basis, question, conditions).first().copied().unwrap_or(f64::NAN);
                let right = number::plain(asked.unit.from_si(right), RIGHT_DIGITS, basis.style());
                number::with_unit(&right, &asked.unit)
            }
            Some(QuestionKind::Choice(asked)) => {
                let right = asked.right.iter().enumerate().filter(|(_, right)| **right);
                ChoiceAnswer::letters(right.map(|(option, _)| option))
            }
            None => String::new(),
        }
    }

    /// Names and values of the parameters that a question asks for, such as `b` and `0 kg/s`: those of the seat, and those that it
    /// assumes; and true if they are set now. `None` if there are none.
    pub fn setup(&self, basis: &Basis, at: &Course, question: usize) -> Option<(Vec<(String, String)>, bool)> {
        let asked = basis.program().questions.get(question)?;
        let parameters = self.grading.supposed(basis, at, question);
        let own = self.grading.assigned(question).iter().filter_map(|&index| {
            let name = basis.model().parameters.get(index)?.name.clone();
            Some((name, basis.parameter_value_text(index, *parameters.get(index)?)))
        });
        let values: Vec<_> = own.chain(basis.assigned(&asked.setup, &parameters)).collect();
        (!values.is_empty()).then(|| (values, at.parameters() == parameters))
    }

    /// Earlier questions that must be answered before this one appears.
    pub fn awaited(&self, basis: &Basis, question: usize) -> Vec<usize> {
        let after = basis.program().questions.get(question).map_or(&[][..], |asked| &asked.after);
        let is_open = |other: &usize| self.solved.get(*other) == Some(&false);
        after.iter().copied().filter(is_open).collect()
    }

    /// True if values hidden by questions are shown anyway.
    pub fn shows_hidden(&self) -> bool {
        self.shows_hidden
    }

    /// Shows the values that questions hide, or hides them again until the questions are answered. Links store this
    /// choice.
    pub fn show_hidden(&mut self, show: bool) -> Changes {
        self.shows_hidden = show;
        Changes::FRAME
    }

    /// True if the value of a quantity is hidden because an open question asks for it.
    pub(crate) fn hide(&self, basis: &Basis, quantity: usize) -> bool {
        let open = basis.program().questions.iter().zip(&self.solved).filter(|(_, solved)| !**solved);
        !self.shows_hidden && open.map(|(question, _)| question).any(|question| question.hides.contains(&quantity))
    }

    /// Answers to be stored for the next visit, with the names of their questions. The names do not depend on the
    /// language.
    pub fn saved(&self, basis: &Basis) -> Vec<(String, Answer)> {
        let given = question_names(basis.program()).into_iter().zip(self.given.iter().cloned());
        given.filter(|(_, answer)| *answer != Answer::default()).collect()
    }

    /// Restores the answer to the question with this name. Returns false if there is no such question.
    pub fn restore(&mut self, run: OpenRun<'_>, name: &str, saved: &Answer) -> (bool, Changes) {
        let Some(question) = question_names(run.basis.program()).iter().position(|own| own == name) else {
            return (false, Changes::NONE);
        };
        let mut changes = Changes::ANSWERS;
        let bounded = saved.bounded();
        if bounded.shown.is_some() || self.is_right_now(run.basis, question, &bounded) {
            changes |= self.solve(question);
        }
        if let Some(answer) = self.given.get_mut(question) {
            *answer = bounded;
        }
        (true, changes)
    }

    /// Adds what another device of the same person has stored to the answer to the question with this name. Returns false if there is no
    /// such question.
    pub fn merge(&mut self, run: OpenRun<'_>, name: &str, stored: &Answer) -> (bool, Changes) {
        let place = question_names(run.basis.program()).iter().position(|own| own == name);
        let own = place.and_then(|question| self.given.get(question)).cloned().unwrap_or_default();
        self.restore(run, name, &own.merged(&stored.bounded()))
    }

    /// Takes over answers to the questions of another program. `same` is true if two questions (the one here, the former
    /// one) have the same answer. Returns the texts of answers whose questions no longer exist.
    pub(crate) fn adopt(
        &mut self,
        basis: &Basis,
        (before, former_basis): (&Self, &Basis),
        same: impl Fn(usize, usize) -> bool,
    ) -> Vec<String> {
        self.shows_hidden = before.shows_hidden;
        let own = question_names(basis.program());
        let former = question_names(former_basis.program());
        let mut lost = Vec::new();
        for (index, (name, (answer, &solved))) in former.iter().zip(before.given.iter().zip(&before.solved)).enumerate()
        {
            let Some(place) = own.iter().position(|own| own == name) else {
                if !answer.typed.is_empty() {
                    lost.push(answer.typed.clone());
                }
                continue;
            };
            let same = same(place, index);
            if let (Some(own), Some(open)) = (self.given.get_mut(place), self.solved.get_mut(place)) {
                // If the right answer has changed, the typed text is unchecked, and the answer shown is outdated.
                *own = if same { answer.clone() } else { answer.unchecked() };
                *open |= same && solved;
            }
        }
        self.grade_again(basis);
        lost
    }

    /// Gives all attempts their computed grades, as after the seat has changed.
    pub(crate) fn grade_again(&mut self, basis: &Basis) {
        for (question, answer) in self.given.iter_mut().enumerate() {
            for attempt in &mut answer.attempts {
                attempt.grade = self.grading.grade(basis, question, attempt).unwrap_or(attempt.grade);
            }
            answer.grade = answer.checked_attempt().map(|attempt| attempt.grade).or(answer.grade);
        }
    }

    /// True if the text in the field is right.
    fn is_right_now(&self, basis: &Basis, question: usize, answer: &Answer) -> bool {
        self.present_verdict(basis, question, answer).is_some_and(|verdict| verdict.grade == Grade::Correct)
    }

    /// Marks a question as solved: the values that it hides are shown.
    fn solve(&mut self, question: usize) -> Changes {
        match self.solved.get_mut(question) {
            Some(solved) => Changes::FRAME.only_if(!std::mem::replace(solved, true)),
            None => Changes::NONE,
        }
    }

    /// Present parameters (SI), replaced by the values that a question assumes, if they can be set.
    pub(crate) fn admitted_setup(&self, run: OpenRun<'_>, question: usize) -> Result<Vec<f64>, Refusal> {
        let unknown = || Refusal::Unknown { name: question.to_string() };
        let asked = run.basis.program().questions.get(question).ok_or_else(unknown)?;
        run.basis.admit_assignments(&asked.setup, self.grading.supposed(run.basis, run.course(), question))
    }
}

impl Basis {
    /// Unit in which an answer is expected, as displayed; empty for a question without a number.
    pub fn question_unit(&self, question: usize) -> String {
        let number = self.program().questions.get(question).and_then(program::Question::number);
        number.map_or_else(String::new, |asked| number::unit_text(&asked.unit.text))
    }

    /// True if questions of the document hide values.
    pub fn hides_values(&self) -> bool {
        self.program().questions.iter().any(|question| !question.hides.is_empty())
    }
}

/// Names of the questions, derived from their texts in the document's own language, so that an answer stays with its
/// question if others are inserted before it. Questions with equal texts are numbered.
pub(crate) fn question_names(program: &Program) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for index in 0..program.questions.len() {
        let prompt = &program.question_text(&program.language, index).prompt;
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
