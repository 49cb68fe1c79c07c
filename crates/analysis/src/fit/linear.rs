//! Linear algebra of least squares: QR decomposition, then singular values of the triangle.

pub(crate) use engine::dot;
use engine::{Wide, run_wide, subtract_multiple};

/// Matrix of derivatives, column by column, one row per residual.
#[derive(Clone, Debug, Default)]
pub(crate) struct Jacobian {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub columns: usize,
    /// Entries; (row, column) is at `column * rows + row`.
    pub values: Vec<f64>,
}

impl Jacobian {
    /// Matrix of zeros.
    pub fn new(rows: usize, columns: usize) -> Self {
        Self { rows, columns, values: vec![0.0; rows * columns] }
    }

    /// Column of this index.
    pub fn column(&self, column: usize) -> &[f64] {
        &self.values[column * self.rows..(column + 1) * self.rows]
    }

    /// Mutable column of this index.
    pub fn column_mut(&mut self, column: usize) -> &mut [f64] {
        &mut self.values[column * self.rows..(column + 1) * self.rows]
    }
}

/// Euclidean norm.
pub(crate) fn norm(vector: &[f64]) -> f64 {
    dot(vector, vector).sqrt()
}

/// x^T A x, with A given row by row.
pub(crate) fn quadratic(matrix: &[f64], x: &[f64]) -> f64 {
    let size = x.len();
    (0..size).fold(0.0, |sum, row| sum + x[row] * dot(&matrix[row * size..(row + 1) * size], x))
}

/// Decomposition for a least-squares step with A and r. With A = Q R and the singular value decomposition R = U S V^T, it
/// holds the singular values, V, and w = U^T Q^T r.
#[derive(Clone, Debug)]
pub(crate) struct Decomposition {
    /// Number of columns of A.
    pub size: usize,
    /// Singular values, unordered.
    pub singular: Vec<f64>,
    /// V column by column: column k belongs to singular value k.
    pub right: Vec<f64>,
    /// Components of r along the left singular vectors.
    pub along: Vec<f64>,
    /// U column by column.
    left: Vec<f64>,
}

impl Decomposition {
    /// Decomposes the columns `columns` of `jacobian`, each divided by its entry of `scale`, with the residuals.
    pub fn new(jacobian: &Jacobian, columns: &[usize], scale: &[f64], residuals: &[f64]) -> Self {
        let size = columns.len();
        let (tall, rows, right_side) = triangulated(jacobian, columns, scale, residuals);
        let mut triangle = vec![0.0; size * size];
        for column in 0..size {
            for row in 0..=column {
                triangle[column * size + row] = tall[column * rows + row];
            }
        }
        Self::of_square(triangle, size, &right_side)
    }

    /// Decomposes a small square matrix, given column by column, with a right side.
    fn of_square(matrix: Vec<f64>, size: usize, right_side: &[f64]) -> Self {
        let (left, singular, right) = singular_values(matrix, size);
        let along = (0..size).map(|k| dot(&left[k * size..(k + 1) * size], right_side)).collect();
        Self { size, singular, right, along, left }
    }

    /// Returns V (d_k w_k), where `weight` gives d_k for a singular value.
    pub fn combine(&self, weight: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut result = vec![0.0; self.size];
        for k in 0..self.size {
            let factor = weight(self.singular[k]) * self.along[k];
            for (value, entry) in result.iter_mut().zip(&self.right[k * self.size..(k + 1) * self.size]) {
                *value += factor * entry;
            }
        }
        result
    }

    /// Predicted decrease of the sum of squares by the best step. Singular values below `flat` times the greatest are
    /// ignored.
    pub fn promised(&self, flat: f64) -> f64 {
        let flat = flat * self.greatest();
        let parts = self.singular.iter().zip(&self.along).filter(|(singular, _)| **singular > flat);
        parts.fold(0.0, |sum, (_, along)| sum + along * along)
    }

    /// Greatest singular value.
    pub fn greatest(&self) -> f64 {
        self.singular.iter().fold(0.0, |greatest: f64, &value| greatest.max(value))
    }
}

/// Least-squares problem in two groups of columns. The first group is eliminated: for every step of the rest it takes its
/// best values. The rest is solved in the space orthogonal to the first group.
#[derive(Clone, Debug)]
pub(crate) struct Split {
    /// First columns by themselves.
    first: Decomposition,
    /// Remaining columns in the space orthogonal to the first.
    pub rest: Decomposition,
    /// Components of the remaining columns along the first, column by column.
    mixed: Vec<f64>,
}

impl Split {
    /// Singular values of the first columns below this part of the greatest are ignored.
    const FLAT: f64 = 1e-13;

    /// Decomposes the columns `first` and `rest` of `jacobian`, each divided by its entry of `scale`, with the residuals.
    pub fn new(jacobian: &Jacobian, first: &[usize], rest: &[usize], scale: &[f64], residuals: &[f64]) -> Self {
        let (ahead, behind) = (first.len(), rest.len());
        let size = ahead + behind;
        let (tall, rows, right_side) = triangulated(jacobian, &[first, rest].concat(), scale, residuals);
        let block = |rows_of: std::ops::Range<usize>, columns_of: std::ops::Range<usize>| -> Vec<f64> {
            columns_of.flat_map(|column| &tall[column * rows..][rows_of.clone()]).copied().collect()
        };
        Self {
            first: Decomposition::of_square(block(0..ahead, 0..ahead), ahead, &right_side[..ahead]),
            rest: Decomposition::of_square(block(ahead..size, ahead..size), behind, &right_side[ahead..size]),
            mixed: block(0..ahead, ahead..size),
        }
    }

    /// Best step of the first columns after this step of the rest.
    pub fn following(&self, step: &[f64]) -> Vec<f64> {
        let size = self.first.size;
        let mut follow = self.first.clone();
        if size > 0 {
            for (column, step) in self.mixed.chunks(size).zip(step) {
                for k in 0..size {
                    follow.along[k] -= step * dot(&self.first.left[k * size..(k + 1) * size], column);
                }
            }
        }
        let flat = Self::FLAT * follow.greatest();
        follow.combine(|value| if value > flat { 1.0 / value } else { 0.0 })
    }

    /// Predicted decrease of the sum of squares by the best step of all columns. Singular values of the rest below `flat`
    /// times their greatest are ignored.
    pub fn promised(&self, flat: f64) -> f64 {
        self.first.promised(Self::FLAT) + self.rest.promised(flat)
    }
}

/// QR decomposition of the columns `columns` of `jacobian`, each divided by its entry of `scale`. Returns the triangle column
/// by column, with zeros below the diagonal, the number of rows of each column (at least the number of columns), and Q^T r of the
/// residuals with the same number of rows.
fn triangulated(
    jacobian: &Jacobian,
    columns: &[usize],
    scale: &[f64],
    residuals: &[f64],
) -> (Vec<f64>, usize, Vec<f64>) {
    let size = columns.len();
    let rows = jacobian.rows.max(size);
    let mut tall = Vec::with_capacity(rows * size);
    for &column in columns {
        let scale = scale[column];
        tall.extend(jacobian.column(column).iter().map(|value| value / scale));
        tall.resize(tall.len() + (rows - jacobian.rows), 0.0);
    }
    let mut right_side = residuals.to_vec();
    right_side.resize(rows, 0.0);
    run_wide(Triangulation { tall: &mut tall, rows, size, right_side: &mut right_side });
    (tall, rows, right_side)
}

/// Reduction of `tall`, `size` columns of `rows`, to a triangle by Householder reflections, which are applied to `right_side` as well
/// (Golub & Van Loan, Matrix Computations, section 5.2).
struct Triangulation<'a> {
    tall: &'a mut [f64],
    rows: usize,
    size: usize,
    right_side: &'a mut [f64],
}

impl Wide for Triangulation<'_> {
    #[inline(always)]
    fn run(self) {
        let Self { tall, rows, size, right_side } = self;
        for step in 0..size {
            let (done, rest) = tall.split_at_mut((step + 1) * rows);
            let mirror = &mut done[step * rows + step..];
            let length = dot(mirror, mirror).sqrt();
            if length == 0.0 {
                continue;
            }
            let diagonal = if mirror[0] > 0.0 { -length } else { length };
            mirror[0] -= diagonal;
            let half_square = -diagonal * mirror[0];
            for column in rest.chunks_mut(rows).chain([&mut *right_side]) {
                let column = &mut column[step..];
                let factor = dot(mirror, column) / half_square;
                subtract_multiple(column, factor, mirror);
            }
            mirror.fill(0.0);
            mirror[0] = diagonal;
        }
    }
}

/// Left vectors, singular values and right vectors of a small square matrix by one-sided Jacobi rotations, which compute
/// small singular values to high relative accuracy (Demmel & Veselic, SIAM J. Matrix Anal. Appl. 13 (1992) 1204).
fn singular_values(mut work: Vec<f64>, size: usize) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let mut right = vec![0.0; size * size];
    for k in 0..size {
        right[k * size + k] = 1.0;
    }
    // Convergence is quadratic; 60 sweeps are never needed.
    for _ in 0..60 {
        let mut rotated = false;
        for low in 0..size {
            for high in low + 1..size {
                rotated |= rotate(&mut work, &mut right, size, low, high);
            }
        }
        if !rotated {
            break;
        }
    }
    let mut singular = vec![0.0; size];
    for k in 0..size {
        let column = &mut work[k * size..(k + 1) * size];
        singular[k] = norm(column);
        if singular[k] > 0.0 {
            column.iter_mut().for_each(|value| *value /= singular[k]);
        }
    }
    (work, singular, right)
}

/// Makes two columns orthogonal. Returns false if they already were.
fn rotate(work: &mut [f64], right: &mut [f64], size: usize, low: usize, high: usize) -> bool {
    let (a, b) = (&work[low * size..(low + 1) * size], &work[high * size..(high + 1) * size]);
    let (aa, bb, ab) = (dot(a, a), dot(b, b), dot(a, b));
    if ab == 0.0 || ab.abs() <= f64::EPSILON * aa.sqrt() * bb.sqrt() {
        return false;
    }
    let ratio = (bb - aa) / (2.0 * ab);
    let root = (1.0 + ratio * ratio).sqrt();
    let tangent = if ratio >= 0.0 { 1.0 / (ratio + root) } else { 1.0 / (ratio - root) };
    if !tangent.is_finite() || tangent == 0.0 {
        return false;
    }
    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
    let sine = cosine * tangent;
    for matrix in [work, right] {
        for row in 0..size {
            let (a, b) = (matrix[low * size + row], matrix[high * size + row]);
            matrix[low * size + row] = cosine * a - sine * b;
            matrix[high * size + row] = sine * a + cosine * b;
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Singular values of the Hilbert matrix of order 5, some of which are very small.
    #[test]
    fn singular_values_of_a_hilbert_matrix() {
        let size = 5;
        let mut jacobian = Jacobian::new(size, size);
        for column in 0..size {
            for row in 0..size {
                jacobian.values[column * size + row] = 1.0 / (row + column + 1) as f64;
            }
        }
        let columns: Vec<usize> = (0..size).collect();
        let found = Decomposition::new(&jacobian, &columns, &[1.0; 5], &[1.0; 5]);
        let mut singular = found.singular.clone();
        singular.sort_by(f64::total_cmp);
        // Eigenvalues of the Hilbert matrix of order 5, from its characteristic polynomial.
        let known = [
            3.287_928_772_171_85e-6,
            3.058_980_401_511_46e-4,
            1.140_749_162_341_98e-2,
            0.208_534_218_611_013,
            1.567_050_691_098_23,
        ];
        for (found, known) in singular.iter().zip(known) {
            assert!((found - known).abs() < 1e-12 * known.max(1e-2), "{found} {known}");
        }
        // The inverse applied to ones is known exactly: 5, -120, 630, -1120, 630.
        let solution = found.combine(|value| 1.0 / value);
        for (found, known) in solution.iter().zip([5.0, -120.0, 630.0, -1120.0, 630.0]) {
            assert!((found - known).abs() < 1e-7 * known.abs(), "{found} {known}");
        }
    }

    #[test]
    fn a_dependent_column_has_a_vanishing_singular_value() {
        let mut jacobian = Jacobian::new(4, 3);
        jacobian.column_mut(0).copy_from_slice(&[1.0, 2.0, 3.0, 4.0]);
        jacobian.column_mut(1).copy_from_slice(&[1.0, -1.0, 0.5, 2.0]);
        for row in 0..4 {
            let value = 2.0 * jacobian.column(0)[row] - jacobian.column(1)[row];
            jacobian.column_mut(2)[row] = value;
        }
        let found = Decomposition::new(&jacobian, &[0, 1, 2], &[1.0; 3], &[0.0; 4]);
        let least = found.singular.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(least < 1e-15 * found.greatest());
    }
}
