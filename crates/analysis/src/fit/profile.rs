//! Intervals from the profile of the likelihood: how far a number can be moved, all others following as well as they can,
//! until the fit is visibly worse. Unlike a standard error they need not be symmetric.

use super::covariance::Covariance;
use super::driver::Fit;
use super::outcome::Outcome;
use super::problem::Window;
use super::search::Status;

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
/// Searches for one end.
const SEARCHES: usize = 30;
/// An end is not searched for farther away than so many standard deviations.
const FAR: f64 = 1000.0;

/// The intervals of all varied numbers of a finished fit, whose outcome is given; `None` for those without a standard error.
/// Where a profile meets a lower sum of squares, the fit goes there, and the outcome and all intervals are those of the
/// lower minimum: [`Outcome::improved`] says so.
pub fn profiles(fit: &mut Fit, outcome: &mut Outcome) -> Vec<Option<[Interval; 2]>> {
    loop {
        let improved = fit.improved;
        let mut intervals = Vec::with_capacity(outcome.parameters.len());
        for (index, estimate) in outcome.parameters.iter().enumerate() {
            intervals.push(estimate.stderr.map(|stderr| profile(fit, index, stderr, outcome.dof)));
            if fit.improved > improved {
                break;
            }
        }
        match fit.outcome().filter(|_| fit.improved > improved) {
            Some(better) => *outcome = better,
            None => return intervals,
        }
    }
}

/// The intervals of 68.3 and 95.4 per cent for the varied number `index` of a finished fit (its place in
/// [`super::Outcome::parameters`]); `stderr` is its standard error, where the search for the ends begins. Where a lower sum of
/// squares is met, the fit goes there, and the intervals are those of the lower minimum.
///
/// The sum of squares at the ends is that of the best fit times 1 + q^2/dof, q being 1 and 2 standard deviations (Bates &
/// Watts, Nonlinear Regression Analysis, 1988, section 6.1).
pub fn profile(fit: &mut Fit, index: usize, mut stderr: f64, mut dof: usize) -> [Interval; 2] {
    loop {
        match intervals(fit, index, stderr, dof) {
            Ok(intervals) => return intervals,
            Err(Lower(x)) => {
                fit.go_to(&x);
                if let Some(best) = fit.best.clone() {
                    let covariance = fit.covariance(&best);
                    let mut gradient = vec![0.0; best.x.len()];
                    gradient[index] = 1.0;
                    stderr = Covariance::variance(&covariance.textbook, &gradient).sqrt();
                    dof = covariance.dof.max(0.0) as usize;
                }
            }
        }
    }
}

fn intervals(fit: &mut Fit, index: usize, stderr: f64, dof: usize) -> Result<[Interval; 2], Lower> {
    let mut both = |deviations: f64, level: f64| -> Result<Interval, Lower> {
        let low = end(fit, index, -stderr, deviations, dof)?;
        let high = end(fit, index, stderr, deviations, dof)?;
        Ok(Interval { level, low, high })
    };
    Ok([both(1.0, 0.6827)?, both(2.0, 0.9545)?])
}

/// Where the root of the growth of the sum of squares, in standard deviations, reaches `deviations`: it is nearly straight, so
/// that the secant finds it in a few steps. Where it is not, the end is kept between a distance that is too short and one that
/// is too long.
fn end(fit: &mut Fit, index: usize, unit: f64, deviations: f64, dof: usize) -> Result<Option<f64>, Lower> {
    let Some(best) = fit.best.clone() else { return Ok(None) };
    if !(unit != 0.0 && unit.is_finite()) || dof == 0 || best.sum <= 0.0 {
        return Ok(None);
    }
    let variance = if fit.problem.task.errors_given() { 1.0 } else { best.sum / dof as f64 };
    let mut others = best.x.clone();
    // Without a curve it is as bad as can be.
    let mut growth = |fit: &mut Fit, distance: f64| -> Result<f64, Lower> {
        let sum = least_with(fit, &mut others, index, best.x[index] + distance * unit);
        if sum < best.sum - LOWER * variance && fit.improved < IMPROVEMENTS {
            return Err(Lower(others.clone()));
        }
        Ok(((sum - best.sum).max(0.0) / variance).sqrt())
    };
    let (low, high) = fit.bounds[index];
    let bound = ((if unit > 0.0 { high } else { low }) - best.x[index]) / unit;
    let (mut near, mut near_growth) = (0.0, 0.0);
    let mut beyond: Option<(f64, f64)> = None;
    let mut distance = deviations.min(bound);
    for _ in 0..SEARCHES {
        let reached = growth(fit, distance)?;
        if (reached - deviations).abs() < 1e-3 * deviations {
            return Ok(Some(best.x[index] + distance * unit));
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
                    return Ok(Some(best.x[index] + near * unit));
                }
                let part = (deviations - near_growth) / (far_growth - near_growth);
                // An infinite growth has no slope.
                near + width * if part > 0.0 { part.clamp(0.05, 0.95) } else { 0.5 }
            }
        };
    }
    Ok(None)
}

/// The least sum of squares with one number held at `value`, infinite if there is none; `x` is where the others begin, and
/// where they end.
fn least_with(fit: &mut Fit, x: &mut [f64], index: usize, value: f64) -> f64 {
    let before = std::mem::replace(&mut x[index], value);
    let plans = fit.problem.plans.clone();
    let Some(mut search) = fit.search_holding(x, &plans, index) else {
        x[index] = before;
        return f64::INFINITY;
    };
    let mut window = Window { problem: &mut fit.problem, plans: &plans };
    while search.advance(&mut window) == Status::Searching {}
    if search.sum.is_finite() {
        x.copy_from_slice(&search.x);
    }
    search.sum
}
