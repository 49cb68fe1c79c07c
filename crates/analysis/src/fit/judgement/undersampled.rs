//! Records whose samples are too far apart for the fitted curve. Evenly spaced samples of an oscillation above half the sampling rate
//! are those of a slower one, too, so that a fit that ended there looks perfect and is wrong.

use crate::fit::search::Search;
use crate::fit::search::problem::Problem;
use crate::fit::search::start::halton;
use crate::fit::task::plan::Plan;
use crate::fit::trace::values_at;
use crate::sampling;

/// Points of the curve between two samples.
const BETWEEN: usize = 8;
/// No more intervals are examined, from the first sample on.
const MOST: usize = 2_000;
/// The greatest standard deviation of the times from an even step, in steps: beyond it, an alias leaves residuals.
const EVEN: f64 = 0.05;
/// A turn by less than this part of the curve's range may be one of rounding.
const VISIBLE: f64 = 0.01;
/// Fewer turning points are no oscillation.
const LEAST: usize = 4;

/// The records whose fitted curve oscillates faster than their samples can show.
pub(in crate::fit) fn undersampled(problem: &mut Problem, best: &Search) -> Vec<usize> {
    let plans = problem.plans.clone();
    let is_undersampled =
        |(record, plan): &(usize, &Plan)| is_undersampled(problem, (*record, *plan), best).unwrap_or(false);
    plans.iter().enumerate().filter(is_undersampled).map(|(record, _)| record).collect()
}

/// `None` for a record without an even step.
fn is_undersampled(problem: &mut Problem, (record, plan): (usize, &Plan), best: &Search) -> Option<bool> {
    let sampling = sampling::examine(&plan.times);
    if sampling.frames.is_empty() || sampling.jitter > EVEN {
        return None;
    }
    let (first, last) = (plan.times.first()?, plan.times.last()?);
    let interval = sampling.interval;
    let intervals = ((last - first) / interval) as usize;
    // At uneven times, an oscillation that is faster than these, too, is not taken for a slow one.
    let time = |number: usize| first + interval * (number as f64 + halton(number, 1)) / BETWEEN as f64;
    let times: Vec<f64> = (0..intervals.min(MOST) * BETWEEN).map(time).collect();
    Some((0..plan.expressions.len()).any(|observation| {
        let (values, _) = values_at(problem, (record, plan), observation, &best.x, &times);
        let turns = turns(&values);
        let (Some(&begin), Some(&end)) = (turns.first(), turns.last()) else { return false };
        // Each turn is known to a step between two points.
        let lasts = times[end] - times[begin] + 2.0 * interval / BETWEEN as f64;
        turns.len() >= LEAST && lasts < (turns.len() - 1) as f64 * interval
    }))
}

/// The places of the turning points of a curve.
fn turns(values: &[f64]) -> Vec<usize> {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let least = VISIBLE * (finite().fold(f64::NEG_INFINITY, f64::max) - finite().fold(f64::INFINITY, f64::min));
    let mut turns = Vec::new();
    // The farthest point since the last turn, and whether the curve rises to it.
    let (mut farthest, mut rises) = (0, None);
    for (place, value) in values.iter().enumerate() {
        let change = value - values[farthest];
        match rises {
            Some(up) if (change > 0.0) == up && change != 0.0 => farthest = place,
            _ if change.abs() > least => {
                if rises.is_some() {
                    turns.push(farthest);
                }
                (farthest, rises) = (place, Some(change > 0.0));
            }
            _ => {}
        }
    }
    turns
}
