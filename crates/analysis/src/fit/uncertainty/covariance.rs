//! Covariance of the varied numbers: the textbook formula, and formulas for autocorrelated residuals of uneven size.

use super::hac::{self, Left};
use crate::fit::autoregression::{Autoregression, Errors, MOST};
use crate::fit::linear::{Decomposition, Jacobian, dot, norm, quadratic};
use crate::fit::search::Search;
use crate::fit::task::plan::{Plan, Point};
use crate::fit::task::weights;
use std::ops::Range;

/// A direction is undetermined if the curve changes along it by less than this part of the greatest change.
const FLAT: f64 = 1e-10;

/// Uncertainties at a solution. Matrices hold all columns of the search, row by row; rows and columns of numbers held at a
/// bound are zero.
#[derive(Clone, Debug)]
pub(crate) struct Covariance {
    /// Inverse of the normal matrix times the variance of the residuals.
    pub textbook: Vec<f64>,
    /// Covariance for autocorrelated residuals of uneven size, from the products of scores.
    hac: Vec<f64>,
    /// Covariance for errors that are a first-order autoregressive process.
    autoregressive: Vec<f64>,
    /// One per series: standard deviation of `autoregressive` due to that of the correlation.
    doubt: Vec<Vec<f64>>,
    /// One per series: parameters of the autoregressive process.
    pub errors: Vec<Errors>,
    /// Directions, one entry per column, in which the curve does not change.
    pub flat: Vec<Vec<f64>>,
    /// Independent values minus determined numbers.
    pub dof: f64,
    /// Orthonormal basis of the changes of the curve, each column as long as the residuals.
    pub basis: Vec<Vec<f64>>,
    /// Column scaling: 1 / norm of each Jacobian column, 0 for a column without effect.
    lengths: Vec<f64>,
}

impl Covariance {
    /// Covariance at the end of `search`. Its residuals are those of `plans`, followed by those of priors, whose standard
    /// deviation is `prior` in units of the weighted residuals. `values` is the number of independent values. With
    /// `errors_given` the weights are absolute, else only their ratios count. `reach` is the typical size of each number,
    /// by column.
    pub fn new(
        search: &Search,
        plans: &[Plan],
        (values, errors_given): (f64, bool),
        prior: f64,
        reach: &[f64],
    ) -> Self {
        let size = search.x.len();
        let rows = search.residuals.len();
        let priors = plans.iter().map(|plan| plan.points.len()).sum::<usize>()..rows;
        let scale: Vec<f64> = (0..size).map(|column| norm(search.jacobian.column(column))).collect();
        let mut flat: Vec<Vec<f64>> = Vec::new();
        let mut free = Vec::new();
        let nothing = rounding(plans, &scale, reach);
        let changes = |column: usize| scale[column] * reach[column] > nothing;
        for column in 0..size {
            if !changes(column) {
                let mut direction = vec![0.0; size];
                direction[column] = 1.0;
                flat.push(direction);
            } else if !search.at_bound(column) {
                free.push(column);
            }
        }
        let known = Inverse::new(&search.jacobian, &free, &scale);
        let dof = values + priors.len() as f64 - known.directions.len() as f64;
        let variance = |squares: f64| if errors_given { 1.0 } else { squares / dof.max(f64::MIN_POSITIVE) };
        let columns = || (0..size).map(|column| search.jacobian.column(column));
        // Priors have a known variance, independent of the residuals.
        let meat_of_priors = products(columns(), priors.clone(), prior * prior);
        let textbook_of = |inverse: &[f64], squares: f64| {
            let variance = variance(squares);
            let more = products(columns(), priors.clone(), prior * prior - variance);
            let more = product(&product(inverse, &more, size), inverse, size);
            inverse.iter().zip(more).map(|(value, more)| value * variance + more).collect::<Vec<f64>>()
        };
        let mut textbook = textbook_of(&known.inverse, search.sum);
        let mut series = series(plans, |_| true);
        let mut errors = None;
        // Columns computed from others have errors that follow from theirs. If the measured columns determine as many
        // numbers by themselves, only they are counted.
        if plans.iter().flat_map(|plan| &plan.points).any(|point| !point.measured) {
            let (jacobian, residuals) = measured_alone(search, plans);
            let alone = Inverse::new(&jacobian, &free, &scale);
            if alone.directions.len() == known.directions.len() {
                let squares = dot(&residuals, &residuals);
                textbook = textbook_of(&alone.inverse, squares);
                series = self::series(plans, |measured| measured);
                errors = Some(alone.errors(&series, &alone.basis(&jacobian), &residuals, (priors.clone(), prior)));
            }
        }
        let basis = known.basis(&search.jacobian);
        let (errors, autoregressive, doubt) =
            errors.unwrap_or_else(|| known.errors(&series, &basis, &search.residuals, (priors.clone(), prior)));
        let left =
            Left { residuals: &search.residuals, jacobian: &search.jacobian, free: &free, inverse: &known.inverse };
        let mut meat = hac::meat(&left, plans);
        meat.iter_mut().zip(&meat_of_priors).for_each(|(sum, value)| *sum += value);
        let hac = product(&product(&known.inverse, &meat, size), &known.inverse, size);
        flat.extend(known.flat);
        let length = |column: usize| if changes(column) { 1.0 / scale[column] } else { 0.0 };
        let lengths = (0..size).map(length).collect();
        Self { textbook, hac, autoregressive, doubt, errors, flat, dof, basis, lengths }
    }

    /// Variance along `gradient` for autocorrelated residuals of uneven size: the greater one of the estimates from the
    /// products of scores and from an autoregressive process of order one. The first is too small if the record is short
    /// for its correlation, the second if errors are of uneven size.
    pub fn robust(&self, gradient: &[f64]) -> f64 {
        Self::variance(&self.hac, gradient).max(Self::variance(&self.autoregressive, gradient))
    }

    /// Degrees of freedom of [`Self::robust`]: those of a sum of squares with the same relative variance (Satterthwaite,
    /// Biometrics Bull. 2 (1946) 110). It combines the uncertainty of the variance of the errors and that of their
    /// correlation.
    pub fn freedom(&self, gradient: &[f64]) -> f64 {
        let variance = Self::variance(&self.autoregressive, gradient);
        let doubt: f64 = self.doubt.iter().map(|doubt| quadratic(doubt, gradient)).map(|doubt| doubt * doubt).sum();
        if variance > 0.0 {
            (2.0 / (2.0 / self.dof + doubt / (variance * variance))).clamp(1.0, self.dof.max(1.0))
        } else {
            self.dof
        }
    }

    /// Effective number of independent values for a slow change, allowing for autocorrelation.
    pub fn independent(&self) -> f64 {
        self.errors.iter().map(Errors::independent).sum()
    }

    /// True if the residuals of a series cannot be distinguished from a random walk.
    pub fn wanders(&self) -> bool {
        self.errors.iter().any(|errors| errors.rho >= MOST)
    }

    /// True if no flat direction changes the quantity with this `gradient` (by column), so that its uncertainty is known.
    pub fn determines(&self, gradient: &[f64]) -> bool {
        // Scale of the comparison: the change of the quantity when each number changes by its column scaling.
        let parts = gradient.iter().zip(&self.lengths).fold(0.0, |sum, (slope, length)| sum + (slope * length).abs());
        self.flat.iter().all(|direction| dot(gradient, direction).abs() <= 1e-6 * parts)
    }

    /// Variance along `gradient` in one of the matrices.
    pub fn variance(matrix: &[f64], gradient: &[f64]) -> f64 {
        quadratic(matrix, gradient).max(0.0)
    }
}

/// A number that changes the values by less than this part of their scatter has no effect: the residuals of an exact fit,
/// times 100 for the steepness of a curve.
const NOTHING: f64 = 100.0 * weights::EXACT;

/// Upper bound of the norm of a change of all values by rounding.
fn rounding(plans: &[Plan], scale: &[f64], reach: &[f64]) -> f64 {
    let spread = weights::spread(plans);
    let points = plans.iter().zip(&spread).flat_map(|(plan, spread)| plan.points.iter().map(move |one| (one, spread)));
    let size = |(point, spread): (&Point, &Vec<f64>)| point.weight * spread[point.observation];
    let values = norm(&points.map(size).collect::<Vec<f64>>());
    // If all values are 0, the greatest change sets the scale.
    let greatest = || scale.iter().zip(reach).map(|(scale, reach)| scale * reach).fold(0.0, f64::max);
    NOTHING * if values > 0.0 { values } else { greatest() }
}

/// Indices of the values of each observation of each record, in the order of time; `wanted` takes true if the value was
/// measured.
pub(crate) fn series(plans: &[Plan], wanted: impl Fn(bool) -> bool) -> Vec<Vec<usize>> {
    let mut series = Vec::new();
    let mut base = 0;
    for plan in plans {
        for observation in 0..plan.expressions.len() {
            let own = plan.points.iter().enumerate().filter(|(_, point)| point.observation == observation);
            let places: Vec<usize> =
                own.filter(|(_, point)| wanted(point.measured)).map(|(place, _)| base + place).collect();
            if !places.is_empty() {
                series.push(places);
            }
        }
        base += plan.points.len();
    }
    series
}

/// Pseudo-inverse of a normal matrix.
struct Inverse {
    /// Matrix over all columns, row by row.
    inverse: Vec<f64>,
    /// Directions, one entry per column, along which the curve changes by a vector of length one; these vectors are
    /// orthogonal.
    directions: Vec<Vec<f64>>,
    /// Directions in which the curve does not change.
    flat: Vec<Vec<f64>>,
}

impl Inverse {
    /// V S^-2 V^T in scaled variables, for the columns `free`.
    fn new(jacobian: &Jacobian, free: &[usize], scale: &[f64]) -> Self {
        let size = jacobian.columns;
        let decomposition = Decomposition::new(jacobian, free, scale, &vec![0.0; jacobian.rows]);
        let least = FLAT * decomposition.greatest();
        let mut result = Self { inverse: vec![0.0; size * size], directions: Vec::new(), flat: Vec::new() };
        for (k, &singular) in decomposition.singular.iter().enumerate() {
            let right = &decomposition.right[k * free.len()..(k + 1) * free.len()];
            let mut direction = vec![0.0; size];
            free.iter().zip(right).for_each(|(&column, value)| direction[column] = value / scale[column]);
            if singular <= least {
                result.flat.push(direction);
                continue;
            }
            direction.iter_mut().for_each(|value| *value /= singular);
            for row in 0..size {
                for column in 0..size {
                    result.inverse[row * size + column] += direction[row] * direction[column];
                }
            }
            result.directions.push(direction);
        }
        result
    }

    /// Change of the residuals along each direction.
    fn basis(&self, jacobian: &Jacobian) -> Vec<Vec<f64>> {
        let along = |direction: &Vec<f64>| {
            let mut sum = vec![0.0; jacobian.rows];
            for (column, &part) in direction.iter().enumerate().filter(|(_, part)| **part != 0.0) {
                sum.iter_mut().zip(jacobian.column(column)).for_each(|(sum, slope)| *sum += part * slope);
            }
            sum
        };
        self.directions.iter().map(along).collect()
    }

    /// Errors by series, covariance of the varied numbers, and by series the standard deviation of that covariance due to
    /// that of the correlation. Priors have the standard deviation `deviation`.
    fn errors(
        &self,
        series: &[Vec<usize>],
        basis: &[Vec<f64>],
        residuals: &[f64],
        (priors, deviation): (Range<usize>, f64),
    ) -> (Vec<Errors>, Vec<f64>, Vec<Vec<f64>>) {
        let of_priors = products(basis.iter().map(Vec::as_slice), priors, deviation * deviation);
        let found = Autoregression::new(series, basis, residuals, &of_priors);
        let doubt = found.doubt.iter().map(|doubt| self.of_columns(doubt)).collect();
        (found.errors, self.of_columns(&found.covariance), doubt)
    }

    /// Transforms a matrix over the directions to one over all columns.
    fn of_columns(&self, matrix: &[f64]) -> Vec<f64> {
        let count = self.directions.len();
        let size = self.inverse.len().isqrt();
        let mut result = vec![0.0; size * size];
        for (row, left) in self.directions.iter().enumerate() {
            // Row of the product of `matrix` with the directions.
            let mut right = vec![0.0; size];
            for (entry, direction) in matrix[row * count..(row + 1) * count].iter().zip(&self.directions) {
                right.iter_mut().zip(direction).for_each(|(sum, value)| *sum += entry * value);
            }
            for (place, left) in left.iter().enumerate().filter(|(_, left)| **left != 0.0) {
                let to = &mut result[place * size..(place + 1) * size];
                to.iter_mut().zip(&right).for_each(|(to, right)| *to += left * right);
            }
        }
        result
    }
}

/// Derivatives and residuals of measured values, with their full weight; zero for values computed from others.
fn measured_alone(search: &Search, plans: &[Plan]) -> (Jacobian, Vec<f64>) {
    let mut jacobian = search.jacobian.clone();
    let mut residuals = search.residuals.clone();
    for (place, point) in plans.iter().flat_map(|plan| &plan.points).enumerate() {
        let factor = if point.measured { 1.0 / point.share.sqrt() } else { 0.0 };
        residuals[place] *= factor;
        for column in 0..jacobian.columns {
            jacobian.values[column * jacobian.rows + place] *= factor;
        }
    }
    (jacobian, residuals)
}

/// Inner products of the columns over `rows`, times `factor`, row by row.
fn products<'a>(columns: impl Iterator<Item = &'a [f64]>, rows: Range<usize>, factor: f64) -> Vec<f64> {
    let columns: Vec<&[f64]> = columns.map(|column| &column[rows.clone()]).collect();
    columns.iter().flat_map(|one| columns.iter().map(move |other| factor * dot(one, other))).collect()
}

fn product(a: &[f64], b: &[f64], size: usize) -> Vec<f64> {
    let mut result = vec![0.0; size * size];
    for row in 0..size {
        for column in 0..size {
            result[row * size + column] = (0..size).fold(0.0, |sum, k| sum + a[row * size + k] * b[k * size + column]);
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two numbers and two series, written out; see the formula at [`Covariance::freedom`].
    #[test]
    fn degrees_of_freedom_variances_and_random_walks() {
        let series = |rho| Errors { count: 20, rho, variance: 1.0 };
        let covariance = |doubt: Vec<Vec<f64>>, rho| Covariance {
            textbook: Vec::new(),
            hac: vec![9.0, 0.0, 0.0, 1.0],
            autoregressive: vec![4.0, 1.0, 1.0, 2.0],
            doubt,
            errors: vec![series(0.5), series(rho)],
            flat: Vec::new(),
            dof: 10.0,
            basis: Vec::new(),
            lengths: vec![1.0; 2],
        };
        let of_first = |value| vec![value, 0.0, 0.0, 0.0];
        let sure = covariance(vec![of_first(0.0), of_first(0.0)], 0.98);
        let unsure = covariance(vec![of_first(2.0), of_first(1.0)], MOST);
        assert_eq!((sure.freedom(&[1.0, 0.0]), sure.freedom(&[0.0, 1.0])), (10.0, 10.0));
        assert!((unsure.freedom(&[1.0, 0.0]) - 2.0 / (2.0 / 10.0 + 5.0 / 16.0)).abs() < 1e-12);
        assert_eq!(unsure.freedom(&[0.0, 1.0]), 10.0);
        // The greater one of both variances: that of the scores for the first number, that of the process for the second.
        assert_eq!((sure.robust(&[1.0, 0.0]), sure.robust(&[0.0, 1.0])), (9.0, 2.0));
        assert_eq!((sure.wanders(), unsure.wanders()), (false, true));
        assert!((sure.independent() - 20.0 * (0.5 / 1.5 + 0.02 / 1.98)).abs() < 1e-12);
    }
}
