//! Weights of several observations whose errors are not given: by their own scatter.

use super::Task;
use super::plan::Plan;

/// Residuals below this part of the scatter of the values are rounding and integration errors: the fit is exact.
pub(in crate::fit) const EXACT: f64 = 1e-9;

/// Values that scatter by less than this part of their mean are taken as equal.
const ROUNDING: f64 = 1e-14;

/// By record and observation: root mean square deviation of the fitted values from their mean; the absolute mean if all are
/// equal.
pub(in crate::fit) fn spread(plans: &[Plan]) -> Vec<Vec<f64>> {
    by_observation(plans, |plan, observation| {
        let values = || plan.points.iter().filter(|point| point.observation == observation).map(|point| point.value);
        let count = values().count().max(1) as f64;
        let mean = values().sum::<f64>() / count;
        let square = values().fold(0.0, |sum, value| sum + (value - mean) * (value - mean)) / count;
        // Equal values have no scatter beyond the rounding of their mean, so their magnitude is used.
        if square.sqrt() > ROUNDING * mean.abs() { square.sqrt() } else { mean.abs() }
    })
}

/// Sets the weights of all points to the reciprocals of `sizes`, given by record and observation; given errors are kept.
pub(in crate::fit) fn weigh(plans: &mut [Plan], task: &Task, sizes: &[Vec<f64>]) {
    for ((plan, record), sizes) in plans.iter_mut().zip(&task.records).zip(sizes) {
        for point in &mut plan.points {
            let given = record.observations[point.observation].errors.is_some();
            let size = sizes[point.observation];
            if !given && size > 0.0 && size.is_finite() {
                point.weight = point.share.sqrt() / size;
            }
        }
    }
}

/// Sizes for [`weigh`], from the scatter of `residuals` with the present weights. `None` if they change no weight by more
/// than 1e-4, or if at most one observation has no given errors.
pub(in crate::fit) fn sizes(plans: &[Plan], task: &Task, residuals: &[f64]) -> Option<Vec<Vec<f64>>> {
    let weighed = |record: usize, observation: usize| task.records[record].observations[observation].errors.is_none();
    let spread = spread(plans);
    let mut sizes = spread.clone();
    let mut several = 0;
    let mut changed = false;
    let mut base = 0;
    for (number, plan) in plans.iter().enumerate() {
        for (observation, size) in sizes[number].iter_mut().enumerate() {
            let mut count = 0.0;
            let mut square = 0.0;
            let mut weight = 1.0;
            for (point, residual) in plan.points.iter().zip(&residuals[base..]) {
                if point.observation == observation {
                    count += 1.0;
                    square += residual * residual / (point.weight * point.weight);
                    weight = point.weight / point.share.sqrt();
                }
            }
            if count == 0.0 || !weighed(number, observation) {
                continue;
            }
            several += 1;
            // Limits the weight of an exact observation relative to the others.
            *size = (square / count).sqrt().max(1e-9 * spread[number][observation]);
            changed |= (*size * weight - 1.0).abs() > 1e-4;
        }
        base += plan.points.len();
    }
    (several > 1 && changed).then_some(sizes)
}

/// Weighted sum of squares of all fitted values about the mean of their observation; never 0.
pub(in crate::fit) fn spread_sum(plans: &[Plan]) -> f64 {
    let mut sum = 0.0;
    for plan in plans {
        for observation in 0..plan.expressions.len() {
            let points = || plan.points.iter().filter(|point| point.observation == observation);
            let weights: f64 = points().map(|point| point.weight * point.weight).sum();
            let mean = points().map(|point| point.weight * point.weight * point.value).sum::<f64>() / weights;
            sum += points().fold(0.0, |sum, point| {
                let residual = point.weight * (point.value - mean);
                sum + residual * residual
            });
        }
    }
    if sum > 0.0 { sum } else { f64::MIN_POSITIVE }
}

fn by_observation(plans: &[Plan], measure: impl Fn(&Plan, usize) -> f64) -> Vec<Vec<f64>> {
    plans
        .iter()
        .map(|plan| (0..plan.expressions.len()).map(|observation| measure(plan, observation)).collect())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::task::plan::Point;

    /// Root mean squares about the mean; equal values have none, so their magnitude is used.
    #[test]
    fn spread_of_uneven_and_equal_values() {
        let point = |(row, (observation, value))| Point {
            row,
            observation,
            value,
            weight: 1.0,
            trust: 1.0,
            share: 1.0,
            measured: true,
            excluded: false,
        };
        let values = [(0, 1.0), (1, -2.0), (0, 2.0), (1, -2.0), (0, 6.0), (1, -2.0)];
        let points = values.into_iter().enumerate().map(point).collect();
        let plan = Plan { points, expressions: vec![0, 1], ..Plan::default() };
        let found = spread(&[plan]);
        assert!((found[0][0] - (14.0_f64 / 3.0).sqrt()).abs() < 1e-14, "{found:?}");
        assert_eq!(found[0][1], 2.0);
    }
}
