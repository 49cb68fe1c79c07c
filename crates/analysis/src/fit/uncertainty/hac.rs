//! Products of scores for residuals that are autocorrelated and of uneven size (heteroskedasticity and autocorrelation
//! consistent): Newey & West (Econometrica 55 (1987) 703), with prewhitened residuals (Andrews & Monahan, Econometrica 60
//! (1992) 953).

use crate::fit::judgement::statistics;
use crate::fit::linear::{Jacobian, dot, quadratic};
use crate::fit::task::plan::Plan;

/// Least number of residuals for which the autocorrelation is estimated.
const LONG: usize = 12;

/// Residuals of a fit with their derivatives.
pub(crate) struct Left<'a> {
    /// Weighted residuals.
    pub residuals: &'a [f64],
    /// Derivatives of the residuals, one column per number.
    pub jacobian: &'a Jacobian,
    /// Columns that are determined; the others have no score.
    pub free: &'a [usize],
    /// Inverse of the normal matrix, row by row.
    pub inverse: &'a [f64],
}

/// Sum over times of the products of scores, those of neighbouring times with Bartlett weights, row by row. The score of a
/// time is the gradient contributed by its residuals; columns measured at one time count together.
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

/// Adds the scores of the residuals of one observation; `series` holds their rows among the times and their indices among
/// the residuals.
///
/// Prewhitening: e_t = rho e_(t-1) + u_t. The gradient sum J_t e_t then equals sum G_t u_t with G_t = J_t + rho G_(t+1).
/// The u_t are nearly independent, so few lags suffice. Without prewhitening the Bartlett window cuts off long-range
/// correlation and the errors come out too small.
///
/// The fit draws residuals towards zero. Division by 1 - leverage makes each as large as in a fit without its value
/// (MacKinnon & White, J. Econometrics 29 (1985) 305).
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

/// Sums over all windows of this length that overlap the series. The sum of their products, divided by the length, gives
/// the products of the series at all lags with Bartlett weights.
fn sliding_sums(series: &[f64], window: usize) -> Vec<f64> {
    let mut sums = vec![-0.0; series.len() + window - 1];
    // Each sum from its first value on; many of them at once.
    for offset in (0..window).rev() {
        sums[offset..].iter_mut().zip(series).for_each(|(sum, value)| *sum += value);
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::{dot, sliding_sums};

    #[test]
    fn products_of_sliding_sums_are_those_at_all_lags_with_bartlett_weights() {
        let one = [1.0, 2.0, -1.0, 3.0, 0.5, -2.0];
        let other = [0.5, -1.0, 4.0, 1.0, -3.0, 2.0];
        for window in 1..=8_usize {
            let mut expected = 0.0;
            for (row, value) in one.iter().enumerate() {
                for (other_row, other_value) in other.iter().enumerate() {
                    let lag = row.abs_diff(other_row) as f64;
                    expected += value * other_value * (1.0 - lag / window as f64).max(0.0);
                }
            }
            let found = dot(&sliding_sums(&one, window), &sliding_sums(&other, window)) / window as f64;
            assert!((found - expected).abs() < 1e-12, "{window}: {found} {expected}");
        }
    }
}
