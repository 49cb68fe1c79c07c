//! Intervals from the profile of the likelihood: how far a number can be moved, all others following as well as they can,
//! until the fit is visibly worse. Unlike a standard error they need not be symmetric.

use super::covariance::Covariance;
use crate::fit::driver::Fit;
use crate::fit::outcome::Outcome;
use crate::fit::search::problem::Problem;
use crate::fit::search::window::{TRIALS, Window};
use crate::fit::search::{Search, Status};

/// The values of a number between which a fit is hardly worse than the best one. An end is `None` where the fit stays good up
/// to the bound, or as far as was searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The probability that it contains the true value, if residuals knew nothing of each other.
    pub level: f64,
    /// The lower end, SI.
    pub low: Option<f64>,
    /// The upper end, SI.
    pub high: Option<f64>,
}

/// A profile has met a sum of squares below that of the fit, at these numbers.
struct Lower(Vec<f64>);

/// How often a fit goes to a lower minimum that a profile has met, at most.
const IMPROVEMENTS: usize = 10;
/// A sum of squares is lower if the difference is more than this part of the variance of a residual: what is less lies within
/// the errors of integration, and far within those of the fit.
const LOWER: f64 = 0.01;
/// Standard deviations, and the probability that a normal value lies within them.
const LEVELS: [(f64, f64); 2] = [(1.0, 0.6827), (2.0, 0.9545)];
/// Searches for one end.
const SEARCHES: usize = 30;
/// An end is not searched for farther away than so many standard deviations.
const FAR: f64 = 1000.0;

/// The intervals of all varied numbers of a finished fit, whose outcome is given; `None` for those without a standard error.
/// Where a profile meets a lower sum of squares, the fit goes there, and the outcome and all intervals are those of the
/// lower minimum: [`Outcome::improved`] says so.
pub fn profiles(fit: &mut Fit, outcome: &mut Outcome) -> Vec<Option<[Interval; 2]>> {
    loop {
        let improved = fit.improved();
        let mut intervals = Vec::with_capacity(outcome.parameters.len());
        for (index, estimate) in outcome.parameters.iter().enumerate() {
            intervals.push(estimate.stderr.map(|stderr| profile(fit, index, stderr, outcome.dof)));
            if fit.improved() > improved {
                break;
            }
        }
        match fit.outcome().filter(|_| fit.improved() > improved) {
            Some(better) => *outcome = better,
            None => return intervals,
        }
    }
}

/// The intervals of 68.3 and 95.4 per cent for the varied number `index` of a finished fit (its place in
/// [`crate::fit::Outcome::parameters`]); `stderr` is its standard error, where the search for the ends begins. Where a lower sum of
/// squares is met, the fit goes there, and the intervals are those of the lower minimum.
///
/// The sum of squares at the ends is that of the best fit times 1 + q^2/dof, q being 1 and 2 standard deviations (Bates &
/// Watts, Nonlinear Regression Analysis, 1988, section 6.1).
pub fn profile(fit: &mut Fit, index: usize, mut stderr: f64, mut dof: usize) -> [Interval; 2] {
    loop {
        let may_leave = fit.improved() < IMPROVEMENTS;
        let Some((problem, best)) = fit.answer() else {
            return LEVELS.map(|(_, level)| Interval { level, low: None, high: None });
        };
        match (Profile { problem, best, index, dof, may_leave }).intervals(stderr) {
            Ok(intervals) => return intervals,
            Err(Lower(x)) => {
                fit.go_to(&x);
                if let Some(covariance) = fit.covariance() {
                    let mut gradient = vec![0.0; x.len()];
                    gradient[index] = 1.0;
                    stderr = Covariance::variance(&covariance.textbook, &gradient).sqrt();
                    dof = covariance.dof.max(0.0) as usize;
                }
            }
        }
    }
}

/// The profile of one number.
struct Profile<'a> {
    problem: &'a mut Problem,
    /// The best answer.
    best: &'a Search,
    /// Which number of the search.
    index: usize,
    /// Degrees of freedom.
    dof: usize,
    /// Whether a lower sum of squares is gone to.
    may_leave: bool,
}

impl Profile<'_> {
    fn intervals(&mut self, stderr: f64) -> Result<[Interval; 2], Lower> {
        Ok([self.interval(stderr, LEVELS[0])?, self.interval(stderr, LEVELS[1])?])
    }

    fn interval(&mut self, stderr: f64, (deviations, level): (f64, f64)) -> Result<Interval, Lower> {
        let low = self.end(-stderr, deviations)?;
        let high = self.end(stderr, deviations)?;
        Ok(Interval { level, low, high })
    }

    /// Where the root of the growth of the sum of squares, in standard deviations, reaches `deviations`: it is nearly straight,
    /// so that the secant finds it in a few steps. Where it is not, the end is kept between a distance that is too short and one
    /// that is too long.
    fn end(&mut self, unit: f64, deviations: f64) -> Result<Option<f64>, Lower> {
        let best = self.best;
        if !(unit != 0.0 && unit.is_finite()) || self.dof == 0 || best.sum <= 0.0 {
            return Ok(None);
        }
        let centre = best.x[self.index];
        let mut others = best.x.clone();
        let (low, high) = self.problem.bounds[self.index];
        let bound = ((if unit > 0.0 { high } else { low }) - centre) / unit;
        let (mut near, mut near_growth) = (0.0, 0.0);
        let mut beyond: Option<(f64, f64)> = None;
        let mut distance = deviations.min(bound);
        for _ in 0..SEARCHES {
            let reached = self.growth(&mut others, centre + distance * unit)?;
            if (reached - deviations).abs() < 1e-3 * deviations {
                return Ok(Some(centre + distance * unit));
            }
            let slope = (reached - near_growth) / (distance - near);
            let secant = distance + (deviations - reached) / slope;
            if reached > deviations {
                beyond = Some((distance, reached));
            } else {
                if distance >= bound || distance > FAR * deviations {
                    return Ok(None);
                }
                (near, near_growth) = (distance, reached);
            }
            distance = match beyond {
                None if slope > 1e-3 => secant.clamp(1.01 * distance, 4.0 * distance).min(bound),
                None => (4.0 * distance).min(bound),
                Some((far, far_growth)) => {
                    let width = far - near;
                    if width <= 1e-9 * far {
                        // A step: the fit is good on this side of it.
                        return Ok(Some(centre + near * unit));
                    }
                    let part = (deviations - near_growth) / (far_growth - near_growth);
                    // An infinite growth has no slope.
                    near + width * if part > 0.0 { part.clamp(0.05, 0.95) } else { 0.5 }
                }
            };
        }
        Ok(None)
    }

    /// The root of the growth of the sum of squares where the number is held at `value`, in standard deviations; `x` is where the
    /// others begin, and where they end. Without a curve it is as bad as can be.
    fn growth(&mut self, x: &mut [f64], value: f64) -> Result<f64, Lower> {
        let best = self.best.sum;
        let variance = if self.problem.task.errors_given() { 1.0 } else { best / self.dof as f64 };
        let sum = self.least_with(x, value);
        if sum < best - LOWER * variance && self.may_leave {
            return Err(Lower(x.to_vec()));
        }
        Ok(((sum - best).max(0.0) / variance).sqrt())
    }

    /// The least sum of squares with the number held at `value`, infinite if there is none or it lies outside its bounds.
    fn least_with(&mut self, x: &mut [f64], value: f64) -> f64 {
        let mut bounds = self.problem.bounds.clone();
        let (low, high) = bounds[self.index];
        if !(value >= low && value <= high) {
            return f64::INFINITY;
        }
        bounds[self.index] = (value, value);
        x[self.index] = value;
        let plans = self.problem.plans.clone();
        let mut window = Window { problem: self.problem, plans: &plans };
        let mut search = window.search_within(x, bounds, TRIALS);
        while search.advance(&mut window) == Status::Searching {}
        if search.sum.is_finite() {
            x.copy_from_slice(&search.x);
        }
        search.sum
    }
}
