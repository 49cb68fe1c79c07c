//! How well a fit determines what was varied: the textbook covariance, and one for residuals as they are, correlated in time
//! and of uneven size.

use super::hac::{self, Left};
use crate::fit::autoregression::{Autoregression, Errors, MOST};
use crate::fit::linear::{Decomposition, Jacobian, dot, norm, quadratic};
use crate::fit::search::Search;
use crate::fit::task::plan::{Plan, Point};
use crate::fit::task::weights;
use std::ops::Range;

/// A direction is undetermined if the curve changes along it by less than this part of the greatest change.
const FLAT: f64 = 1e-10;

/// What is known of the uncertainties at a solution. Matrices hold all columns of the search, row by row; rows and columns
/// of what is held at a bound are zero.
#[derive(Clone, Debug)]
pub(crate) struct Covariance {
    /// The inverse of the normal matrix times the variance of the residuals.
    pub textbook: Vec<f64>,
    /// The same for residuals correlated in time and of uneven size, from the products of scores.
    hac: Vec<f64>,
    /// The same for errors that are an autoregressive process of order one.
    autoregressive: Vec<f64>,
    /// By series: its standard deviation, which follows from that of the correlation.
    doubt: Vec<Vec<f64>>,
    /// By series: these errors.
    pub errors: Vec<Errors>,
    /// Directions (by column) in which the curve does not change.
    pub flat: Vec<Vec<f64>>,
    /// Independent values minus determined numbers.
    pub dof: f64,
    /// An orthonormal basis of what the fit can follow, each column as long as the residuals.
    pub basis: Vec<Vec<f64>>,
    /// How far each number must go to change the curve by as much as any other; 0 where that is nowhere.
    lengths: Vec<f64>,
}

impl Covariance {
    /// At the end of `search`, whose residuals are those of `plans` and below them those of priors, whose standard deviation is
    /// `prior` in units of the weighted residuals. `values` is the number of independent values; where `errors_given`, the
    /// weights are taken at their word, else they only tell ratios. `reach` is the size of a number by column.
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
        // What is known before has a variance of its own, whatever the residuals are.
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
        // What was computed from other columns has errors that follow from theirs. Where these determine as much by themselves,
        // they alone are counted.
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

    /// The variance along `gradient` for residuals as they are: the greater one of what the products of scores and what an
    /// autoregressive process of order one give. The first is too small where a record is short for its correlation, the second
    /// where errors are of uneven size.
    pub fn robust(&self, gradient: &[f64]) -> f64 {
        Self::variance(&self.hac, gradient).max(Self::variance(&self.autoregressive, gradient))
    }

    /// The degrees of freedom of that variance: as many as a sum of squares has that scatters as much (Satterthwaite, Biometrics
    /// Bull. 2 (1946) 110). The variance of the errors is known from the residuals, and their correlation with a standard
    /// deviation of its own.
    pub fn freedom(&self, gradient: &[f64]) -> f64 {
        let variance = Self::variance(&self.autoregressive, gradient);
        let doubt: f64 = self.doubt.iter().map(|doubt| quadratic(doubt, gradient)).map(|doubt| doubt * doubt).sum();
        if variance > 0.0 {
            (2.0 / (2.0 / self.dof + doubt / (variance * variance))).clamp(1.0, self.dof.max(1.0))
        } else {
            self.dof
        }
    }

    /// As many independent values would tell as much about a slow change as all do.
    pub fn independent(&self) -> f64 {
        self.errors.iter().map(Errors::independent).sum()
    }

    /// Whether the residuals of a series cannot be distinguished from a random walk.
    pub fn wanders(&self) -> bool {
        self.errors.iter().any(|errors| errors.rho >= MOST)
    }

    /// Whether a change along `gradient` (by column) changes the curve, so that its uncertainty is known.
    pub fn determines(&self, gradient: &[f64]) -> bool {
        // What a change of each number by its natural length would make of it.
        let parts = gradient.iter().zip(&self.lengths).fold(0.0, |sum, (slope, length)| sum + (slope * length).abs());
        self.flat.iter().all(|direction| dot(gradient, direction).abs() <= 1e-6 * parts)
    }

    /// The variance along `gradient` in one of the matrices.
    pub fn variance(matrix: &[f64], gradient: &[f64]) -> f64 {
        quadratic(matrix, gradient).max(0.0)
    }
}

/// A number that changes the values by less than this part of their scatter changes nothing: it is what an exact fit leaves,
/// times the steepness of a curve.
const NOTHING: f64 = 100.0 * weights::EXACT;

/// A change of all values together by less than this is nothing but rounding.
fn rounding(plans: &[Plan], scale: &[f64], reach: &[f64]) -> f64 {
    let spread = weights::spread(plans);
    let points = plans.iter().zip(&spread).flat_map(|(plan, spread)| plan.points.iter().map(move |one| (one, spread)));
    let size = |(point, spread): (&Point, &Vec<f64>)| point.weight * spread[point.observation];
    let values = norm(&points.map(size).collect::<Vec<f64>>());
    // Values that are all 0 have no size: then that of the greatest change.
    let greatest = || scale.iter().zip(reach).map(|(scale, reach)| scale * reach).fold(0.0, f64::max);
    NOTHING * if values > 0.0 { values } else { greatest() }
}

/// The places of the values of each observation of each record, in the order of time; `wanted` gets whether it was measured.
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

/// The pseudo-inverse of a normal matrix.
struct Inverse {
    /// All columns, row by row.
    inverse: Vec<f64>,
    /// Directions (by column) along which the curve changes, each by a vector of length one, all orthogonal.
    directions: Vec<Vec<f64>>,
    /// Directions in which the curve does not change.
    flat: Vec<Vec<f64>>,
}

impl Inverse {
    /// V S^-2 V^T in scaled variables, of the columns `free`.
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

    /// How the residuals change along the directions.
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

    /// The errors by series, those of priors having this standard deviation, the covariance of what is varied, and by series its standard deviation due to that of the
    /// correlation.
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

    /// A matrix of the directions as one of all columns.
    fn of_columns(&self, matrix: &[f64]) -> Vec<f64> {
        let count = self.directions.len();
        let size = self.inverse.len().isqrt();
        let mut result = vec![0.0; size * size];
        for (row, left) in self.directions.iter().enumerate() {
            // This direction's row of the product with the directions at its right.
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

/// The derivatives and residuals of what was measured, with their full weight; zero for what was computed from it.
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

/// The products of columns over some rows, times a factor, row by row.
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
