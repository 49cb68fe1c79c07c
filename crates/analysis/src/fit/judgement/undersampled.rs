//! Records sampled too slowly for the fitted curve. Evenly spaced samples of an oscillation above half the sample rate are
//! also those of a slower one (aliasing). A fit that found the fast one looks perfect and is wrong.

use crate::fit::search::Search;
use crate::fit::search::problem::Problem;
use crate::fit::task::plan::Plan;
use crate::sampling;
use engine::Routine;
use program::NodeId;

/// Points of the curve per sample interval.
const BETWEEN: usize = 8;
/// Upper bound of the number of examined intervals, from the first sample on.
const MOST: usize = 2_000;
/// Greatest standard deviation of the times from even spacing, in sample intervals: beyond it, an alias leaves residuals.
const EVEN: f64 = 0.05;
/// Turning points smaller than this part of the range of the curve may be rounding.
const VISIBLE: f64 = 0.01;
/// Least number of turning points of an oscillation.
const LEAST: usize = 4;

/// Records whose fitted curve oscillates faster than their samples can show.
pub(in crate::fit) fn undersampled(problem: &mut Problem, best: &Search) -> Vec<usize> {
    let plans = problem.plans.clone();
    let is_undersampled =
        |(record, plan): &(usize, &Plan)| is_undersampled(problem, (*record, *plan), best).unwrap_or(false);
    plans.iter().enumerate().filter(is_undersampled).map(|(record, _)| record).collect()
}

/// True if the curve of an observation has a turning point more often than once per sample interval. `None` for a record
/// without even spacing.
fn is_undersampled(problem: &mut Problem, (record, plan): (usize, &Plan), best: &Search) -> Option<bool> {
    let sampling = sampling::examine(&plan.times);
    if sampling.frames.is_empty() || sampling.jitter > EVEN {
        return None;
    }
    let (first, last) = (plan.times.first()?, plan.times.last()?);
    let interval = sampling.interval;
    let intervals = ((last - first) / interval) as usize;
    // Irregular times, so that an oscillation faster than these points is not taken for a slow one.
    let time = |(number, part): (usize, f64)| first + interval * (number as f64 + part) / BETWEEN as f64;
    let times: Vec<f64> = (0..intervals.min(MOST) * BETWEEN).zip(Irregular::new()).map(time).collect();
    let values = curves(problem, (record, plan), &best.x, &times);
    Some(values.chunks(times.len().max(1)).any(|values| {
        let turns = turns(values);
        let (Some(&begin), Some(&end)) = (turns.first(), turns.last()) else { return false };
        // Each turning point is known to one step between two points.
        let lasts = times[end] - times[begin] + 2.0 * interval / BETWEEN as f64;
        turns.len() >= LEAST && lasts < (turns.len() - 1) as f64 * interval
    }))
}

/// Coordinates of the Halton sequence in base 3: the digits of 1, 2, 3 ... mirrored at the point. Counting digit by digit takes a
/// few operations where a number takes a division per digit.
struct Irregular {
    /// Digits of the number in base 3, the lowest first.
    digits: [f64; Self::DIGITS],
    /// Number of digits without leading zeros.
    used: usize,
    /// Value of a 1 at each digit: 1/3, 1/9 ...
    parts: [f64; Self::DIGITS],
}

impl Irregular {
    /// Digits of the greatest number, and some more.
    const DIGITS: usize = 16;

    fn new() -> Self {
        let mut part = 1.0;
        let parts = std::array::from_fn(|_| {
            part /= 3.0;
            part
        });
        Self { digits: [0.0; Self::DIGITS], used: 0, parts }
    }
}

impl Iterator for Irregular {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        let raised = self.digits.iter().position(|digit| *digit < 2.0)?;
        self.digits[..raised].fill(0.0);
        self.digits[raised] += 1.0;
        self.used = self.used.max(raised + 1);
        let digits = self.digits.iter().zip(&self.parts).take(self.used);
        Some(digits.fold(0.0, |sum, (digit, part)| sum + part * digit))
    }
}

/// Values of the model at ascending `times` for the first observation of a record, then for the second, and so on: exact to a small
/// part of what is [`VISIBLE`], and without offsets and film scales, which change no turning point.
fn curves(problem: &mut Problem, (record, plan): (usize, &Plan), x: &[f64], times: &[f64]) -> Vec<f64> {
    let times: Vec<f64> = problem.times(times, problem.origin(record, plan, x)).collect();
    let nodes: Vec<NodeId> = plan.expressions.iter().map(|&number| problem.layout.expressions[number]).collect();
    let mut routine = Routine::compile(&problem.model, &nodes);
    let parameters = problem.parameters(record, x);
    problem.curve.begin_trial();
    problem.curve.shape(&mut routine, &parameters, &times)
}

/// Indices of the turning points of a curve.
fn turns(values: &[f64]) -> Vec<usize> {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let least = VISIBLE * (finite().fold(f64::NEG_INFINITY, f64::max) - finite().fold(f64::INFINITY, f64::min));
    let mut turns = Vec::new();
    // Farthest point since the last turning point, and true if the curve rises to it.
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

#[cfg(test)]
mod tests {
    use super::Irregular;
    use crate::fit::search::start::halton;

    #[test]
    fn irregular_points_are_those_of_the_halton_sequence_to_the_bit() {
        for (number, part) in (0..20_000).zip(Irregular::new()) {
            assert_eq!(part.to_bits(), halton(number, 1).to_bits(), "{number}");
        }
    }
}
