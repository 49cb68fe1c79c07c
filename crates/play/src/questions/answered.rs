//! The user's answers, their grades, and values hidden by open questions. Answers are kept with their questions across
//! languages and stored for the next visit.

use crate::basis::assigning::assign;
use crate::questions::given::{Answer, Attempt};
use crate::questions::grade::{Grade, Verdict, grade};
use crate::{Basis, Changes, Course, OpenRun, Refusal, name_of, number, words};
use engine::Readings;
use program::{NodeId, Program};
use units::Language;

/// Significant digits of the right answer.
const RIGHT_DIGITS: usize = 4;

/// An answer, for display with its question.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AnswerView {
    /// Text in the field.
    pub typed: String,
    /// Grade, if the answer has been checked.
    pub verdict: Option<Verdict>,
    /// True if the right answer has been shown.
    pub revealed: bool,
    /// True if a right answer had been given when the right answer was shown.
    pub found: bool,
    /// Answers that have been checked, in order.
    pub attempts: Vec<Attempt>,
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
    evaluators: Evaluators,
}

/// Evaluators for the questions of a model.
#[derive(Debug)]
struct Evaluators {
    initial: Readings,
    /// All assignments assumed by questions.
    setups: Readings,
    right: Readings,
}

impl Evaluators {
    fn new(program: &Program) -> Self {
        let reading = |nodes: Vec<NodeId>| Readings::new(&program.model, &nodes);
        let setups = program.questions.iter().flat_map(|question| &question.setup);
        Self {
            initial: reading(program.model.states.iter().map(|state| state.initial).collect()),
            setups: reading(setups.map(|assignment| assignment.value.node).collect()),
            right: reading(program.questions.iter().map(|question| question.answer.node).collect()),
        }
    }
}

impl Answers {
    /// No answers.
    pub(crate) fn new(program: &Program) -> Self {
        let count = program.questions.len();
        Self {
            given: vec![Answer::default(); count],
            solved: vec![false; count],
            shows_hidden: false,
            evaluators: Evaluators::new(program),
        }
    }

    /// Must be called when the model has changed.
    pub(crate) fn model_changed(&mut self, program: &Program) {
        self.evaluators = Evaluators::new(program);
    }

    /// The user's answer to a question; empty if there is none.
    pub fn answer(&self, basis: &Basis, question: usize) -> AnswerView {
        let Some(answer) = self.given.get(question) else { return AnswerView::default() };
        let verdict = answer.grade.map(|grade| verdict_of(grade, basis.language()));
        AnswerView {
            typed: answer.typed.clone(),
            verdict,
            revealed: answer.revealed,
            found: answer.found,
            attempts: answer.attempts.clone(),
        }
    }

    /// Stores the text in the field of a question as an unchecked answer.
    pub fn type_text(&mut self, question: usize, text: &str) -> Changes {
        let Some(answer) = self.given.get_mut(question) else { return Changes::NONE };
        *answer = std::mem::take(answer).typed(text);
        Changes::ANSWERS
    }

    /// Grades an answer: a number or arithmetic in the expected unit, or with its own units of the same dimension. An
    /// error after `±` is not graded, but compared with the actual error. The answer is stored with the question.
    pub fn check(&mut self, run: OpenRun<'_>, question: usize, text: &str) -> (Verdict, Changes) {
        let verdict = self.verdict(run.basis, run.course(), question, text);
        let mut changes = self.type_text(question, text);
        if let Some(answer) = self.given.get_mut(question) {
            *answer = std::mem::take(answer).checked(verdict.grade);
        }
        if verdict.grade == Grade::Correct {
            changes |= self.solve(question);
        }
        (verdict, changes)
    }

    /// Grade that an answer would get for the present parameters, or those assumed by the question. Nothing is stored.
    pub fn verdict(&self, basis: &Basis, at: &Course, question: usize, text: &str) -> Verdict {
        let language = basis.language();
        let Some(asked) = basis.program().questions.get(question) else {
            return verdict_of(Grade::Unanswerable, language);
        };
        let answer = match basis.read_answer(at, text, &asked.unit) {
            Err(refusal) => return Verdict { grade: Grade::Unreadable, text: basis.refusal_text(&refusal) },
            Ok(answer) => answer,
        };
        let right = self.right(basis, at, question);
        let mut verdict = verdict_of(grade(answer.value, right, asked.tolerance), language);
        if let Some(error) = answer.error.filter(|_| verdict.grade != Grade::Unanswerable) {
            let within = (answer.value - right).abs() <= error;
            let stated = words::stated_error(language, verdict.grade == Grade::Correct, within);
            verdict.text = [&verdict.text, " ", stated].concat();
        }
        verdict
    }

    /// Marks the right answer as shown and the question as solved. Returns the right answer; see [`Answers::right_text`].
    pub fn reveal(&mut self, run: OpenRun<'_>, question: usize) -> (String, Changes) {
        let Some(answer) = self.given.get_mut(question) else { return (String::new(), Changes::NONE) };
        *answer = std::mem::take(answer).shown();
        let changes = self.solve(question) | Changes::ANSWERS;
        (self.right_text(run.basis, run.course(), question), changes)
    }

    /// Share of the questions that have been answered correctly before the right answer was shown; `None` without questions.
    pub fn score(&self) -> Option<f64> {
        let right = self.given.iter().filter(|answer| answer.was_found()).count();
        (!self.given.is_empty()).then(|| right as f64 / self.given.len() as f64)
    }

    /// True if every question has been answered, rightly or not, or its right answer has been shown.
    pub fn are_complete(&self) -> bool {
        self.given.iter().all(|answer| answer.revealed || answer.grade.is_some() || !answer.attempts.is_empty())
    }

    /// Number in an answer in the unit that the question asks for, to 12 digits; `None` if the text is no number or states an
    /// error as well.
    pub fn number(&self, basis: &Basis, at: &Course, question: usize, text: &str) -> Option<f64> {
        let unit = &basis.program().questions.get(question)?.unit;
        let answer = basis.read_answer(at, text, unit).ok().filter(|answer| answer.error.is_none())?;
        format!("{:.11e}", unit.from_si(answer.value)).parse().ok()
    }

    /// Right answer with its unit, for the present parameters or those assumed by the question; a dash if there is
    /// none.
    pub fn right_text(&self, basis: &Basis, at: &Course, question: usize) -> String {
        let Some(asked) = basis.program().questions.get(question) else { return String::new() };
        let right = asked.unit.from_si(self.right(basis, at, question));
        number::with_unit(&number::plain(right, RIGHT_DIGITS, basis.style()), &asked.unit)
    }

    /// Names and values of the parameters that a question assumes, such as `b` and `0 kg/s`, and true if they are set
    /// now; `None` if it assumes none.
    pub fn setup(&self, basis: &Basis, at: &Course, question: usize) -> Option<(Vec<(String, String)>, bool)> {
        let asked = basis.program().questions.get(question).filter(|asked| !asked.setup.is_empty())?;
        let parameters = self.supposed(basis, at, question);
        Some((basis.assigned(&asked.setup, &parameters), at.parameters() == parameters))
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
        if let Some(answer) = self.given.get_mut(question) {
            *answer = saved.bounded();
        }
        if saved.revealed || saved.grade == Some(Grade::Correct) {
            changes |= self.solve(question);
        }
        (true, changes)
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
        lost
    }

    /// Marks a question as solved: the values that it hides are shown.
    fn solve(&mut self, question: usize) -> Changes {
        match self.solved.get_mut(question) {
            Some(solved) => Changes::FRAME.only_if(!std::mem::replace(solved, true)),
            None => Changes::NONE,
        }
    }

    /// Right answer (SI); NaN if there is none.
    fn right(&self, basis: &Basis, at: &Course, question: usize) -> f64 {
        let parameters = self.supposed(basis, at, question);
        let nothing = vec![0.0; basis.model().states.len()];
        let [mut initial, mut right] = [&self.evaluators.initial, &self.evaluators.right].map(Readings::clone);
        let initial = initial.at(&parameters, &nothing, 0.0, &nothing);
        right.at(&parameters, initial, 0.0, initial).get(question).copied().unwrap_or(f64::NAN)
    }

    /// Present parameters (SI), replaced by the values that a question assumes, if they can be set.
    pub(crate) fn admitted_setup(&self, run: OpenRun<'_>, question: usize) -> Result<Vec<f64>, Refusal> {
        let unknown = || Refusal::Unknown { name: question.to_string() };
        let asked = run.basis.program().questions.get(question).ok_or_else(unknown)?;
        run.basis.admit_assignments(&asked.setup, self.supposed(run.basis, run.course(), question))
    }

    /// Present parameters (SI), replaced by the values that a question assumes.
    pub(crate) fn supposed(&self, basis: &Basis, at: &Course, question: usize) -> Vec<f64> {
        let questions = &basis.program().questions;
        let first = questions.iter().take(question).map(|question| question.setup.len()).sum();
        let setup = questions.get(question).map_or(&[][..], |asked| &asked.setup);
        assign(&mut self.evaluators.setups.clone(), first, setup, at.parameters(), at.initial())
    }
}

impl Basis {
    /// Unit in which an answer is expected, as displayed.
    pub fn question_unit(&self, question: usize) -> String {
        self.program().questions.get(question).map_or_else(String::new, |asked| number::unit_text(&asked.unit.text))
    }

    /// True if questions of the document hide values.
    pub fn hides_values(&self) -> bool {
        self.program().questions.iter().any(|question| !question.hides.is_empty())
    }
}

/// A grade with its text.
fn verdict_of(grade: Grade, language: Language) -> Verdict {
    Verdict { grade, text: words::grade(language, grade).to_owned() }
}

/// Names of the questions, derived from their texts in the document's own language, so that an answer stays with its
/// question if others are inserted before it. Questions with equal texts are numbered.
fn question_names(program: &Program) -> Vec<String> {
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
