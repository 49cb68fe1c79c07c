//! Small dense linear systems: Gaussian elimination with partial pivoting in a fixed order of operations, so that the bits
//! of the solution are the same on all machines. Every unknown of a singular system is NaN.

/// An LU factorization P A = L U of a square matrix, in place.
#[derive(Clone, Debug)]
pub(crate) struct Factors {
    /// Matrix row by row; after [`Factors::factorize`] L below the diagonal, U on and above it.
    pub values: Vec<f64>,
    /// Row `k` was exchanged with row `exchanged[k]`.
    exchanged: Vec<usize>,
    /// True if no pivot was found.
    pub singular: bool,
}

impl Factors {
    /// A zero matrix of `size` rows.
    pub fn new(size: usize) -> Self {
        Self { values: vec![0.0; size * size], exchanged: vec![0; size], singular: false }
    }

    /// Replaces the matrix by its factors (Golub & Van Loan, Matrix Computations, algorithm 3.4.1).
    pub fn factorize(&mut self) {
        let size = self.exchanged.len();
        self.singular = false;
        for column in 0..size {
            let mut pivot = column;
            for row in column + 1..size {
                if self.values[row * size + column].abs() > self.values[pivot * size + column].abs() {
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

    /// Replaces the right-hand side, one number per row, by the solution, or by NaN if the matrix is singular.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn solve(matrix: &[f64], right: &[f64]) -> Vec<f64> {
        let mut factors = Factors::new(right.len());
        factors.values.copy_from_slice(matrix);
        factors.factorize();
        let mut solution = right.to_vec();
        factors.solve(&mut solution);
        solution
    }

    #[test]
    fn solves_with_exchanges() {
        let solution = solve(&[0.0, 2.0, 1.0, 1.0, 1.0, 1.0, 2.0, 1.0, 0.0], &[7.0, 6.0, 4.0]);
        assert_eq!(solution, [1.0, 2.0, 3.0]);
    }

    #[test]
    fn a_hilbert_matrix_keeps_its_bits() {
        let matrix: Vec<f64> = (0..16).map(|k| 1.0 / f64::from(k / 4 + k % 4 + 1)).collect();
        let solution = solve(&matrix, &[1.0, 0.0, 0.0, 0.0]);
        for (value, exact) in solution.iter().zip([16.0, -120.0, 240.0, -140.0]) {
            assert!((value - exact).abs() < 1e-10);
        }
        let bits: Vec<u64> = solution.iter().map(|value| value.to_bits()).collect();
        assert_eq!(bits, HILBERT_BITS);
    }

    /// Reference bits of one machine; any other order of operations changes them.
    const HILBERT_BITS: [u64; 4] =
        [4_625_196_817_309_498_996, 13_861_516_703_092_964_796, 4_642_648_265_865_559_352, 13_862_501_865_511_452_203];

    #[test]
    fn a_singular_matrix_has_no_solution() {
        for matrix in [[1.0, 2.0, 2.0, 4.0], [0.0; 4], [f64::NAN, 1.0, 1.0, 1.0], [f64::INFINITY, 1.0, 1.0, 1.0]] {
            assert!(solve(&matrix, &[1.0, 1.0]).iter().all(|value| value.is_nan()), "{matrix:?}");
        }
    }
}
