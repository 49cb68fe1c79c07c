//! How the best answer of all starts is gone on with: with equations of motion integrated more exactly, with several
//! observations weighted again by their own scatter, and with the weights of a robust loss.

use super::Search;
use super::problem::Problem;
use super::robust::{Continuation, Reweighting};
use super::symmetry;

/// How far that is.
#[derive(Clone, Debug, Default)]
pub(in crate::fit) struct Refinement {
    /// Whether all starts have been tried.
    begun: bool,
    /// How often several observations were weighted again.
    weighings: usize,
    /// The weights of a robust loss.
    reweighting: Reweighting,
}

impl Refinement {
    /// How often several observations are weighted again by their own scatter, at most.
    const WEIGHINGS: usize = 12;

    /// Of an answer that is known already.
    pub fn of_known(problem: &mut Problem) -> Self {
        problem.refine_fully();
        Self { begun: true, ..Self::default() }
    }

    /// Whether all starts have been tried, and the best one is gone on with.
    pub fn has_begun(&self) -> bool {
        self.begun
    }

    /// The weights of a robust loss.
    pub fn reweighting(&self) -> &Reweighting {
        &self.reweighting
    }

    /// Where to search once more: from the best itself where equations are now integrated more exactly, or several
    /// observations weighted again by their own scatter, until that no longer changes; or from its like among those that fit
    /// as well.
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
