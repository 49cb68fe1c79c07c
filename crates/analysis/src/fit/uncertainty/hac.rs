//! The products of scores for residuals that are correlated in time and of uneven size, whatever makes them so: Newey & West
//! (Econometrica 55 (1987) 703), of residuals whitened before (Andrews & Monahan, Econometrica 60 (1992) 953).

use crate::fit::judgement::statistics;
use crate::fit::linear::{Jacobian, dot, quadratic};
use crate::fit::task::plan::Plan;

/// The autocorrelation of fewer residuals than this is not worth knowing.
const LONG: usize = 12;

/// What a fit has left, column by column of what is varied.
pub(crate) struct Left<'a> {
    /// The weighted residuals.
    pub residuals: &'a [f64],
    /// Their derivatives.
    pub jacobian: &'a Jacobian,
    /// The columns that are determined at all; the others have no score.
    pub free: &'a [usize],
    /// The inverse of the normal matrix.
    pub inverse: &'a [f64],
}

/// The sum over times of the products of scores, those of neighbouring times with Bartlett's weights. The score of a time is
/// the gradient that its residuals contribute; columns measured at one time count together.
pub(crate) fn meat(left: &Left, plans: &[Plan]) -> Vec<f64> {
    let size = left.jacobian.columns;
    let mut meat = vec![0.0; size * size];
    let mut base = 0;
    for plan in plans {
        let mut scores = vec![vec![0.0; plan.times.len()]; size];
        for observation in 0..plan.expressions.len() {
            let places = (0..plan.points.len()).filter(|&place| plan.points[place].observation == observation);
            let series: Vec<(usize, usize)> = places.map(|place| (plan.points[place].row, base + place)).collect();
            add_scores(left, &series, &mut scores);
        }
        base += plan.points.len();
        let counted: Vec<&[f64]> = left.free.iter().map(|&column| scores[column].as_slice()).collect();
        let window = statistics::lags(&counted, plan.times.len()) + 1;
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

/// Adds what one observation's residuals contribute; `series` holds their rows among the times and their places.
///
/// A residual is a part of the one before and something new: e_t = rho e_(t-1) + u_t. The gradient sum J_t e_t is then
/// sum G_t u_t with G_t = J_t + rho G_(t+1). What is new in one residual is nearly independent of the next, so that few lags
/// are left to be counted. Without prewhitening the Bartlett window cuts off long-range correlation and the errors come out
/// too small.
///
/// The fit draws residuals towards zero; division by 1 - leverage makes each as large as it would be in a fit without its
/// value (MacKinnon & White, J. Econometrics 29 (1985) 305).
fn add_scores(left: &Left, series: &[(usize, usize)], scores: &mut [Vec<f64>]) {
    let size = left.jacobian.columns;
    let residuals: Vec<f64> = series.iter().map(|&(_, place)| left.residuals[place]).collect();
    let rho = if residuals.len() < LONG { 0.0 } else { statistics::autocorrelation(&[&residuals]).clamp(-0.97, 0.97) };
    let mut gradient = vec![0.0; size];
    let mut following = vec![0.0; size];
    for (number, &(row, place)) in series.iter().enumerate().rev() {
        for (column, value) in gradient.iter_mut().enumerate() {
            *value = left.jacobian.values[column * left.jacobian.rows + place];
        }
        let leverage = quadratic(left.inverse, &gradient).max(0.0);
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
