//! Searches over the whole fitted part or a part of it.

use super::problem::Problem;
use super::{Residuals, Search};
use crate::fit::linear::Jacobian;
use crate::fit::task::plan::Plan;

/// Upper bound of the trials of one search.
pub(in crate::fit) const TRIALS: usize = 400;

/// Part of a problem for one search.
pub(in crate::fit) struct Window<'a> {
    /// The problem.
    pub problem: &'a mut Problem,
    /// Fitted points, one plan per record.
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
    /// Search from `start` (SI, one number per column), of at most `limit` trials.
    pub fn search(&mut self, start: &[f64], limit: usize) -> Search {
        self.search_within(start, self.problem.open_bounds(), limit)
    }

    /// Search from `start` with numbers held (SI, one number and one pair per column): bounds with equal ends hold, and others
    /// are those of [`Problem::open_bounds`].
    pub fn search_holding(&mut self, start: &[f64], bounds: Vec<(f64, f64)>, limit: usize) -> Search {
        let open = self.problem.open_bounds();
        let is_held = |bounds: &(f64, f64)| bounds.0 >= bounds.1;
        let bounds = bounds.into_iter().zip(open).map(|(own, open)| if is_held(&own) { own } else { open }).collect();
        self.search_within(start, bounds, limit)
    }

    /// Search from `start` with the given bounds (SI, one number and one pair per column).
    pub fn search_within(&mut self, start: &[f64], bounds: Vec<(f64, f64)>, limit: usize) -> Search {
        let points: usize = self.plans.iter().map(|plan| plan.points.len()).sum();
        let rows = points + self.problem.scales();
        let tolerance = self.problem.tolerance();
        Search::new(self, start, bounds, rows, tolerance, limit)
    }

    /// Evaluates `start` with the linear numbers at their best values, without further trials.
    pub fn look(&mut self, start: &[f64]) -> Search {
        let mut search = self.search(start, 1);
        search.set_linear(self);
        search
    }
}

/// Search over the whole fitted part.
pub(in crate::fit) fn search(problem: &mut Problem, start: &[f64], limit: usize) -> Search {
    let plans = problem.plans.clone();
    Window { problem, plans: &plans }.search(start, limit)
}

/// Evaluates `start` on the whole fitted part, with the linear numbers at their best values.
pub(in crate::fit) fn look(problem: &mut Problem, start: &[f64]) -> Search {
    let plans = problem.plans.clone();
    Window { problem, plans: &plans }.look(start)
}
