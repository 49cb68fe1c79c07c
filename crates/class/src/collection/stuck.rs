//! Groups that are stuck, by rules with a reason.

use super::{Collection, Work};
use crate::grading::GivenAnswer;
use crate::results::Quantity;
use desk::play::Grade;
use units::{Words, words};

/// Number of attempts with the same error, one after the other, from which on a group is stuck.
const SAME_ERRORS: usize = 3;
/// Number of equal kept runs from which on a group is stuck: as many as can be kept.
const SAME_RUNS: usize = 5;

/// A group that is stuck.
#[derive(Clone, Debug)]
pub struct Stuck {
    /// Index of the hand-in.
    pub hand_in: usize,
    /// The reason.
    pub why: Words,
}

impl Collection {
    /// Groups that are stuck: three answers wrong in the same way, five equal kept runs, a fit that does not determine its
    /// parameters, or a result far from those of the others. `quantities`: those of the collection.
    pub fn stuck(&self, quantities: &[Quantity]) -> Vec<Stuck> {
        let mut stuck = Vec::new();
        for (hand_in, work) in self.works() {
            let far = |quantity: &&Quantity| {
                let place = quantity.results.iter().position(|(own, _)| *own == hand_in);
                place.is_some_and(|place| quantity.outlier(place).is_some())
            };
            let reasons = work.answers.iter().filter_map(same_errors).chain(same_runs(work)).chain(undetermined(work));
            let reasons = reasons.chain(quantities.iter().filter(far).map(far_result));
            stuck.extend(reasons.map(|why| Stuck { hand_in, why }));
        }
        stuck
    }
}

fn far_result(quantity: &Quantity) -> Words {
    let (theory, name) = (&quantity.theory, &quantity.name);
    words!("{name} ({theory}) is far from the others")
}

/// The reason if the last attempts at a question are wrong in the same way.
fn same_errors(answer: &GivenAnswer) -> Option<Words> {
    let last = answer.attempts.last().filter(|attempt| attempt.grade() != Grade::Correct)?;
    let same = answer.attempts.iter().rev().take_while(|attempt| attempt.grade() == last.grade()).count();
    let number = answer.question + 1;
    (same >= SAME_ERRORS).then(|| words!("question {number}: {same} answers wrong in the same way"))
}

/// The reason if the group has kept the same run again and again.
fn same_runs(work: &Work) -> Option<Words> {
    let same = work.equal_runs;
    (same >= SAME_RUNS).then(|| words!("the same run was kept {same} times"))
}

/// Reasons for fits that do not determine all their parameters, one for each.
fn undetermined(work: &Work) -> impl Iterator<Item = Words> + '_ {
    work.fits.iter().filter(|fit| !fit.determined).map(|fit| {
        let (theory, record) = (&fit.theory, &fit.record);
        words!("the fit of {theory} to {record} does not determine its parameters")
    })
}
