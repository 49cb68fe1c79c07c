//! Refinement of the best answer of all starts: equations of motion are integrated more accurately, several observations
//! are reweighted by their own scatter, and the weights of a robust loss are iterated.

use super::Search;
use super::problem::Problem;
use super::robust::{Continuation, Reweighting};
use super::symmetry;

/// State of the refinement.
#[derive(Clone, Debug, Default)]
pub(in crate::fit) struct Refinement {
    /// True if all starts have been tried.
    begun: bool,
    /// Number of reweightings of several observations.
    weighings: usize,
    /// Weights of a robust loss.
    reweighting: Reweighting,
}

impl Refinement {
    /// Upper bound of the reweightings of several observations by their own scatter.
    const WEIGHINGS: usize = 12;

    /// Refinement of a known answer.
    pub fn of_known(problem: &mut Problem) -> Self {
        problem.refine_fully();
        Self { begun: true, ..Self::default() }
    }

    /// True if all starts have been tried and the best one is being refined.
    pub fn has_begun(&self) -> bool {
        self.begun
    }

    /// Weights of a robust loss.
    pub fn reweighting(&self) -> &Reweighting {
        &self.reweighting
    }

    /// Start of the next search: the best answer itself if the accuracy of integration or the weights have changed, or an
    /// equivalent answer with signs and order like those of the start.
    pub fn next(&mut self, problem: &mut Problem, best: &Search) -> Continuation {
        let first = !std::mem::replace(&mut self.begun, true);
        if problem.refine() {
            return Continuation::From(best.x.clone());
        }
        if first
            && !problem.curve.has_states()
            && let Some(like) = symmetry::like_start(problem, best)
        {
            return Continuation::From(like);
        }
        let least_squares = self.reweighting.least_squares().is_none();
        if least_squares && self.weighings < Self::WEIGHINGS && problem.reweigh(&best.residuals) {
            self.weighings += 1;
            return Continuation::From(best.x.clone());
        }
        self.reweighting.next(problem, best)
    }
}
