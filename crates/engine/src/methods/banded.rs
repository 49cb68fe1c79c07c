//! Banded linear systems: Gaussian elimination with partial pivoting in a fixed order of operations (Golub & Van Loan,
//! Matrix Computations, algorithm 4.3.2, with the row exchanges of LAPACK's dgbtf2). The work is proportional to the number
//! of rows. Every unknown of a singular system is NaN.

use program::band_width;

/// An LU factorization of a square matrix with `lower` diagonals below the main one and `upper` above it.
#[derive(Clone, Debug)]
pub(crate) struct Banded {
    size: usize,
    lower: usize,
    upper: usize,
    /// Row by row, for each row the columns from `row - lower` to `row + upper + lower`; row exchanges fill the last
    /// `lower` ones.
    values: Vec<f64>,
    /// Row `k` was exchanged with row `exchanged[k]`.
    exchanged: Vec<usize>,
    /// True if no pivot was found.
    pub singular: bool,
}

impl Banded {
    /// A zero matrix.
    pub fn new(size: usize, lower: usize, upper: usize) -> Self {
        let width = band_width(lower, upper);
        Self { size, lower, upper, values: vec![0.0; size * width], exchanged: vec![0; size], singular: false }
    }

    /// Index in [`Banded::values_mut`] of an entry within the band.
    pub fn place(&self, row: usize, column: usize) -> usize {
        row * band_width(self.lower, self.upper) + column + self.lower - row
    }

    /// Entries of the matrix, to be set before [`Banded::factorize`].
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Approximate number of floating-point operations of one factorization and `solutions` solutions.
    pub fn work(&self, solutions: usize) -> usize {
        2 * self.size * (self.lower * (self.lower + self.upper + 1) + solutions * band_width(self.lower, self.upper))
    }

    /// Replaces the matrix by its factors.
    pub fn factorize(&mut self) {
        self.singular = false;
        for column in 0..self.size {
            let last = self.size.min(column + self.lower + 1);
            // Row exchanges have filled the rows up to this column.
            let end = self.size.min(column + self.upper + self.lower + 1);
            let mut pivot = column;
            for row in column + 1..last {
                if self.values[self.place(row, column)].abs() > self.values[self.place(pivot, column)].abs() {
                    pivot = row;
                }
            }
            self.exchanged[column] = pivot;
            let upper_place = self.place(column, column);
            if pivot != column {
                let pivot_place = self.place(pivot, column);
                for k in 0..end - column {
                    self.values.swap(upper_place + k, pivot_place + k);
                }
            }
            let diagonal = self.values[upper_place];
            if diagonal == 0.0 || !diagonal.is_finite() {
                self.singular = true;
                return;
            }
            for row in column + 1..last {
                let place = self.place(row, column);
                let (above, below) = self.values.split_at_mut(place);
                let (upper, own) = (&above[upper_place..][..end - column], &mut below[..end - column]);
                let factor = own[0] / diagonal;
                own[0] = factor;
                // Most factors are zero in a sparse matrix.
                if factor != 0.0 {
                    own.iter_mut().zip(upper).skip(1).for_each(|(value, upper)| *value -= factor * upper);
                }
            }
        }
    }

    /// Replaces the right-hand side, one number per row, by the solution, or by NaN if the matrix is singular.
    pub fn solve(&self, right: &mut [f64]) {
        if self.singular {
            right.fill(f64::NAN);
            return;
        }
        for column in 0..self.size {
            right.swap(column, self.exchanged[column]);
            for row in column + 1..self.size.min(column + self.lower + 1) {
                right[row] -= self.values[self.place(row, column)] * right[column];
            }
        }
        for row in (0..self.size).rev() {
            let diagonal = self.place(row, row);
            let end = self.size.min(row + self.upper + self.lower + 1);
            for column in row + 1..end {
                right[row] -= self.values[diagonal + column - row] * right[column];
            }
            right[row] /= self.values[diagonal];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::linear::Factors;

    /// Entries between -1 and 1, small on the diagonal so that rows are exchanged.
    fn entry(row: usize, column: usize) -> f64 {
        let value = libm::sin((1 + 17 * row + 5 * column + row * column) as f64);
        if row == column { 0.01 * value } else { value }
    }

    #[test]
    fn solves_as_the_dense_elimination_does() {
        for (size, lower, upper) in [(1, 0, 0), (8, 1, 1), (20, 3, 1), (20, 1, 4), (30, 5, 5), (12, 0, 3), (9, 8, 8)] {
            let (mut banded, mut dense) = (Banded::new(size, lower, upper), Factors::new(size));
            for row in 0..size {
                for column in row.saturating_sub(lower)..size.min(row + upper + 1) {
                    let place = banded.place(row, column);
                    banded.values_mut()[place] = entry(row, column);
                    dense.values[row * size + column] = entry(row, column);
                }
            }
            banded.factorize();
            dense.factorize();
            let right: Vec<f64> = (0..size).map(|row| libm::cos(row as f64)).collect();
            let (mut found, mut expected) = (right.clone(), right);
            banded.solve(&mut found);
            dense.solve(&mut expected);
            for (found, expected) in found.iter().zip(&expected) {
                assert!((found - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{size} {lower} {upper}");
            }
            assert!(size < 8 || lower == 0 || banded.exchanged.iter().enumerate().any(|(row, &other)| row != other));
        }
    }

    #[test]
    fn a_singular_matrix_has_no_solution() {
        let mut banded = Banded::new(3, 1, 1);
        banded.factorize();
        let mut right = [1.0; 3];
        banded.solve(&mut right);
        assert!(right.iter().all(|value| value.is_nan()));
    }
}
