//! The linear systems of a stiff method, d - J with a number d and the derivatives J of the rates of change.

use super::sparse::Sparse;
use program::banded_order;

/// How often a step solves with one factorization.
const SOLUTIONS: usize = 6;

/// A matrix d - J and its factors.
#[derive(Clone, Debug)]
pub(crate) struct Jacobian(Sparse);

impl Jacobian {
    /// A dense matrix of more rows takes too much memory and time.
    const MOST_DENSE: usize = 1024;

    /// Room for a model of so many states; `pattern` has rate and state of every derivative.
    pub fn new(states: usize, pattern: &[(usize, usize)]) -> Self {
        Self(Sparse::new(states, pattern))
    }

    /// Whether there is room for it.
    pub fn fits(states: usize, pattern: &[(usize, usize)]) -> bool {
        states <= Self::MOST_DENSE || banded_order(states, pattern).is_some()
    }

    /// About how many floating-point operations a step takes.
    pub fn work(&self) -> u64 {
        self.0.work(SOLUTIONS) as u64
    }

    /// Sets the matrix to `diagonal` minus the derivatives, in the order of the pattern, and factorizes it.
    pub fn factorize(&mut self, diagonal: f64, derivatives: &[f64]) {
        self.0.factorize(diagonal, |values, entries| {
            entries.iter().zip(derivatives).for_each(|(&place, derivative)| values[place] -= derivative);
        });
    }

    /// Replaces the right side by the solution.
    pub fn solve(&mut self, values: &mut [f64]) {
        self.0.solve(values);
    }
}
