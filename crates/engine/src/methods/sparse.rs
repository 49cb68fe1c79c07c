//! Linear systems with a fixed sparsity pattern: dense for small ones, banded if each unknown occurs in few equations, as
//! in chains and diffusion.

use super::banded::Banded;
use super::linear::Factors;
use program::{banded_order, bandwidth, places};

/// A square matrix of fixed pattern and its factors.
#[derive(Clone, Debug)]
pub(crate) struct Sparse {
    form: Form,
    size: usize,
    /// Index of each entry among the values of the chosen form.
    entries: Vec<usize>,
}

#[derive(Clone, Debug)]
enum Form {
    Dense(Factors),
    Banded {
        factors: Banded,
        /// Index of the unknown in each row.
        order: Vec<usize>,
        /// Working storage for a right-hand side in that order.
        right: Vec<f64>,
    },
}

impl Sparse {
    /// Storage for a matrix; `pattern` has row and column of every entry.
    pub fn new(size: usize, pattern: &[(usize, usize)]) -> Self {
        match banded_order(size, pattern) {
            Some(order) => {
                let place = places(&order);
                let (lower, upper) = bandwidth(pattern, &place);
                let factors = Banded::new(size, lower, upper);
                let entries = pattern.iter().map(|&(row, column)| factors.place(place[row], place[column])).collect();
                Self { form: Form::Banded { factors, order, right: vec![0.0; size] }, size, entries }
            }
            None => {
                let entries = pattern.iter().map(|&(row, column)| row * size + column).collect();
                Self { form: Form::Dense(Factors::new(size)), size, entries }
            }
        }
    }

    /// Approximate number of floating-point operations of one factorization and `solutions` solutions.
    pub fn work(&self, solutions: usize) -> usize {
        match &self.form {
            Form::Dense(_) => self.size * self.size * (2 * solutions + self.size / 3),
            Form::Banded { factors, .. } => factors.work(solutions),
        }
    }

    /// Sets all diagonal entries to `diagonal` and all others to 0, calls `set` with the values and the index of each
    /// entry, and factorizes the matrix.
    pub fn factorize(&mut self, diagonal: f64, set: impl FnOnce(&mut [f64], &[usize])) {
        let (values, first, distance) = match &mut self.form {
            Form::Dense(factors) => (&mut factors.values[..], 0, self.size + 1),
            Form::Banded { factors, .. } => {
                let first = factors.place(0, 0);
                let distance = factors.place(1, 1) - first;
                (factors.values_mut(), first, distance)
            }
        };
        values.fill(0.0);
        values.iter_mut().skip(first).step_by(distance).for_each(|value| *value = diagonal);
        set(values, &self.entries);
        match &mut self.form {
            Form::Dense(factors) => factors.factorize(),
            Form::Banded { factors, .. } => factors.factorize(),
        }
    }

    /// Replaces the right-hand side, one number per row, by the solution, or by NaN if the matrix is singular.
    pub fn solve(&mut self, values: &mut [f64]) {
        match &mut self.form {
            Form::Dense(factors) => factors.solve(values),
            Form::Banded { factors, order, right } => {
                right.iter_mut().zip(&*order).for_each(|(right, &unknown)| *right = values[unknown]);
                factors.solve(right);
                order.iter().zip(&*right).for_each(|(&unknown, right)| values[unknown] = *right);
            }
        }
    }

    /// True if no pivot was found.
    pub fn singular(&self) -> bool {
        match &self.form {
            Form::Dense(factors) => factors.singular,
            Form::Banded { factors, .. } => factors.singular,
        }
    }
}
