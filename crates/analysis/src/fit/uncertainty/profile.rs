//! Intervals from the profile of the likelihood: one number is moved, all others are fitted again, until the fit is
//! significantly worse. Unlike standard errors they need not be symmetric.

use super::covariance::Covariance;
use crate::fit::driver::Fit;
use crate::fit::outcome::Outcome;
use crate::fit::search::problem::Problem;
use crate::fit::search::window::{TRIALS, Window};
use crate::fit::search::{Search, Status};

/// Interval of a number within which a fit is not significantly worse than the best one. An end is `None` if the fit stays
/// good up to the bound, or as far as was searched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Confidence level, assuming independent residuals.
    pub level: f64,
    /// Lower end, SI.
    pub low: Option<f64>,
    /// Upper end, SI.
    pub high: Option<f64>,
}

/// Numbers at which a profile found a sum of squares below that of the fit.
struct Lower(Vec<f64>);

/// Upper bound of the restarts from a lower minimum found by a profile.
const IMPROVEMENTS: usize = 10;
/// Least decrease of the sum of squares for a lower minimum, in variances of a residual: above the errors of integration
/// and far below those of the fit.
const LOWER: f64 = 0.01;
/// Half-widths in standard deviations, with the probability of a normal value within them.
const LEVELS: [(f64, f64); 2] = [(1.0, 0.6827), (2.0, 0.9545)];
/// Upper bound of the searches for one end.
const SEARCHES: usize = 30;
/// Farthest distance searched, in standard deviations.
const FAR: f64 = 1000.0;

/// Intervals of all varied numbers of a finished fit with its outcome; `None` for numbers without a standard error. If a
/// profile finds a lower sum of squares, the fit is restarted there, `outcome` is replaced, and all intervals are those of
/// the lower minimum; [`Outcome::improved`] counts this.
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

/// Intervals of 68.3 and 95.4 per cent for the varied number `index` of a finished fit (its index in
/// [`crate::fit::Outcome::parameters`]). `stderr`, SI, is its standard error, where the search for the ends begins; `dof`
/// the degrees of freedom. If a lower sum of squares is found, the fit is restarted there, and the intervals are those of
/// the lower minimum.
///
/// The sum of squares at the ends is that of the best fit times 1 + q^2/dof, where q is 1 and 2 standard deviations (Bates
/// & Watts, Nonlinear Regression Analysis, 1988, section 6.1).
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

/// Profile of one number.
struct Profile<'a> {
    problem: &'a mut Problem,
    /// Best answer.
    best: &'a Search,
    /// Column of the number in the search.
    index: usize,
    /// Degrees of freedom.
    dof: usize,
    /// True if a lower sum of squares ends the profile, so that the fit can be restarted there.
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

    /// Value at which the root of the growth of the sum of squares, in standard deviations, reaches `deviations`. It is
    /// nearly linear in the value, so that the secant method needs few steps; otherwise the end is bracketed. `unit` is the
    /// standard error with the sign of the side.
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
                        // At a step of the sum of squares, the end is on the side where the fit is good.
                        return Ok(Some(centre + near * unit));
                    }
                    let part = (deviations - near_growth) / (far_growth - near_growth);
                    // An infinite growth has no slope: bisection.
                    near + width * if part > 0.0 { part.clamp(0.05, 0.95) } else { 0.5 }
                }
            };
        }
        Ok(None)
    }

    /// Root of the growth of the sum of squares with the number held at `value`, in standard deviations; infinite without a
    /// curve. `x` is the start of the other numbers and receives their fitted values.
    fn growth(&mut self, x: &mut [f64], value: f64) -> Result<f64, Lower> {
        let best = self.best.sum;
        let variance = if self.problem.task.errors_given() { 1.0 } else { best / self.dof as f64 };
        let sum = self.least_with(x, value);
        if sum < best - LOWER * variance && self.may_leave {
            return Err(Lower(x.to_vec()));
        }
        Ok(((sum - best).max(0.0) / variance).sqrt())
    }

    /// Least sum of squares with the number held at `value`; infinite if there is none or the value lies outside its
    /// bounds.
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
