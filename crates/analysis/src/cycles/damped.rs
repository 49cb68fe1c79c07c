//! Least squares of one damped sinusoid, `c + exp(-g t) (a cos(w t) + b sin(w t))`.
//!
//! For given `w` and `g` the best `a`, `b` and `c` follow from linear equations (variable projection: Golub and Pereyra,
//! SIAM J. Numer. Anal. 10, 413 (1973)), so that only `w` and `g` are searched, by Gauss-Newton steps.

use crate::fit::autoregression::{Block, all_correlated, orthonormal, subtract_projection};
use crate::fit::linear::dot;

/// Values over time, without gaps, in the order of time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Points<'a> {
    pub times: &'a [f64],
    pub values: &'a [f64],
}

/// Damped sinusoid with the quality of its fit. Times count from `origin`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Damped {
    pub origin: f64,
    /// Angular frequency, rad per unit of time.
    pub w: f64,
    /// Damping, 1 per unit of time.
    pub g: f64,
    /// Coefficients of cosine, sine and offset.
    pub linear: [f64; 3],
    /// Sum of the squared residuals.
    pub squares: f64,
}

/// Curve without amplitude, `exp(-g t) cos(w t)` and `exp(-g t) sin(w t)`, at every time.
///
/// Over equal steps it is continued by a complex factor; the functions are evaluated only if the step changes.
pub(crate) fn basis(points: Points, origin: f64, w: f64, g: f64, out: &mut Vec<(f64, f64)>) {
    out.clear();
    let turned = |step: f64| {
        let size = libm::exp(-g * step);
        let (sine, cosine) = libm::sincos(w * step);
        (size * cosine, size * sine)
    };
    let Some(first) = points.times.first() else { return };
    let mut before = *first;
    let mut point = turned(first - origin);
    let mut last_step = 0.0;
    let mut factor = (1.0, 0.0);
    for time in points.times {
        let step = time - before;
        if (step - last_step).abs() > 1e-10 * last_step {
            factor = turned(step);
            last_step = step;
        }
        if step != 0.0 {
            point = (point.0 * factor.0 - point.1 * factor.1, point.0 * factor.1 + point.1 * factor.0);
        }
        out.push(point);
        before = *time;
    }
}

/// Best coefficients for this frequency and damping, and the sum of squared residuals.
fn project(points: Points, basis: &[(f64, f64)]) -> Option<([f64; 3], f64)> {
    let mut matrix = [[0.0; 3]; 3];
    let mut right = [0.0; 3];
    for (&(c, s), &value) in basis.iter().zip(points.values) {
        let row = [c, s, 1.0];
        for i in 0..3 {
            for j in 0..=i {
                matrix[i][j] += row[i] * row[j];
            }
            right[i] += row[i] * value;
        }
    }
    let linear = solve(matrix, right)?;
    let residual = |(&(c, s), &value): (&(f64, f64), &f64)| value - linear[0] * c - linear[1] * s - linear[2];
    let squares: f64 = basis.iter().zip(points.values).map(residual).map(|residual| residual * residual).sum();
    squares.is_finite().then_some((linear, squares))
}

impl Damped {
    /// Best curve of this angular frequency `w` and damping `g` (1/s, if times are in s), with its origin at the time `origin`.
    pub fn of(points: Points, origin: f64, w: f64, g: f64, scratch: &mut Vec<(f64, f64)>) -> Option<Self> {
        basis(points, origin, w, g, scratch);
        let (linear, squares) = project(points, scratch)?;
        Some(Self { origin, w, g, linear, squares })
    }

    /// Improves the fit by at most `steps` Gauss-Newton steps; `scratch` holds the basis of `self`, and of the result
    /// afterwards.
    pub fn improved(self, points: Points, steps: usize, scratch: &mut Vec<(f64, f64)>) -> Self {
        let mut best = self;
        for _ in 0..steps {
            let Some((matrix, right)) = best.equations(points, scratch) else { return best };
            let Some(step) = solve(matrix, right) else { return best };
            let mut length = 1.0;
            let next = loop {
                let trial =
                    Self::of(points, best.origin, best.w + length * step[3], best.g + length * step[4], scratch);
                match trial {
                    Some(trial) if trial.squares < best.squares && trial.w > 0.0 => break Some(trial),
                    _ if length < 0.1 => break None,
                    _ => length *= 0.25,
                }
            };
            let Some(next) = next else {
                basis(points, best.origin, best.w, best.g, scratch);
                return best;
            };
            let gained = best.squares - next.squares;
            best = next;
            if gained <= 1e-12 * best.squares {
                break;
            }
        }
        best
    }

    /// Normal equations of all five parameters: cosine, sine, offset, frequency, damping. Only the lower triangle is
    /// filled.
    fn equations(&self, points: Points, basis: &[(f64, f64)]) -> Option<([[f64; 5]; 5], [f64; 5])> {
        let mut matrix = [[0.0; 5]; 5];
        let mut right = [0.0; 5];
        let [a, b, offset] = self.linear;
        for ((&time, &value), &(c, s)) in points.times.iter().zip(points.values).zip(basis) {
            let time = time - self.origin;
            let row = [c, s, 1.0, time * (b * c - a * s), -time * (a * c + b * s)];
            let residual = value - a * c - b * s - offset;
            for i in 0..5 {
                for j in 0..=i {
                    matrix[i][j] += row[i] * row[j];
                }
                right[i] += row[i] * residual;
            }
        }
        matrix.iter().flatten().all(|entry| entry.is_finite()).then_some((matrix, right))
    }

    /// Derivatives of the curve with respect to cosine, sine, offset, frequency and damping, column by column; `basis` is
    /// that of the curve.
    fn derivatives(&self, points: Points, basis: &[(f64, f64)]) -> Vec<Vec<f64>> {
        let [a, b, _] = self.linear;
        let column = |of: &dyn Fn(f64, f64, f64) -> f64| -> Vec<f64> {
            points.times.iter().zip(basis).map(|(time, &(c, s))| of(time - self.origin, c, s)).collect()
        };
        vec![
            column(&|_, c, _| c),
            column(&|_, _, s| s),
            column(&|_, _, _| 1.0),
            column(&|time, c, s| time * (b * c - a * s)),
            column(&|time, c, s| -time * (a * c + b * s)),
        ]
    }

    /// Residuals with an orthonormal basis of the curve's derivatives; `basis` is that of the curve. If the level `drifts`,
    /// a parabola is also subtracted from the residuals.
    pub fn residuals(&self, points: Points, basis: &[(f64, f64)], drifts: bool) -> Block {
        let mut residuals = self.differences(points, basis);
        let mut columns = self.derivatives(points, basis);
        if drifts {
            columns.extend([1, 2].map(|power| -> Vec<f64> {
                points.times.iter().map(|time| libm::pow(time - self.origin, f64::from(power))).collect()
            }));
        }
        let basis = orthonormal(columns);
        if drifts {
            subtract_projection(&basis, &mut residuals);
        }
        Block::new(basis, residuals)
    }

    /// Values minus the curve; `basis` is that of the curve.
    fn differences(&self, points: Points, basis: &[(f64, f64)]) -> Vec<f64> {
        let [a, b, offset] = self.linear;
        points.values.iter().zip(basis).map(|(value, (c, s))| value - a * c - b * s - offset).collect()
    }

    /// Fit together with the second and third harmonic, which decay like the oscillation, by Gauss-Newton steps from this fit: the
    /// fit, its derivatives orthogonal to the harmonics, and its residuals. `None` if the data do not determine it.
    pub fn with_harmonics(
        mut self,
        points: Points,
        scratch: &mut Vec<(f64, f64)>,
    ) -> Option<(Self, Vec<Vec<f64>>, Block)> {
        let mut last = f64::INFINITY;
        loop {
            basis(points, self.origin, self.w, self.g, scratch);
            let harmonics = orthonormal(harmonics(scratch));
            let mut columns = self.derivatives(points, scratch);
            columns.iter_mut().for_each(|column| subtract_projection(&harmonics, column));
            let mut residuals = self.differences(points, scratch);
            subtract_projection(&harmonics, &mut residuals);
            let squares = dot(&residuals, &residuals);
            if squares >= last * (1.0 - 1e-9) {
                let basis = orthonormal(harmonics.into_iter().chain(columns.iter().cloned()).collect());
                return (squares <= last * 1.01).then(|| (self, columns, Block::new(basis, residuals)));
            }
            last = squares;
            let [a, b, offset, w, g] =
                solve(normal(&columns), core::array::from_fn(|row| dot(&columns[row], &residuals)))?;
            self.linear = [self.linear[0] + a, self.linear[1] + b, self.linear[2] + offset];
            (self.w, self.g) = (self.w + w, self.g + g);
        }
    }

    /// Covariance of cosine, sine, offset, frequency and damping for noise of this variance with the correlation `rho` of
    /// neighbouring rows. `basis` is that of the curve. `None` if the data do not determine all of them.
    pub fn covariance(&self, points: Points, basis: &[(f64, f64)], variance: f64, rho: f64) -> Option<[[f64; 5]; 5]> {
        let (matrix, _) = self.equations(points, basis)?;
        covariance(matrix, &self.derivatives(points, basis), variance, rho)
    }

    /// Amplitude at the origin, in the unit of the values.
    pub fn amplitude(&self) -> f64 {
        libm::hypot(self.linear[0], self.linear[1])
    }
}

/// Second and third harmonic of an oscillation with this basis, which decay like it: cosine and sine of each.
pub(crate) fn harmonics(basis: &[(f64, f64)]) -> Vec<Vec<f64>> {
    let mut columns: Vec<Vec<f64>> = (0..4).map(|_| Vec::with_capacity(basis.len())).collect();
    for &(c, s) in basis {
        let size = libm::hypot(c, s).max(f64::MIN_POSITIVE);
        let (cosine, sine) = (c / size, s / size);
        let (c2, s2) = (c * cosine - s * sine, s * cosine + c * sine);
        let all = [c2, s2, c2 * cosine - s2 * sine, s2 * cosine + c2 * sine];
        columns.iter_mut().zip(all).for_each(|(column, value)| column.push(value));
    }
    columns
}

/// Normal matrix of five columns; only the lower triangle is filled.
pub(crate) fn normal(columns: &[Vec<f64>]) -> [[f64; 5]; 5] {
    core::array::from_fn(|i| core::array::from_fn(|j| if j <= i { dot(&columns[i], &columns[j]) } else { 0.0 }))
}

/// Covariance of the five numbers whose derivatives are `columns`, with their normal matrix, for noise of this variance with the
/// correlation `rho` of neighbouring rows. `None` if the data do not determine all of them.
pub(crate) fn covariance(
    matrix: [[f64; 5]; 5],
    columns: &[Vec<f64>],
    variance: f64,
    rho: f64,
) -> Option<[[f64; 5]; 5]> {
    let sums = all_correlated(columns, rho);
    // The inverse of the normal matrix is applied on both sides of the products of correlated columns.
    let mut half = [[0.0; 5]; 5];
    for (half, sums) in half.iter_mut().zip(&sums) {
        *half = solve(matrix, core::array::from_fn(|row| dot(&columns[row], sums)))?;
    }
    let mut covariance = [[0.0; 5]; 5];
    for (row, covariance) in covariance.iter_mut().enumerate() {
        *covariance = solve(matrix, core::array::from_fn(|column| variance * half[column][row]))?;
    }
    Some(covariance)
}

/// Solves symmetric positive definite equations, given by the lower triangle, by Cholesky decomposition of the matrix
/// scaled to a unit diagonal. `None` if the matrix is singular.
pub(crate) fn solve<const N: usize>(mut matrix: [[f64; N]; N], mut right: [f64; N]) -> Option<[f64; N]> {
    let mut scale = [0.0; N];
    for i in 0..N {
        scale[i] = 1.0 / matrix[i][i].sqrt();
        if !scale[i].is_finite() || scale[i] == 0.0 {
            return None;
        }
    }
    for i in 0..N {
        right[i] *= scale[i];
        for j in 0..=i {
            let mut sum = matrix[i][j] * scale[i] * scale[j];
            let (this, that) = (&matrix[i], &matrix[j]);
            sum -= this.iter().zip(that).take(j).map(|(one, other)| one * other).sum::<f64>();
            if i == j {
                if sum < 1e-14 {
                    return None;
                }
                matrix[i][i] = sum.sqrt();
            } else {
                matrix[i][j] = sum / matrix[j][j];
            }
        }
        for k in 0..i {
            right[i] -= matrix[i][k] * right[k];
        }
        right[i] /= matrix[i][i];
    }
    for i in (0..N).rev() {
        for k in i + 1..N {
            right[i] -= matrix[k][i] * right[k];
        }
        right[i] /= matrix[i][i];
    }
    for i in 0..N {
        right[i] *= scale[i];
    }
    Some(right)
}
