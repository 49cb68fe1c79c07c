//! Properties of the residuals of a fit: outliers, and the autocorrelation of the other residuals. Outliers are listed and
//! left out of the statistics, so that no single value decides the verdict.

pub(in crate::fit) mod apart;
pub(in crate::fit) mod criteria;
pub(in crate::fit) mod outliers;
pub(in crate::fit) mod rank;
pub(in crate::fit) mod statistics;
pub(in crate::fit) mod undersampled;
pub(in crate::fit) mod verdict;
pub(in crate::fit) mod words;

use super::linear::norm;
use super::observed::ObservationFit;
use super::search::problem::Problem;
use super::task::plan::Plan;
use super::task::weights::EXACT;
use super::uncertainty::covariance::series;
use apart::{Fitted, apart};
use outliers::{Judged, Off};
use serde::{Deserialize, Serialize};
use statistics::RunsTest;

/// Value far beyond the scatter of the others.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outlier {
    /// Index in [`super::Task::records`].
    pub record: usize,
    /// Index of the observation in its record.
    pub observation: usize,
    /// Row in the columns of its [`ObservationFit`].
    pub row: usize,
    /// Distance, measured minus expected from the other values, in standard deviations of these. If the fit is
    /// [`super::Outcome::misled`], the expected value is the median of the others.
    pub sigmas: f64,
}

/// Statistics of the residuals of all measured observations, without outliers.
pub(super) struct Judgement {
    /// Outliers, in the order of records, observations and rows.
    pub outliers: Vec<Outlier>,
    /// See [`super::Outcome::misled`].
    pub misled: bool,
    /// Number of judged values.
    pub count: usize,
    /// Durbin-Watson statistic.
    pub durbin_watson: f64,
    /// Correlation of each residual with the one before.
    pub autocorrelation: f64,
    /// Runs test of the signs.
    pub runs: Option<RunsTest>,
}

impl Judgement {
    /// Judges the residuals of `plans`, model minus measured, weighted by their errors; `basis` as in [`Judged`].
    pub fn new(
        problem: &Problem,
        plans: &[Plan],
        observations: &[ObservationFit],
        mut residuals: Vec<f64>,
        basis: &[Vec<f64>],
    ) -> Self {
        let series = series(plans, |measured| measured);
        let points: Vec<_> =
            plans.iter().zip(0..).flat_map(|(plan, record)| plan.points.iter().map(move |one| (record, one))).collect();
        let spread = problem.spread();
        let floor = |places: &Vec<usize>| {
            let heaviest = places.iter().map(|&place| points[place].1.weight).fold(0.0, f64::max);
            let (record, point) = points[places[0]];
            EXACT * spread[record][point.observation] * heaviest
        };
        let floors: Vec<f64> = series.iter().map(floor).collect();
        let fitted = |&place: &usize| {
            let (_, point) = points[place];
            Fitted { place, value: point.weight * point.value, residual: residuals[place] }
        };
        let far = |places: &Vec<usize>| apart(&mut places.iter().map(fitted).collect::<Vec<_>>());
        let mut off: Vec<Off> = series.iter().flat_map(far).collect();
        let misled = !off.is_empty();
        if !misled {
            off = Judged { series: &series, basis, floors: &floors }.outliers(&mut residuals);
        }
        let kept: Vec<Vec<f64>> = series
            .iter()
            .map(|places| {
                let kept = places.iter().filter(|place| off.iter().all(|off| off.place != **place));
                let mut kept: Vec<f64> = kept.map(|&place| residuals[place]).collect();
                // Each observation in units of its own scatter.
                let size = norm(&kept) / (kept.len().max(1) as f64).sqrt();
                kept.iter_mut().filter(|_| size > 0.0).for_each(|residual| *residual /= size);
                kept
            })
            .collect();
        let kept: Vec<&[f64]> = kept.iter().map(Vec::as_slice).collect();
        let outlier = |off: Off| {
            let (record, point) = points[off.place];
            let observation = point.observation;
            let fit = observations.iter().find(|one| one.record == record && one.observation == observation)?;
            // Both hold the values of an observation in the same order; the plan holds only those of the fitted part.
            let own = points[..off.place].iter().filter(|(of, one)| *of == record && one.observation == observation);
            let (row, _) = fit.inside.iter().enumerate().filter(|(_, inside)| **inside).nth(own.count())?;
            Some(Outlier { record, observation, row, sigmas: -off.sigmas })
        };
        Self {
            outliers: off.into_iter().filter_map(outlier).collect(),
            misled,
            count: kept.iter().map(|series| series.len()).sum(),
            durbin_watson: statistics::durbin_watson(&kept),
            autocorrelation: statistics::autocorrelation(&kept),
            runs: statistics::runs_test(&kept),
        }
    }
}
