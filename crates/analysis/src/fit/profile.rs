//! Intervals from the profile of the likelihood: how far a number can be moved, all others following as well as they can,
//! until the fit is visibly worse. Unlike a standard error they need not be symmetric.

use super::driver::Fit;
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

/// The intervals of 68.3 and 95.4 per cent for the varied number `index` of a finished fit (its place in
/// [`super::Outcome::parameters`]); `stderr` is its standard error, where the search for the ends begins.
///
/// The sum of squares at the ends is that of the best fit times 1 + q^2/dof, q being 1 and 2 standard deviations (Bates &
/// Watts, Nonlinear Regression Analysis, 1988, section 6.1).
pub fn profile(fit: &mut Fit, index: usize, stderr: f64, dof: usize) -> [Interval; 2] {
    [(1.0, 0.6827), (2.0, 0.9545)].map(|(deviations, level)| {
        let [low, high] = [-1.0, 1.0].map(|side| end(fit, index, side * stderr, deviations, dof));
        Interval { level, low, high }
    })
}

/// Where the root of the growth of the sum of squares, in standard deviations, reaches `deviations`: it is nearly straight, so
/// that the secant finds it in a few steps.
fn end(fit: &mut Fit, index: usize, unit: f64, deviations: f64, dof: usize) -> Option<f64> {
    let best = fit.best.clone()?;
    if !(unit != 0.0 && unit.is_finite()) || dof == 0 || best.sum <= 0.0 {
        return None;
    }
    let variance = if fit.problem.task.errors_given() { 1.0 } else { best.sum / dof as f64 };
    let mut others = best.x.clone();
    let mut growth = |fit: &mut Fit, distance: f64| -> Option<f64> {
        let value = best.x[index] + distance * unit;
        let sum = least_with(fit, &mut others, index, value)?;
        Some(((sum - best.sum).max(0.0) / variance).sqrt())
    };
    let (mut near, mut near_growth) = (0.0, 0.0);
    let mut far = deviations;
    for _ in 0..12 {
        let far_growth = growth(fit, far)?;
        if (far_growth - deviations).abs() < 1e-3 * deviations {
            return Some(best.x[index] + far * unit);
        }
        let slope = (far_growth - near_growth) / (far - near);
        if slope.is_nan() || slope <= 1e-3 {
            return None;
        }
        let next = far + (deviations - far_growth) / slope;
        (near, near_growth) = (far, far_growth);
        far = next.clamp(0.1 * far, 4.0 * far);
    }
    None
}

/// The least sum of squares with one number held at `value`; `x` is where the others begin, and where they end.
fn least_with(fit: &mut Fit, x: &mut [f64], index: usize, value: f64) -> Option<f64> {
    x[index] = value;
    let plans = fit.problem.plans.clone();
    let mut search = fit.search_holding(x, &plans, index)?;
    let mut window = Window { problem: &mut fit.problem, plans: &plans };
    while search.advance(&mut window) == Status::Searching {}
    x.copy_from_slice(&search.x);
    search.sum.is_finite().then_some(search.sum)
}
