//! Linear systems of a stiff method: matrix d - J with a number d and the Jacobian J of the rates.

use super::sparse::Sparse;
use program::banded_order;

/// Number of solutions per factorization.
const SOLUTIONS: usize = 6;

/// The matrix d - J and its factors.
#[derive(Clone, Debug)]
pub(crate) struct Jacobian(Sparse);

impl Jacobian {
    /// Maximum number of rows of a dense matrix, limited by memory and time.
    const MOST_DENSE: usize = 1024;

    /// Storage for a model of `states` states; `pattern` has the indices of rate and state of every entry.
    pub fn new(states: usize, pattern: &[(usize, usize)]) -> Self {
        Self(Sparse::new(states, pattern))
    }

    /// True if the matrix is small enough to be factorized: not too large, or banded.
    pub fn fits(states: usize, pattern: &[(usize, usize)]) -> bool {
        states <= Self::MOST_DENSE || banded_order(states, pattern).is_some()
    }

    /// Approximate number of floating-point operations per step.
    pub fn work(&self) -> u64 {
        self.0.work(SOLUTIONS) as u64
    }

    /// Sets the matrix to `diagonal` minus the derivatives, given in the order of the pattern, and factorizes it.
    pub fn factorize(&mut self, diagonal: f64, derivatives: &[f64]) {
        self.0.factorize(diagonal, |values, entries| {
            entries.iter().zip(derivatives).for_each(|(&place, derivative)| values[place] -= derivative);
        });
    }

    /// Replaces the right-hand side, one number per state, by the solution.
    pub fn solve(&mut self, values: &mut [f64]) {
        self.0.solve(values);
    }
}
