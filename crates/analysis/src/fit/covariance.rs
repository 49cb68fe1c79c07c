//! How well a fit determines what was varied: the textbook covariance, and one that is honest about residuals that cling
//! together.

use super::linear::{Decomposition, Jacobian, dot, norm};
use super::plan::Plan;
use super::search::Search;
use super::statistics;

/// A direction is undetermined if the curve changes along it by less than this part of the greatest change.
const FLAT: f64 = 1e-10;
/// The autocorrelation of fewer residuals than this is not worth knowing.
const LONG: usize = 12;

/// What is known of the uncertainties at a solution. Matrices hold all columns of the search, row by row; rows and columns
/// of what is held at a bound are zero.
#[derive(Clone, Debug)]
pub(crate) struct Covariance {
    /// The inverse of the normal matrix times the variance of the residuals.
    pub textbook: Vec<f64>,
    /// The same for residuals that are correlated in time and of uneven size: Newey & West (Econometrica 55 (1987) 703), of
    /// residuals whitened before (Andrews & Monahan, Econometrica 60 (1992) 953).
    pub robust: Vec<f64>,
    /// Directions (by column) in which the curve does not change.
    pub flat: Vec<Vec<f64>>,
    /// Independent values minus determined numbers.
    pub dof: f64,
    /// How far each number must go to change the curve by as much as any other; 0 where that is nowhere.
    lengths: Vec<f64>,
}

impl Covariance {
    /// At the end of `search`, whose residuals are those of `plans`. `values` is the number of independent values; where
    /// `errors_given`, the weights are taken at their word, else they only tell ratios.
    pub fn new(search: &Search, plans: &[Plan], values: f64, errors_given: bool) -> Self {
        let size = search.x.len();
        let scale: Vec<f64> = (0..size).map(|column| norm(search.jacobian.column(column))).collect();
        let mut flat: Vec<Vec<f64>> = Vec::new();
        let mut free = Vec::new();
        for column in 0..size {
            if scale[column] == 0.0 {
                let mut direction = vec![0.0; size];
                direction[column] = 1.0;
                flat.push(direction);
            } else if !search.at_bound(column) {
                free.push(column);
            }
        }
        let known = pseudo_inverse(&search.jacobian, &free, &scale);
        flat.extend(known.flat);
        let dof = values - known.rank as f64;
        let variance = |squares: f64| if errors_given { 1.0 } else { squares / dof.max(f64::MIN_POSITIVE) };
        let mut textbook: Vec<f64> = known.inverse.iter().map(|value| value * variance(search.sum)).collect();
        // What was computed from other columns has errors that follow from theirs. Where these determine as much by themselves,
        // they alone are counted.
        if plans.iter().flat_map(|plan| &plan.points).any(|point| !point.measured) {
            let (jacobian, squares) = witnesses(search, plans);
            let alone = pseudo_inverse(&jacobian, &free, &scale);
            if alone.rank == known.rank {
                textbook = alone.inverse.iter().map(|value| value * variance(squares)).collect();
            }
        }
        let inverse = known.inverse;
        let meat = meat(search, plans, &inverse);
        let robust = product(&product(&inverse, &meat, size), &inverse, size);
        let lengths = scale.iter().map(|scale| if *scale > 0.0 { 1.0 / scale } else { 0.0 }).collect();
        Self { textbook, robust, flat, dof, lengths }
    }

    /// Whether a change along `gradient` (by column) changes the curve, so that its uncertainty is known.
    pub fn determines(&self, gradient: &[f64]) -> bool {
        // What a change of each number by its natural length would make of it.
        let parts = gradient.iter().zip(&self.lengths).fold(0.0, |sum, (slope, length)| sum + (slope * length).abs());
        self.flat.iter().all(|direction| dot(gradient, direction).abs() <= 1e-6 * parts)
    }

    /// The variance along `gradient` in one of the matrices.
    pub fn variance(matrix: &[f64], gradient: &[f64]) -> f64 {
        let size = gradient.len();
        let mut sum = 0.0;
        for row in 0..size {
            sum += gradient[row] * dot(&matrix[row * size..(row + 1) * size], gradient);
        }
        sum.max(0.0)
    }
}

/// The pseudo-inverse of a normal matrix.
struct Inverse {
    /// All columns, row by row.
    inverse: Vec<f64>,
    rank: usize,
    /// Directions in which the curve does not change.
    flat: Vec<Vec<f64>>,
}

/// V S^-2 V^T in scaled variables, of the columns `free`.
fn pseudo_inverse(jacobian: &Jacobian, free: &[usize], scale: &[f64]) -> Inverse {
    let size = jacobian.columns;
    let decomposition = Decomposition::new(jacobian, free, scale, &vec![0.0; jacobian.rows]);
    let least = FLAT * decomposition.greatest();
    let mut result = Inverse { inverse: vec![0.0; size * size], rank: 0, flat: Vec::new() };
    for (k, &singular) in decomposition.singular.iter().enumerate() {
        let right = &decomposition.right[k * free.len()..(k + 1) * free.len()];
        let mut direction = vec![0.0; size];
        free.iter().zip(right).for_each(|(&column, value)| direction[column] = value / scale[column]);
        if singular <= least {
            result.flat.push(direction);
            continue;
        }
        result.rank += 1;
        for row in 0..size {
            for column in 0..size {
                result.inverse[row * size + column] += direction[row] * direction[column] / (singular * singular);
            }
        }
    }
    result
}

/// The derivatives of what was measured, with its full weight, and its sum of squares; nothing of what was computed from it.
fn witnesses(search: &Search, plans: &[Plan]) -> (Jacobian, f64) {
    let mut jacobian = search.jacobian.clone();
    let mut squares = 0.0;
    for (place, point) in plans.iter().flat_map(|plan| &plan.points).enumerate() {
        let factor = if point.measured { 1.0 / point.share.sqrt() } else { 0.0 };
        squares += factor * factor * search.residuals[place] * search.residuals[place];
        for column in 0..jacobian.columns {
            jacobian.values[column * jacobian.rows + place] *= factor;
        }
    }
    (jacobian, squares)
}

/// The sum over times of the products of scores, those of neighbouring times with Bartlett's weights. The score of a time is
/// the gradient that its residuals contribute; columns measured at one time count together.
fn meat(search: &Search, plans: &[Plan], inverse: &[f64]) -> Vec<f64> {
    let size = search.x.len();
    let mut meat = vec![0.0; size * size];
    let mut base = 0;
    for plan in plans {
        let mut scores = vec![vec![0.0; plan.times.len()]; size];
        for observation in 0..plan.expressions.len() {
            let places = (0..plan.points.len()).filter(|&place| plan.points[place].observation == observation);
            let series: Vec<(usize, usize)> = places.map(|place| (plan.points[place].row, base + place)).collect();
            add_scores(search, &series, inverse, &mut scores);
        }
        base += plan.points.len();
        let window = statistics::lags(&scores, plan.times.len()) + 1;
        let sums: Vec<Vec<f64>> = scores.iter().map(|scores| sliding_sums(scores, window)).collect();
        for row in 0..size {
            for column in 0..=row {
                let sum = dot(&sums[row], &sums[column]) / window as f64;
                meat[row * size + column] += sum;
                if column < row {
                    meat[column * size + row] += sum;
                }
            }
        }
    }
    meat
}

/// Adds what one observation's residuals contribute; `series` holds their rows among the times and their places in the search.
///
/// A residual is a part of the one before and something new: e_t = rho e_(t-1) + u_t. The gradient sum J_t e_t is then
/// sum G_t u_t with G_t = J_t + rho G_(t+1), and what is new in one residual knows nearly nothing of the next, so that few lags
/// are left to be counted. Without this, as many lags as residuals cling together are too few of them, and errors too small.
///
/// A residual that the fit was drawn towards is made as large as it would be had the fit not known it (MacKinnon & White,
/// J. Econometrics 29 (1985) 305).
fn add_scores(search: &Search, series: &[(usize, usize)], inverse: &[f64], scores: &mut [Vec<f64>]) {
    let size = search.x.len();
    let residuals: Vec<f64> = series.iter().map(|&(_, place)| search.residuals[place]).collect();
    let rho = if residuals.len() < LONG { 0.0 } else { statistics::autocorrelation(&[&residuals]).clamp(-0.97, 0.97) };
    let mut gradient = vec![0.0; size];
    let mut following = vec![0.0; size];
    for (number, &(row, place)) in series.iter().enumerate().rev() {
        for (column, value) in gradient.iter_mut().enumerate() {
            *value = search.jacobian.values[column * search.jacobian.rows + place];
        }
        let leverage = Covariance::variance(inverse, &gradient);
        let before = if number > 0 { residuals[number - 1] } else { 0.0 };
        let new = (residuals[number] - rho * before) / (1.0 - leverage).max(0.1);
        for ((following, value), scores) in following.iter_mut().zip(&gradient).zip(scores.iter_mut()) {
            *following = value + rho * *following;
            scores[row] += *following * new;
        }
    }
}

/// The sums over all windows of this length that touch the series. Their products, added up and divided by the length, are the
/// products of the series at all lags with Bartlett's weights.
fn sliding_sums(series: &[f64], window: usize) -> Vec<f64> {
    (0..series.len() + window - 1)
        .map(|end| series[(end + 1).saturating_sub(window)..series.len().min(end + 1)].iter().sum())
        .collect()
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
