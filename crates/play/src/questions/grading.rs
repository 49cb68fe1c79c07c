//! Right answers and grades. Every grade that a person sees is computed here, from an answer and its conditions.

use crate::basis::assigning::assign;
use crate::questions::given::{Attempt, Conditions};
use crate::questions::grade::{Grade, Verdict, grade};
use crate::{Basis, Course, words};
use engine::Readings;
use program::{ChoiceAnswer, NodeId, NumberAnswer, Program, Question, QuestionKind};
use units::Language;
use units::number::Style;

/// Evaluators and inputs of the questions of a model.
#[derive(Debug)]
pub(super) struct Grading {
    initial: Readings,
    /// All assignments assumed by questions.
    setups: Readings,
    /// Values of the questions, one after the other: see [`Question::values`].
    values: Readings,
    inputs: Vec<Inputs>,
}

/// Parameters on which the right answer to a question depends, by index.
#[derive(Debug)]
struct Inputs {
    /// Parameters that the reader sets.
    set: Vec<usize>,
    /// Shown parameters with values for the seats.
    assigned: Vec<usize>,
}

impl Inputs {
    fn new(program: &Program, question: &Question) -> Self {
        let model = &program.model;
        let by_setup: Vec<usize> = question.setup.iter().map(|assignment| assignment.parameter).collect();
        let of_setup = parameters_behind(program, question.setup.iter().map(|assignment| assignment.value.node));
        let of_answer = parameters_behind(program, question.values().map(|value| value.node));
        let mut all: Vec<usize> = of_answer.into_iter().filter(|index| !by_setup.contains(index)).collect();
        all.extend(of_setup);
        all.sort_unstable();
        all.dedup();
        let shown = |index: &usize| model.parameters.get(*index).is_some_and(program::Parameter::is_shown);
        let is_assigned = |index: &usize| model.parameters.get(*index).is_some_and(|one| one.assigned.is_some());
        let (assigned, set) = all.into_iter().filter(shown).partition(is_assigned);
        Self { set, assigned }
    }
}

/// Parameters on which nodes depend, also through initial values.
fn parameters_behind(program: &Program, nodes: impl IntoIterator<Item = NodeId>) -> Vec<usize> {
    let model = &program.model;
    let (mut found, mut open, mut seen) = (Vec::new(), nodes.into_iter().collect::<Vec<_>>(), Vec::new());
    while let Some(node) = open.pop() {
        let dependence = model.depends(node);
        found.extend(dependence.parameters.iter().map(|index| *index as usize));
        for state in dependence.initial {
            if !seen.contains(&state) {
                seen.push(state);
                open.extend(model.states.get(state as usize).map(|state| state.initial));
            }
        }
    }
    found
}

/// A grade with its text.
pub(super) fn verdict_of(grade: Grade, language: Language) -> Verdict {
    Verdict { grade, text: words::grade(language, grade), remarks: Vec::new() }
}

/// Grade of chosen options, with their remarks.
fn judge_choice(basis: &Basis, (question, asked): (usize, &ChoiceAnswer), typed: &str) -> Verdict {
    let language = basis.language();
    let Some(chosen) = asked.chosen(typed) else {
        let text = words::nothing_chosen(language).to_owned();
        return Verdict { grade: Grade::Unreadable, text, remarks: Vec::new() };
    };
    let options = basis.program().question_text(basis.tag(), question).options.iter().zip(&chosen);
    let remarks = options.filter(|(_, chosen)| **chosen).filter_map(|(option, _)| option.remark.clone());
    Verdict { remarks: remarks.collect(), ..verdict_of(Grade::of_credit(asked.credit(&chosen)), language) }
}

impl Grading {
    pub fn new(program: &Program) -> Self {
        let reading = |nodes: Vec<NodeId>| Readings::new(&program.model, &nodes);
        let setups = program.questions.iter().flat_map(|question| &question.setup);
        Self {
            initial: reading(program.model.states.iter().map(|state| state.initial).collect()),
            setups: reading(setups.map(|assignment| assignment.value.node).collect()),
            values: reading(program.questions.iter().flat_map(Question::values).map(|value| value.node).collect()),
            inputs: program.questions.iter().map(|question| Inputs::new(program, question)).collect(),
        }
    }

    /// Conditions under which an answer is given now.
    pub fn conditions(&self, basis: &Basis, at: &Course, question: usize) -> Conditions {
        let set = self.inputs.get(question).map_or(&[][..], |inputs| &inputs.set);
        let value = |index: &usize| {
            let parameter = basis.model().parameters.get(*index)?;
            Some((parameter.name.clone(), *at.parameters().get(*index)?))
        };
        let language = basis.tag().chars().filter(|c| c.is_ascii_alphanumeric() || *c == '-').collect();
        Conditions { language, values: set.iter().filter_map(value).collect() }
    }

    /// Grade of an answer given under these conditions. Assigned and hidden parameters have the values of the document and of its seat.
    pub fn judge(&self, basis: &Basis, question: usize, typed: &str, conditions: &Conditions) -> Verdict {
        match basis.program().questions.get(question).map(|asked| &asked.kind) {
            Some(QuestionKind::Number(asked)) => self.judge_number(basis, (question, asked), typed, conditions),
            Some(QuestionKind::Choice(asked)) => judge_choice(basis, (question, asked), typed),
            None => verdict_of(Grade::Unanswerable, basis.language()),
        }
    }

    fn judge_number(
        &self,
        basis: &Basis,
        (question, asked): (usize, &NumberAnswer),
        typed: &str,
        conditions: &Conditions,
    ) -> Verdict {
        let language = basis.language();
        let answer = match basis.read_answer(typed, &asked.unit, Style::of(&conditions.language)) {
            Err(refusal) => {
                let text = basis.refusal_text(&refusal);
                return Verdict { grade: Grade::Unreadable, text, remarks: Vec::new() };
            }
            Ok(answer) => answer,
        };
        let values = self.values(basis, question, conditions);
        let right = values.first().copied().unwrap_or(f64::NAN);
        let mut verdict = verdict_of(grade(answer.value, right, asked.tolerance), language);
        if let Some(error) = answer.error.filter(|_| verdict.grade != Grade::Unanswerable) {
            let within = (answer.value - right).abs() <= error;
            let stated = words::stated_error(language, verdict.grade == Grade::Correct, within);
            verdict.text = [&verdict.text, " ", stated].concat();
        }
        if verdict.grade != Grade::Correct {
            let remarks = &basis.program().question_text(basis.tag(), question).wrong;
            let mut expected = asked.wrong.iter().zip(values.iter().skip(1)).zip(remarks);
            let met = expected.find(|((wrong, value), _)| wrong.tolerance.accepts(answer.value, **value));
            verdict.remarks.extend(met.map(|(_, remark)| remark.clone()));
        }
        verdict
    }

    /// Grade of an attempt, computed; `None` if its text or its conditions are unknown and would decide it.
    pub fn grade(&self, basis: &Basis, question: usize, attempt: &Attempt) -> Option<Grade> {
        let conditions = self.known_conditions(basis, question, attempt)?;
        Some(self.judge(basis, question, &attempt.typed, &conditions).grade)
    }

    /// Conditions of an attempt; those of an attempt without them if any conditions give the same grade.
    pub fn known_conditions(&self, basis: &Basis, question: usize, attempt: &Attempt) -> Option<Conditions> {
        if attempt.typed.is_empty() {
            return None;
        }
        let any = || {
            let is_free = self.inputs.get(question).is_some_and(|inputs| inputs.set.is_empty());
            let is_number = basis.program().questions.get(question).is_some_and(|asked| asked.number().is_some());
            let has_one_reading = !is_number || !attempt.typed.contains([',', ';']);
            let language = basis.program().language.clone();
            (is_free && has_one_reading).then(|| Conditions { language, values: Vec::new() })
        };
        attempt.conditions.clone().or_else(any)
    }

    /// Right answer (SI) under these conditions, and the expected wrong ones; NaN for one that does not exist. Empty for a question
    /// without numbers.
    pub fn values(&self, basis: &Basis, question: usize, conditions: &Conditions) -> Vec<f64> {
        let mut parameters = basis.defaults().parameters.clone();
        for index in self.inputs.get(question).map_or(&[][..], |inputs| &inputs.set) {
            let Some(name) = basis.model().parameters.get(*index).map(|parameter| &parameter.name) else { continue };
            let given = conditions.values.iter().find(|(own, _)| own == name);
            if let (Some((_, value)), Some(parameter)) = (given, parameters.get_mut(*index)) {
                *parameter = *value;
            }
        }
        let parameters = self.with_setup(basis, question, &parameters);
        let initial = self.initial(basis, &parameters);
        let count = |asked: &Question| asked.values().count();
        let questions = &basis.program().questions;
        let first: usize = questions.iter().take(question).map(count).sum();
        let own = questions.get(question).map_or(0, count);
        let mut readings = self.values.clone();
        let values = readings.at(&parameters, &initial, 0.0, &initial);
        values.get(first..first + own).map_or_else(Vec::new, <[f64]>::to_vec)
    }

    /// Present parameters (SI), replaced by the assigned values that a question uses and by those that it assumes.
    pub fn supposed(&self, basis: &Basis, at: &Course, question: usize) -> Vec<f64> {
        let mut parameters = at.parameters().to_vec();
        for index in self.assigned(question) {
            if let (Some(own), Some(value)) = (parameters.get_mut(*index), basis.defaults().parameters.get(*index)) {
                *own = *value;
            }
        }
        self.with_setup(basis, question, &parameters)
    }

    /// Shown parameters with assigned values on which the right answer depends, by index.
    pub fn assigned(&self, question: usize) -> &[usize] {
        self.inputs.get(question).map_or(&[], |inputs| &inputs.assigned)
    }

    /// Parameters (SI) after the assignments of a question.
    fn with_setup(&self, basis: &Basis, question: usize, parameters: &[f64]) -> Vec<f64> {
        let questions = &basis.program().questions;
        let first = questions.iter().take(question).map(|question| question.setup.len()).sum();
        let setup = questions.get(question).map_or(&[][..], |asked| &asked.setup);
        let mut initial = |parameters: &[f64]| self.initial(basis, parameters);
        assign(&mut self.setups.clone(), first, setup, parameters, &mut initial)
    }

    /// Initial state (SI) with these parameters.
    fn initial(&self, basis: &Basis, parameters: &[f64]) -> Vec<f64> {
        let nothing = vec![0.0; basis.model().states.len()];
        self.initial.clone().at(parameters, &nothing, 0.0, &nothing).to_vec()
    }
}
