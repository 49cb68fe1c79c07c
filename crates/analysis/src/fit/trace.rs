//! Fitted curve between the measured values, sampled finely enough to be drawn, with standard errors.

use super::linear::Jacobian;
use super::search::Search;
use super::search::problem::Problem;
use super::task::plan::{Plan, Point};
use super::uncertainty::covariance::Covariance;
use serde::{Deserialize, Serialize};

/// Fitted curve of one observation, SI.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Trace {
    /// Index in [`super::Task::records`].
    pub record: usize,
    /// Index of the observation in its record.
    pub observation: usize,
    /// Readings of the clock, evenly spaced from the first to the last measured value.
    pub times: Vec<f64>,
    /// Values of the model, its offset included; NaN where it has none.
    pub values: Vec<f64>,
    /// Standard error of each value, from the covariance of the parameters that allows for autocorrelated residuals.
    pub stderr: Vec<f64>,
}

/// Curves of all observations at the end of the search `best`, by record and observation. Each has `count` points, at least
/// 2.
pub(super) fn traces(problem: &mut Problem, best: &Search, covariance: &Covariance, count: usize) -> Vec<Trace> {
    let whole = problem.whole_plans();
    let mut traces = Vec::new();
    for (record, plan) in whole.iter().enumerate() {
        let (Some(&first), Some(&last)) = (plan.times.first(), plan.times.last()) else { continue };
        let steps = count.max(2) - 1;
        let times: Vec<f64> = (0..=steps).map(|step| first + (last - first) * (step as f64 / steps as f64)).collect();
        for observation in 0..plan.expressions.len() {
            let (values, slopes) = values_at(problem, (record, plan), observation, &best.x, &times);
            let error = |row| {
                let gradient: Vec<f64> = (0..best.x.len()).map(|column| slopes.column(column)[row]).collect();
                covariance.robust(&gradient).sqrt()
            };
            let stderr = (0..times.len()).map(error).collect();
            traces.push(Trace { record, observation, times: times.clone(), values, stderr });
        }
    }
    traces
}

/// Values of the model for one observation at ascending `times`, and their derivatives with respect to `x`. NaN where the
/// model has none.
fn values_at(
    problem: &mut Problem,
    (record, plan): (usize, &Plan),
    observation: usize,
    x: &[f64],
    times: &[f64],
) -> (Vec<f64>, Jacobian) {
    // With a measured value of 0 the residual is the value of the model.
    let point = |row| Point {
        row,
        observation,
        value: 0.0,
        weight: 1.0,
        trust: 1.0,
        share: 1.0,
        measured: true,
        excluded: false,
    };
    let points = (0..times.len()).map(point).collect();
    let plan = Plan { times: times.to_vec(), points, expressions: plan.expressions.clone(), origin: plan.origin };
    let mut values = vec![f64::NAN; times.len()];
    let mut slopes = Jacobian::new(times.len(), x.len());
    problem.record_residuals(record, &plan, x, &mut values, &mut slopes);
    (values, slopes)
}
