//! Searches over a problem, or over a part of what is fitted.

use super::problem::Problem;
use super::{Residuals, Search};
use crate::fit::linear::Jacobian;
use crate::fit::task::plan::Plan;

/// Trials of one search.
pub(in crate::fit) const TRIALS: usize = 400;

/// The part of a problem that a search works on.
pub(in crate::fit) struct Window<'a> {
    /// The problem.
    pub problem: &'a mut Problem,
    /// What is fitted.
    pub plans: &'a [Plan],
}

impl Residuals for Window<'_> {
    fn evaluate(&mut self, x: &[f64], residuals: &mut [f64], jacobian: &mut Jacobian) -> bool {
        self.problem.residuals(self.plans, x, residuals, jacobian)
    }

    fn linear(&self) -> Vec<usize> {
        self.problem.linear_columns()
    }
}

impl Window<'_> {
    /// A search from `start`, of no more than `limit` trials.
    pub fn search(&mut self, start: &[f64], limit: usize) -> Search {
        self.search_within(start, self.problem.bounds.clone(), limit)
    }

    /// The same between other bounds than the problem's.
    pub fn search_within(&mut self, start: &[f64], bounds: Vec<(f64, f64)>, limit: usize) -> Search {
        let points: usize = self.plans.iter().map(|plan| plan.points.len()).sum();
        let rows = points + self.problem.scales();
        let tolerance = self.problem.tolerance();
        Search::new(self, start, bounds, rows, tolerance, limit)
    }

    /// How well these numbers fit, what is linear being at its best values.
    pub fn look(&mut self, start: &[f64]) -> Search {
        let mut search = self.search(start, 1);
        search.set_linear(self);
        search
    }
}

/// A search of all that is fitted.
pub(in crate::fit) fn search(problem: &mut Problem, start: &[f64], limit: usize) -> Search {
    let plans = problem.plans.clone();
    Window { problem, plans: &plans }.search(start, limit)
}

/// How well these numbers fit all of it, what is linear being at its best values.
pub(in crate::fit) fn look(problem: &mut Problem, start: &[f64]) -> Search {
    let plans = problem.plans.clone();
    Window { problem, plans: &plans }.look(start)
}
