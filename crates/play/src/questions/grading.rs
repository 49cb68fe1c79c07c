//! Right answers and grades. Every grade that a person sees is computed here, from an answer and its conditions.

use crate::basis::assigning::assign;
use crate::questions::given::{Attempt, Conditions};
use crate::questions::grade::{Grade, Verdict, grade};
use crate::{Basis, Course, words};
use engine::Readings;
use program::{NodeId, Program, Question};
use units::Language;
use units::number::Style;

/// Evaluators and inputs of the questions of a model.
#[derive(Debug)]
pub(super) struct Grading {
    initial: Readings,
    /// All assignments assumed by questions.
    setups: Readings,
    right: Readings,
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
        let of_answer = parameters_behind(program, [question.answer.node]);
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
    Verdict { grade, text: words::grade(language, grade).to_owned() }
}

impl Grading {
    pub fn new(program: &Program) -> Self {
        let reading = |nodes: Vec<NodeId>| Readings::new(&program.model, &nodes);
        let setups = program.questions.iter().flat_map(|question| &question.setup);
        Self {
            initial: reading(program.model.states.iter().map(|state| state.initial).collect()),
            setups: reading(setups.map(|assignment| assignment.value.node).collect()),
            right: reading(program.questions.iter().map(|question| question.answer.node).collect()),
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
        let language = basis.language();
        let Some(asked) = basis.program().questions.get(question) else {
            return verdict_of(Grade::Unanswerable, language);
        };
        let answer = match basis.read_answer(typed, &asked.unit, Style::of(&conditions.language)) {
            Err(refusal) => return Verdict { grade: Grade::Unreadable, text: basis.refusal_text(&refusal) },
            Ok(answer) => answer,
        };
        let right = self.right(basis, question, conditions);
        let mut verdict = verdict_of(grade(answer.value, right, asked.tolerance), language);
        if let Some(error) = answer.error.filter(|_| verdict.grade != Grade::Unanswerable) {
            let within = (answer.value - right).abs() <= error;
            let stated = words::stated_error(language, verdict.grade == Grade::Correct, within);
            verdict.text = [&verdict.text, " ", stated].concat();
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
            let has_one_reading = !attempt.typed.contains([',', ';']);
            let language = basis.program().language.clone();
            (is_free && has_one_reading).then(|| Conditions { language, values: Vec::new() })
        };
        attempt.conditions.clone().or_else(any)
    }

    /// Right answer (SI) under these conditions; NaN if there is none.
    pub fn right(&self, basis: &Basis, question: usize, conditions: &Conditions) -> f64 {
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
        self.right.clone().at(&parameters, &initial, 0.0, &initial).get(question).copied().unwrap_or(f64::NAN)
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
