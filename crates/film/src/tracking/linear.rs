//! Symmetric linear systems of least squares.

/// Symmetric positive definite band matrix with `reach` diagonals above the main one.
pub(crate) struct Banded {
    reach: usize,
    /// Entries of each row from the diagonal to the right, `reach + 1` per row.
    entries: Vec<f64>,
}

impl Banded {
    pub(crate) fn new(size: usize, reach: usize) -> Banded {
        Banded { reach, entries: vec![0.0; size * (reach + 1)] }
    }

    /// Adds to an entry on or above the diagonal. Other entries are ignored.
    pub(crate) fn add(&mut self, row: usize, column: usize, value: f64) {
        if column >= row
            && column - row <= self.reach
            && let Some(entry) = self.entries.get_mut(row * (self.reach + 1) + column - row)
        {
            *entry += value;
        }
    }

    /// Mean of the diagonal.
    pub(crate) fn scale(&self) -> f64 {
        let size = self.entries.len() / (self.reach + 1);
        self.entries.iter().step_by(self.reach + 1).sum::<f64>() / size.max(1) as f64
    }

    /// Solves for `count` right-hand sides, stored side by side in each row of `sides`, and overwrites them. `None` if
    /// the matrix is not positive definite.
    pub(crate) fn solve(mut self, sides: &mut [f64], count: usize) -> Option<()> {
        let wide = self.reach + 1;
        let size = self.entries.len() / wide;
        // Decomposition U' D U in place: rows of U, with D on the diagonal.
        for row in 0..size {
            let pivot = self.entries[row * wide];
            if pivot.is_nan() || pivot <= 0.0 {
                return None;
            }
            let end = wide.min(size - row);
            for k in 1..end {
                let factor = self.entries[row * wide + k] / pivot;
                for j in k..end {
                    self.entries[(row + k) * wide + j - k] -= factor * self.entries[row * wide + j];
                }
                for side in 0..count {
                    sides[(row + k) * count + side] -= factor * sides[row * count + side];
                }
            }
        }
        for row in (0..size).rev() {
            let end = wide.min(size - row);
            for side in 0..count {
                let mut value = sides[row * count + side];
                for k in 1..end {
                    value -= self.entries[row * wide + k] * sides[(row + k) * count + side];
                }
                sides[row * count + side] = value / self.entries[row * wide];
            }
        }
        Some(())
    }
}

/// Solution of a small symmetric positive definite system, and the inverse of its matrix; `None` if it is numerically
/// singular.
pub(crate) fn solve<const N: usize>(matrix: [[f64; N]; N], side: [f64; N]) -> Option<([f64; N], [[f64; N]; N])> {
    // Scaled to a unit diagonal, so that one threshold suits all units.
    let mut scale = [0.0; N];
    for k in 0..N {
        if matrix[k][k].is_nan() || matrix[k][k] <= 0.0 {
            return None;
        }
        scale[k] = 1.0 / matrix[k][k].sqrt();
    }
    let mut left = [[0.0; N]; N];
    let mut inverse = [[0.0; N]; N];
    for row in 0..N {
        inverse[row][row] = 1.0;
        for column in 0..N {
            left[row][column] = matrix[row][column] * scale[row] * scale[column];
        }
    }
    for pivot in 0..N {
        let value = left[pivot][pivot];
        if value.is_nan() || value < 1e-12 {
            return None;
        }
        for row in (0..N).filter(|row| *row != pivot) {
            let factor = left[row][pivot] / value;
            for column in 0..N {
                left[row][column] -= factor * left[pivot][column];
                inverse[row][column] -= factor * inverse[pivot][column];
            }
        }
    }
    let mut solution = [0.0; N];
    for row in 0..N {
        for column in 0..N {
            inverse[row][column] *= scale[row] * scale[column] / left[row][row];
            solution[row] += inverse[row][column] * side[column];
        }
    }
    Some((solution, inverse))
}
