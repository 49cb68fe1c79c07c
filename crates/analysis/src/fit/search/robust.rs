//! M-estimation: a loss that grows more slowly than the square, so that values far from the curve pull it less (P. J.
//! Huber, Robust Statistics, 1981, chapter 7).
//!
//! It is iteratively reweighted least squares. The scale of the residuals is their median absolute value, converted to a
//! standard deviation of a normal distribution. The first pass uses Huber's loss with the scale from least squares; its
//! minimum is unique if the curve is linear in the varied numbers. From there the chosen loss is used, with the scale
//! updated in every round, until neither changes. Tukey's loss has several minima, so it begins at that of Huber's.

use super::Search;
use super::loss::Loss;
use super::problem::Problem;
use crate::fit::judgement::outliers::NORMAL;
use crate::fit::linear::dot;
use crate::fit::task::weights::EXACT;
use crate::fit::uncertainty::covariance::{Covariance, series};
use serde::{Deserialize, Serialize};
use units::order::median;

/// Effect of a robust loss.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reweighted {
    /// Loss function.
    pub loss: Loss,
    /// Standard deviation of the residuals of the first observation of the first record, from their median absolute value,
    /// SI.
    pub scale: f64,
    /// Number of values.
    pub count: usize,
    /// Number of values with a weight below 1. For normal residuals these are 18 % with Huber's loss, all with Tukey's.
    pub less: usize,
    /// Number of values with a weight below 0.5.
    pub half: usize,
    /// Least-squares estimate of each of [`crate::fit::Outcome::parameters`], SI.
    pub least_squares: Vec<f64>,
}

/// Next step after a search over the whole fitted part.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::fit) enum Continuation {
    /// Another search from here.
    From(Vec<f64>),
    /// The refinement is finished.
    End {
        /// True if the weights have converged, or none depend on the residuals.
        settled: bool,
    },
}

/// State of the iteration of the weights.
#[derive(Clone, Debug, Default)]
pub(in crate::fit) struct Reweighting {
    /// Numbers found by least squares, and their coefficient of determination; `None` until least squares is finished.
    least_squares: Option<(Vec<f64>, f64)>,
    /// One per series: scale of the weighted residuals.
    scales: Vec<f64>,
    /// Rounds with the present loss so far.
    rounds: usize,
    /// True after the first pass with Huber's loss.
    begun: bool,
    settled: bool,
}

impl Reweighting {
    /// Upper bound of the rounds with one loss.
    const ROUNDS: usize = 100;
    /// Rounds after which the scale is kept: the median may alternate between two residuals.
    const SCALES: usize = 50;
    /// Change of weights below which they have converged: in the first pass, and at the end.
    const FIRST: f64 = 1e-2;
    const LAST: f64 = 1e-5;

    /// Numbers found by least squares, and their coefficient of determination; `None` until least squares is finished.
    pub fn least_squares(&self) -> Option<&(Vec<f64>, f64)> {
        self.least_squares.as_ref()
    }

    /// Updates the weights of all values from their residuals. Returns the start of the next search, or the end if they
    /// have converged.
    pub fn next(&mut self, problem: &mut Problem, best: &Search) -> Continuation {
        let loss = problem.task.loss;
        if loss == Loss::Squares || self.settled {
            return Continuation::End { settled: true };
        }
        let explained = 1.0 - best.sum / problem.total;
        self.least_squares.get_or_insert_with(|| (best.x.clone(), explained));
        problem.search_roughly();
        let raw = unweighted(problem, best);
        let series = series(&problem.plans, |_| true);
        if self.scales.is_empty() || (self.begun && self.rounds < Self::SCALES) {
            self.scales = scales(problem, &raw, &series);
        }
        problem.deviation = 1.0;
        let present = if self.begun { loss } else { Loss::Huber };
        let mut changed: f64 = 0.0;
        let mut points: Vec<_> = problem.points_mut().collect();
        for (places, scale) in series.iter().zip(&self.scales) {
            for &place in places {
                let weight = present.weight(raw.residuals[place] / scale);
                // Each series in units of its own scatter.
                let trust = weight.sqrt() / scale;
                changed = changed.max((trust * scale - points[place].trust * scale).abs());
                points[place].trust = trust;
            }
        }
        self.rounds += 1;
        let last = self.rounds >= Self::ROUNDS;
        if !self.begun && (changed < Self::FIRST || last) {
            (self.begun, self.rounds) = (true, 0);
        } else if self.begun && (changed < Self::LAST || last) {
            self.settled = true;
            return Continuation::End { settled: !last };
        }
        Continuation::From(best.x.clone())
    }

    /// Covariance at the end of a search over the whole fitted part.
    pub fn covariance(&self, problem: &mut Problem, best: &Search) -> Covariance {
        let best = self.linearised(problem, best);
        let errors_given = problem.task.errors_given() && problem.task.loss == Loss::Squares;
        let prior = problem.deviation * self.scale_of_priors(problem);
        let values = (problem.independent_values(), errors_given);
        Covariance::new(&best, &problem.plans, values, prior, &problem.reach(&best.x))
    }

    /// Search with the residuals that the statistics need. For a robust loss these are the pseudo-residuals s
    /// psi(r/s)/mean(psi'), whose covariance is that of the estimate (Huber 1981, section 7.6, with the correction K of
    /// (6.5)).
    fn linearised(&self, problem: &mut Problem, best: &Search) -> Search {
        let loss = problem.task.loss;
        if loss == Loss::Squares || self.scales.is_empty() {
            return best.clone();
        }
        let mut raw = unweighted(problem, best);
        let series = series(&problem.plans, |_| true);
        for (places, scale) in series.iter().zip(&self.scales) {
            let count = places.len() as f64;
            let slopes = || places.iter().map(|&place| loss.slope(raw.residuals[place] / scale));
            let mean = (slopes().sum::<f64>() / count).max(0.05);
            let variance = slopes().map(|slope| (slope - mean) * (slope - mean)).sum::<f64>() / count;
            let numbers = raw.x.len() as f64 * count / raw.residuals.len() as f64;
            let factor = (1.0 + numbers / count * variance / (mean * mean)) / mean;
            for &place in places {
                raw.residuals[place] *= factor * loss.weight(raw.residuals[place] / scale);
            }
        }
        let values: usize = series.iter().map(Vec::len).sum();
        let scale = self.scale_of_priors(problem);
        for row in values..raw.residuals.len() {
            raw.residuals[row] *= scale;
            (0..raw.x.len()).for_each(|column| raw.jacobian.column_mut(column)[row] *= scale);
        }
        raw.sum = dot(&raw.residuals, &raw.residuals);
        raw
    }

    /// Factor of the priors where values are not divided by the scale of their series.
    fn scale_of_priors(&self, problem: &Problem) -> f64 {
        if problem.task.loss == Loss::Squares { 1.0 } else { self.scales.first().copied().unwrap_or(1.0) }
    }

    /// Effect of the loss, after a fit is finished; `None` for least squares.
    pub fn reweighted(&self, problem: &Problem) -> Option<Reweighted> {
        let (mut least_squares, _) = self.least_squares.clone()?;
        least_squares.truncate(least_squares.len() - problem.scales());
        let scales = &self.scales;
        let points: Vec<_> = problem.plans.iter().flat_map(|plan| &plan.points).collect();
        let series = series(&problem.plans, |_| true);
        let weight = |(places, scale): (&Vec<usize>, &f64)| -> Vec<f64> {
            places.iter().map(|&place| points[place].trust * points[place].trust * scale * scale).collect()
        };
        let weights: Vec<f64> = series.iter().zip(scales).flat_map(weight).collect();
        let below = |limit: f64| weights.iter().filter(|weight| **weight < limit).count();
        let first = points.first().map_or(1.0, |point| point.weight);
        Some(Reweighted {
            loss: problem.task.loss,
            scale: scales.first().copied().unwrap_or(0.0) / first,
            count: weights.len(),
            less: below(1.0 - 1e-9),
            half: below(0.5),
            least_squares,
        })
    }
}

/// Search with residuals and derivatives recomputed at full weight of all values.
fn unweighted(problem: &mut Problem, best: &Search) -> Search {
    let mut plans = (*problem.plans).clone();
    plans.iter_mut().flat_map(|plan| &mut plan.points).for_each(|point| point.trust = 1.0);
    let mut raw = best.clone();
    problem.residuals(&plans, &best.x, &mut raw.residuals, &mut raw.jacobian);
    raw.sum = dot(&raw.residuals, &raw.residuals);
    raw
}

/// Scale of each series of weighted residuals, bounded from below by rounding.
fn scales(problem: &Problem, raw: &Search, series: &[Vec<usize>]) -> Vec<f64> {
    let spread = problem.spread();
    let plans = || problem.plans.iter().zip(0..);
    let points = || plans().flat_map(|(plan, record)| plan.points.iter().map(move |one| (record, one)));
    let scale = |places: &Vec<usize>| {
        let sizes = places.iter().map(|&place| raw.residuals[place].abs()).collect();
        let least = points()
            .nth(places[0])
            .map_or(0.0, |(record, point): (usize, _)| EXACT * spread[record][point.observation] * point.weight);
        (NORMAL * median(sizes)).max(least).max(f64::MIN_POSITIVE)
    };
    series.iter().map(scale).collect()
}

/// Residuals at the end of a search, weighted by their errors alone.
pub(in crate::fit) fn plain_residuals(problem: &mut Problem, best: &Search) -> Vec<f64> {
    if problem.task.loss == Loss::Squares { best.residuals.clone() } else { unweighted(problem, best).residuals }
}

/// Degrees of freedom of the Student distribution in the likelihood of [`deviance`].
const TAILS: f64 = 4.0;

/// -2 log likelihood of residuals of Student's distribution with four degrees of freedom, at its most likely scale (K. L.
/// Lange, R. J. A. Little & J. M. G. Taylor, J. Am. Stat. Assoc. 84 (1989) 881), up to a constant. An outlier adds nearly
/// the same amount for all theories. `least` bounds the scale from below.
pub(in crate::fit) fn deviance(residuals: &[f64], least: f64) -> f64 {
    let count = residuals.len() as f64;
    let mut scale = (NORMAL * median(residuals.iter().map(|residual| residual.abs()).collect())).max(least);
    let square = |residual: &f64, scale: f64| (residual / scale) * (residual / scale);
    for _ in 0..500 {
        let part = |residual: &f64| {
            let z = square(residual, scale);
            (TAILS + 1.0) * z / (TAILS + z)
        };
        let next = (scale * (residuals.iter().map(part).sum::<f64>() / count).sqrt()).max(least);
        let moved = (next / scale - 1.0).abs();
        scale = next;
        if moved < 1e-12 {
            break;
        }
    }
    let cost = |residual: &f64| (TAILS + 1.0) * libm::log1p(square(residual, scale) / TAILS);
    2.0 * count * libm::log(scale) + residuals.iter().map(cost).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::deviance;

    #[test]
    fn the_deviance_is_the_least_of_all_scales() {
        let residuals = [0.3, -1.1, 0.7, 2.5, -0.2, 0.05, -0.9, 40.0, 1.3, -1.8];
        let at = |scale: f64| {
            let cost = |residual: &f64| 5.0 * libm::log(1.0 + residual * residual / (4.0 * scale * scale));
            20.0 * libm::log(scale) + residuals.iter().map(cost).sum::<f64>()
        };
        let least = (1..5_000).map(|step| at(0.001 * f64::from(step))).fold(f64::INFINITY, f64::min);
        let found = deviance(&residuals, 1e-9);
        assert!(found <= least && found > least - 1e-6, "{found} {least}");
        // A scale that is bounded from below.
        assert!((deviance(&residuals, 10.0) - at(10.0)).abs() < 1e-9);
    }
}
