//! M-estimation: a loss that grows more slowly than the square, so that values far from the curve pull it less (P. J. Huber,
//! Robust Statistics, 1981, chapter 7).
//!
//! It is least squares with weights that follow the residuals. The scale of these is their median absolute value, made that
//! of a normal distribution. First Huber's loss with the scale that least squares leaves; its minimum is the only one
//! where the curve is linear in what is varied, and from there the chosen loss, with the scale computed again in every round,
//! until neither changes. Tukey's loss has several minima: so it begins where Huber's ends.

use super::covariance::series;
use super::criteria::EXACT;
use super::driver::Fit;
use super::linear::dot;
use super::outliers::NORMAL;
use super::search::Search;
use crate::order::median;
use units::Language;

/// What a residual costs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Loss {
    /// Its square.
    #[default]
    Squares,
    /// Its square up to 1.345 standard deviations, beyond it a straight line (P. J. Huber, Ann. Math. Statist. 35 (1964) 73): as
    /// good as 95 % of the values with least squares, where these are normal.
    Huber,
    /// The biweight (A. E. Beaton & J. W. Tukey, Technometrics 16 (1974) 147): what is beyond 4.685 standard deviations counts
    /// nothing; 95 % as well.
    Tukey,
}

impl Loss {
    /// All of them, the usual one first.
    pub const ALL: [Self; 3] = [Self::Squares, Self::Huber, Self::Tukey];

    /// Where it leaves the square, in standard deviations.
    const fn tuning(self) -> f64 {
        match self {
            Self::Squares => f64::INFINITY,
            Self::Huber => 1.345,
            Self::Tukey => 4.685,
        }
    }

    /// A short name that [`Loss::from_code`] reads.
    pub const fn code(self) -> &'static str {
        match self {
            Self::Squares => "least-squares",
            Self::Huber => "huber",
            Self::Tukey => "tukey",
        }
    }

    /// What [`Loss::code`] has written.
    pub fn from_code(code: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|loss| loss.code() == code)
    }

    /// What it is called.
    pub const fn name(self, language: Language) -> &'static str {
        match (self, language) {
            (Self::Squares, Language::English) => "least squares",
            (Self::Squares, Language::Spanish) => "mínimos cuadrados",
            (Self::Huber, Language::English) => "Huber's loss",
            (Self::Huber, Language::Spanish) => "pérdida de Huber",
            (Self::Tukey, Language::English) => "Tukey's loss",
            (Self::Tukey, Language::Spanish) => "pérdida de Tukey",
        }
    }

    /// How much a residual of so many standard deviations counts, beside its square.
    fn weight(self, z: f64) -> f64 {
        let part = z.abs() / self.tuning();
        match self {
            Self::Squares => 1.0,
            Self::Huber => 1.0 / part.max(1.0),
            Self::Tukey if part < 1.0 => (1.0 - part * part) * (1.0 - part * part),
            Self::Tukey => 0.0,
        }
    }

    /// The derivative of the residual times its weight.
    fn slope(self, z: f64) -> f64 {
        let square = (z / self.tuning()) * (z / self.tuning());
        match self {
            Self::Squares => 1.0,
            _ if square > 1.0 => 0.0,
            Self::Huber => 1.0,
            Self::Tukey => (1.0 - square) * (1.0 - 5.0 * square),
        }
    }
}

/// What a robust loss has changed.
#[derive(Clone, Debug, PartialEq)]
pub struct Reweighted {
    /// The loss.
    pub loss: Loss,
    /// The standard deviation of the residuals of the first observation of the first record, from their median size, SI.
    pub scale: f64,
    /// How many values there are.
    pub count: usize,
    /// How many count less than fully. With Huber's loss these are 18 % of normal residuals, with Tukey's all.
    pub less: usize,
    /// How many count less than half.
    pub half: usize,
    /// What least squares finds for each of [`super::Outcome::parameters`], SI.
    pub least_squares: Vec<f64>,
}

/// How far the weights are.
#[derive(Clone, Debug, Default)]
pub(super) struct Reweighting {
    /// What least squares has found, where it is finished, and the part of the scatter that it explains.
    pub least_squares: Option<(Vec<f64>, f64)>,
    /// By series: the scale of the weighted residuals.
    scales: Vec<f64>,
    /// Rounds with this loss so far.
    rounds: usize,
    /// Whether Huber's loss with the first scale is done with.
    begun: bool,
    settled: bool,
}

impl Reweighting {
    /// Rounds with a loss, at most.
    const ROUNDS: usize = 100;
    /// The scale is kept after so many: the median may jump to and fro between two residuals.
    const SCALES: usize = 50;
    /// Weights that change less than this are settled, in the first pass and in the end.
    const FIRST: f64 = 1e-2;
    const LAST: f64 = 1e-5;
}

impl Fit {
    /// Weighs all values by their residuals; where to search with these weights, or nothing where they no longer change.
    pub(super) fn reweigh_by_loss(&mut self, best: &Search) -> Option<Vec<f64>> {
        let loss = self.problem.task.loss;
        if loss == Loss::Squares || self.reweighting.settled {
            return None;
        }
        let mut state = std::mem::take(&mut self.reweighting);
        let explained = 1.0 - best.sum / self.total;
        state.least_squares.get_or_insert_with(|| (best.x.clone(), explained));
        let raw = self.unweighted(best);
        let series = series(&self.problem.plans, |_| true);
        if state.scales.is_empty() || (state.begun && state.rounds < Reweighting::SCALES) {
            state.scales = self.scales(&raw, &series);
        }
        let present = if state.begun { loss } else { Loss::Huber };
        let mut plans = std::mem::take(&mut self.problem.plans);
        let mut changed: f64 = 0.0;
        let mut points: Vec<_> =
            std::sync::Arc::make_mut(&mut plans).iter_mut().flat_map(|plan| &mut plan.points).collect();
        for (places, scale) in series.iter().zip(&state.scales) {
            for &place in places {
                let weight = present.weight(raw.residuals[place] / scale);
                // Each series in units of its own scatter, unless its errors are given.
                let trust = weight.sqrt() / scale;
                changed = changed.max((trust * scale - points[place].trust * scale).abs());
                points[place].trust = trust;
            }
        }
        drop(points);
        self.problem.plans = plans;
        state.rounds += 1;
        let last = state.rounds >= Reweighting::ROUNDS;
        if !state.begun && (changed < Reweighting::FIRST || last) {
            (state.begun, state.rounds) = (true, 0);
        } else if state.begun && (changed < Reweighting::LAST || last) {
            state.settled = true;
            self.converged &= !last;
        }
        let settled = state.settled;
        self.reweighting = state;
        (!settled).then(|| best.x.clone())
    }

    /// The residuals of a search of the whole and their derivatives as if all values counted fully.
    fn unweighted(&mut self, best: &Search) -> Search {
        let mut plans = (*self.problem.plans).clone();
        plans.iter_mut().flat_map(|plan| &mut plan.points).for_each(|point| point.trust = 1.0);
        let mut raw = best.clone();
        self.problem.residuals(&plans, &best.x, &mut raw.residuals, &mut raw.jacobian);
        raw.sum = dot(&raw.residuals, &raw.residuals);
        raw
    }

    /// The scale of each series of weighted residuals, not below that of rounding.
    fn scales(&self, raw: &Search, series: &[Vec<usize>]) -> Vec<f64> {
        let spread = self.problem.spread();
        let points = || {
            self.problem
                .plans
                .iter()
                .zip(0..)
                .flat_map(|(plan, record)| plan.points.iter().map(move |one| (record, one)))
        };
        let scale = |places: &Vec<usize>| {
            let sizes = places.iter().map(|&place| raw.residuals[place].abs()).collect();
            let least = points()
                .nth(places[0])
                .map_or(0.0, |(record, point): (usize, _)| EXACT * spread[record][point.observation] * point.weight);
            (NORMAL * median(sizes)).max(least).max(f64::MIN_POSITIVE)
        };
        series.iter().map(scale).collect()
    }

    /// A search of the whole as the statistics need it: of a robust loss with pseudo-residuals s psi(r/s)/mean(psi') instead
    /// of residuals, whose covariance is that of the estimate (Huber 1981, section 7.6, with the correction K of (6.5)).
    pub(super) fn linearised(&mut self, best: &Search) -> Search {
        let loss = self.problem.task.loss;
        if loss == Loss::Squares || self.reweighting.scales.is_empty() {
            return best.clone();
        }
        let mut raw = self.unweighted(best);
        let series = series(&self.problem.plans, |_| true);
        for (places, scale) in series.iter().zip(&self.reweighting.scales) {
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
        raw.sum = dot(&raw.residuals, &raw.residuals);
        raw
    }

    /// The residuals of a search of the whole as they are, weighted by their errors alone.
    pub(super) fn plain_residuals(&mut self, best: &Search) -> Vec<f64> {
        if self.problem.task.loss == Loss::Squares { best.residuals.clone() } else { self.unweighted(best).residuals }
    }

    /// What the loss has changed, once a fit is finished.
    pub(super) fn reweighted(&self) -> Option<Reweighted> {
        let (least_squares, _) = self.reweighting.least_squares.clone()?;
        let scales = &self.reweighting.scales;
        let points: Vec<_> = self.problem.plans.iter().flat_map(|plan| &plan.points).collect();
        let series = series(&self.problem.plans, |_| true);
        let weight = |(places, scale): (&Vec<usize>, &f64)| -> Vec<f64> {
            places.iter().map(|&place| points[place].trust * points[place].trust * scale * scale).collect()
        };
        let weights: Vec<f64> = series.iter().zip(scales).flat_map(weight).collect();
        let below = |limit: f64| weights.iter().filter(|weight| **weight < limit).count();
        let first = points.first().map_or(1.0, |point| point.weight);
        Some(Reweighted {
            loss: self.problem.task.loss,
            scale: scales.first().copied().unwrap_or(0.0) / first,
            count: weights.len(),
            less: below(1.0 - 1e-9),
            half: below(0.5),
            least_squares,
        })
    }
}

/// The degrees of freedom of the distribution by whose likelihood theories with outliers are compared.
const TAILS: f64 = 4.0;

/// Twice the negative logarithm of the likelihood of residuals of Student's distribution with four degrees of freedom, at its
/// most likely scale (K. L. Lange, R. J. A. Little & J. M. G. Taylor, J. Am. Stat. Assoc. 84 (1989) 881), but for a constant: an
/// outlier costs all theories nearly the same. `least` bounds the scale from below.
pub(super) fn deviance(residuals: &[f64], least: f64) -> f64 {
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
