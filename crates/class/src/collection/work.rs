//! Work of one group, computed again from its hand-in.

use crate::verify::Verdict;
use desk::play::{Attempt, Grade, KeptValues, Play};
use desk::{FittedCurve, MeasuredCurve};
use saved::hand_in::Fact;
use serde::{Deserialize, Serialize};

/// Work of a group, computed again.
#[derive(Clone, Debug, Default)]
pub struct Work {
    /// Comparison of the stated values with the computed ones.
    pub verdict: Verdict,
    /// The computed values.
    pub facts: Vec<Fact>,
    /// The measured columns in use.
    pub curves: Vec<MeasuredCurve>,
    /// The fitted columns.
    pub fits: Vec<FittedCurve>,
    /// The questions of the document with their answers.
    pub answers: Vec<GivenAnswer>,
    /// Greatest number of kept runs with the same time, parameters and state.
    pub equal_runs: usize,
}

/// A question, and the answer of the group.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GivenAnswer {
    /// Title of the document.
    pub document: String,
    /// Index of the question.
    pub question: usize,
    /// Text of the question.
    pub prompt: String,
    /// The right answer for the values of the group, with its unit.
    pub right: String,
    /// Text in the field; empty if nothing was typed.
    pub typed: String,
    /// All answers that were checked, in order, graded again.
    pub attempts: Vec<Attempt>,
    /// True if the right answer was shown before it was found.
    pub revealed: bool,
}

impl GivenAnswer {
    /// True if the last attempt is right.
    pub fn is_right(&self) -> bool {
        self.attempts.last().is_some_and(|attempt| attempt.grade == Grade::Correct)
    }
}

pub(super) fn equal_runs(play: &Play) -> usize {
    let runs = play.time_line().kept_values(play.basis());
    let equal = |one: &KeptValues| {
        let is_equal = |other: &&KeptValues| {
            (other.time, &other.parameters, &other.state) == (one.time, &one.parameters, &one.state)
        };
        runs.iter().filter(is_equal).count()
    };
    runs.iter().map(equal).max().unwrap_or(0)
}

pub(super) fn answers(play: &Play) -> Vec<GivenAnswer> {
    let (basis, answers, program) = (play.basis(), play.answers(), play.program());
    let document = program.title.clone();
    let answer = |question: usize| {
        let own = answers.answer(basis, question);
        let grade = |typed: &str| answers.verdict(basis, play.course(), question, typed).grade;
        let again = |typed: String| Attempt { grade: grade(&typed), typed };
        GivenAnswer {
            document: document.clone(),
            question,
            prompt: program.question_text(basis.language().tag(), question).prompt.clone(),
            right: answers.right_text(basis, play.course(), question),
            typed: own.typed,
            attempts: own.attempts.into_iter().map(|attempt| again(attempt.typed)).collect(),
            revealed: own.revealed && !own.found,
        }
    };
    (0..program.questions.len()).map(answer).collect()
}
