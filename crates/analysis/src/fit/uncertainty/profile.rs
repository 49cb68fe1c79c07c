//! Intervals from the profile of the likelihood: one number is moved, all others are fitted again, until the fit is
//! significantly worse. Unlike standard errors they need not be symmetric.

use super::covariance::Covariance;
use super::profile_end::{Centre, End, Lower, search, together};
use crate::fit::driver::Fit;
use crate::fit::outcome::Outcome;

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

/// Upper bound of the restarts from a lower minimum found by a profile.
const IMPROVEMENTS: usize = 10;
/// Half-widths in standard deviations, with the probability of a normal value within them.
const LEVELS: [(f64, f64); 2] = [(1.0, 0.6827), (2.0, 0.9545)];

/// Intervals of all varied numbers of a finished fit with its outcome; `None` for numbers without a standard error. If a
/// profile finds a lower sum of squares, the fit is restarted there, `outcome` is replaced, and all intervals are those of
/// the lower minimum; [`Outcome::improved`] counts this.
pub fn profiles(fit: &mut Fit, outcome: &mut Outcome) -> Vec<Option<[Interval; 2]>> {
    loop {
        let improved = fit.improved();
        let errors: Vec<(usize, f64)> = (outcome.parameters.iter().enumerate())
            .filter_map(|(index, estimate)| Some((index, estimate.stderr?)))
            .collect();
        let mut intervals = vec![None; outcome.parameters.len()];
        for ((index, stderr), found) in errors.iter().zip(found(fit, &errors, outcome.dof)) {
            intervals[*index] = Some(match found {
                Ok(intervals) => intervals,
                Err(lower) => {
                    let (stderr, dof) = leave(fit, &lower, *index).unwrap_or((*stderr, outcome.dof));
                    profile(fit, *index, stderr, dof)
                }
            });
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
        match found(fit, &[(index, stderr)], dof).pop() {
            None => return LEVELS.map(|(_, level)| Interval { level, low: None, high: None }),
            Some(Ok(intervals)) => return intervals,
            Some(Err(lower)) => (stderr, dof) = leave(fit, &lower, index).unwrap_or((stderr, dof)),
        }
    }
}

/// Restarts a fit from a lower sum of squares. Returns the standard error of a number there, SI, and the degrees of freedom.
fn leave(fit: &mut Fit, Lower(x): &Lower, index: usize) -> Option<(f64, usize)> {
    fit.go_to(x);
    let covariance = fit.covariance()?;
    let mut gradient = vec![0.0; x.len()];
    gradient[index] = 1.0;
    let stderr = Covariance::variance(&covariance.textbook, &gradient).sqrt();
    Some((stderr, covariance.dof.max(0.0) as usize))
}

/// Intervals of numbers, given as index and standard error (SI), at the present answer, up to the first that finds a lower sum of
/// squares. None if there is no answer.
fn found(fit: &mut Fit, numbers: &[(usize, f64)], dof: usize) -> Vec<Result<[Interval; 2], Lower>> {
    let may_leave = fit.improved() < IMPROVEMENTS;
    let Some((problem, best)) = fit.answer() else { return Vec::new() };
    let centre = Centre { best, dof, may_leave };
    let mut ends: Vec<End> = (numbers.iter())
        .flat_map(|&(index, stderr)| {
            let sides = move |(deviations, _)| [-stderr, stderr].map(|unit| (unit, deviations));
            LEVELS.into_iter().flat_map(sides).map(move |end| (index, end))
        })
        .map(|(index, end)| End::new(problem, &centre, index, end))
        .collect();
    let together = together(problem, best);
    for ends in ends.chunks_mut(together) {
        search(problem, &centre, ends);
        if ends.iter().any(|end| matches!(end.found, Some(Err(_)))) {
            break;
        }
    }
    let mut intervals = Vec::new();
    for ends in ends.chunks_exact_mut(2 * LEVELS.len()) {
        let ends: Option<Result<Vec<_>, Lower>> = ends.iter_mut().map(|end| end.found.take()).collect();
        let of_level = |ends: &[Option<f64>], place: usize| Interval {
            level: LEVELS[place].1,
            low: ends[2 * place],
            high: ends[2 * place + 1],
        };
        intervals.extend(ends.map(|ends| ends.map(|ends| [of_level(&ends, 0), of_level(&ends, 1)])));
    }
    intervals
}
