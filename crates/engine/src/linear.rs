//! Small dense linear systems: Gaussian elimination with partial pivoting in a fixed order of operations, so that the bits
//! of the solution are the same everywhere. A singular system has no solution: every unknown is then NaN.

use crate::instruction::Register;

/// A linear system among the registers of a routine.
#[derive(Clone, Debug)]
pub(crate) struct Elimination {
    /// The registers of the matrix, row by row.
    pub matrix: Vec<Register>,
    /// The registers of the right side.
    pub right: Vec<Register>,
    /// The first of the registers that receive the unknowns.
    pub target: Register,
    /// Room for the factors, so that solving allocates nothing.
    pub factors: Factors,
    /// Room for the solution.
    pub solution: Vec<f64>,
}

impl Elimination {
    /// Reads the system from `registers` and writes the unknowns there.
    pub fn solve(&mut self, registers: &mut [f64]) {
        for (value, &register) in self.factors.values.iter_mut().zip(&self.matrix) {
            *value = registers[register as usize];
        }
        for (value, &register) in self.solution.iter_mut().zip(&self.right) {
            *value = registers[register as usize];
        }
        self.factors.factorize();
        self.factors.solve(&mut self.solution);
        let target = self.target as usize;
        registers[target..target + self.solution.len()].copy_from_slice(&self.solution);
    }
}

/// An LU factorization P A = L U of a square matrix, in place.
#[derive(Clone, Debug)]
pub(crate) struct Factors {
    /// The matrix row by row; after [`Factors::factorize`] L below the diagonal and U on and above it.
    pub values: Vec<f64>,
    /// Row `k` was exchanged with row `exchanged[k]`.
    exchanged: Vec<usize>,
    /// Whether no pivot was found.
    pub singular: bool,
}

impl Factors {
    /// Room for a matrix of `size` rows, all zero.
    pub fn new(size: usize) -> Self {
        Self {
            values: vec![0.0; size * size],
            exchanged: vec![0; size],
            singular: false,
        }
    }

    /// Replaces the matrix by its factors (Golub & Van Loan, Matrix Computations, algorithm 3.4.1).
    pub fn factorize(&mut self) {
        let size = self.exchanged.len();
        self.singular = false;
        for column in 0..size {
            let mut pivot = column;
            for row in column + 1..size {
                if self.values[row * size + column].abs() > self.values[pivot * size + column].abs()
                {
                    pivot = row;
                }
            }
            self.exchanged[column] = pivot;
            if pivot != column {
                for k in 0..size {
                    self.values.swap(column * size + k, pivot * size + k);
                }
            }
            let diagonal = self.values[column * size + column];
            if diagonal == 0.0 || !diagonal.is_finite() {
                self.singular = true;
                return;
            }
            for row in column + 1..size {
                let factor = self.values[row * size + column] / diagonal;
                self.values[row * size + column] = factor;
                for k in column + 1..size {
                    self.values[row * size + k] -= factor * self.values[column * size + k];
                }
            }
        }
    }

    /// Replaces the right side by the solution; by NaN if the matrix was singular.
    pub fn solve(&self, right: &mut [f64]) {
        let size = self.exchanged.len();
        if self.singular {
            right.fill(f64::NAN);
            return;
        }
        for row in 0..size {
            right.swap(row, self.exchanged[row]);
        }
        for row in 0..size {
            for k in 0..row {
                right[row] -= self.values[row * size + k] * right[k];
            }
        }
        for row in (0..size).rev() {
            for k in row + 1..size {
                right[row] -= self.values[row * size + k] * right[k];
            }
            right[row] /= self.values[row * size + row];
        }
    }
}
