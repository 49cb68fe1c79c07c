//! Work of one group, computed again from its hand-in.

use crate::grading::GivenAnswer;
use crate::verify::Verdict;
use desk::play::{KeptValues, Play};
use desk::{FittedCurve, MeasuredCurve};
use saved::hand_in::Fact;

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
