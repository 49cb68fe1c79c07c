//! Drift: a slow change of the level about which a record oscillates.

use super::constancy::mean;
use super::cycle::{Cycle, Measured};
use super::damped::{Damped, Points, basis, solve};
use super::estimate::estimate;
use core::f64::consts::TAU;

/// Slow change of the level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift {
    /// Level at the first row, in the unit of the record.
    pub from: f64,
    /// Level at the last row, in the unit of the record.
    pub to: f64,
}

/// Least number of turning points for distinguishing a drift from the oscillation.
const FEWEST: usize = 8;
/// Least excess of chi-square of a constant level over its mean, in its standard deviations, for a significant drift.
const BEYOND: f64 = 3.0;
/// Half the width of the window in which the level is approximated by a parabola, in turning points.
const REACH: usize = 6;
/// Least ratio of the squared scatter of offsets about their mean to that about a smooth curve, for a drift.
const SMOOTH: f64 = 3.0;
/// A level constant to this part of the amplitude does not drift.
const CONSTANT: f64 = 1e-6;

/// Greatest part of the sum of squared residuals of a damped sinusoid that one about a parabola leaves, for a drift.
const PARABOLIC: f64 = 0.75;
/// Least number of periods of an oscillation that a parabola does not describe.
const FEWEST_PERIODS: f64 = 2.0;
/// Greatest number of rows to which the parabola is fitted; more are thinned.
const ROWS: usize = 2000;
/// Rounds in which frequency and damping are improved about the parabola.
const ROUNDS: usize = 5;

/// Level at the times of the rows, from a parabola that is fitted together with a damped sinusoid; `None` if a constant level
/// describes the record about as well. A drift of second order would otherwise turn the last cycles, which are small, into
/// others.
pub(super) fn parabola(times: &[f64], values: &[f64]) -> Option<Vec<f64>> {
    let (first, last) = (*times.first()?, *times.last()?);
    let scaled = |time: &f64| (time - first) / (last - first) - 0.5;
    let stride = times.len().div_ceil(ROWS);
    let few: Vec<f64> = times.iter().step_by(stride).map(scaled).collect();
    let values: Vec<f64> = values.iter().copied().step_by(stride).collect();
    let points = Points { times: &few, values: &values };
    let (constant, _) = about(points, 1, [0.0; 3])?;
    // The oscillation is found in the record itself, or in what a parabola leaves of it.
    let plain = level_with(points, &vec![(0.0, 0.0); values.len()], 3)?;
    let found = [[0.0; 3], plain].into_iter().filter_map(|level| about(points, 3, level));
    let (squares, level) = found.min_by(|one, other| one.0.total_cmp(&other.0))?;
    (squares < PARABOLIC * constant).then(|| times.iter().map(|time| polynomial(&level, scaled(time))).collect())
}

/// Sum of squared residuals of a damped sinusoid about a level, and this level, a polynomial of `terms` terms. The oscillation is
/// first sought about `level`. Times from -1/2 to 1/2.
fn about(points: Points, terms: usize, level: [f64; 3]) -> Option<(f64, [f64; 3])> {
    let without = |level: &[f64; 3]| -> Vec<f64> {
        let rows = points.times.iter().zip(points.values);
        rows.map(|(time, value)| value - polynomial(level, *time)).collect()
    };
    let begin = estimate(points.times, &without(&level))?;
    let (origin, mut w, mut g) = (begin.origin, begin.angular_frequency, begin.damping);
    let mut scratch = Vec::with_capacity(points.times.len());
    let mut best: Option<(f64, [f64; 3])> = None;
    for _ in 0..ROUNDS {
        if terms > 1 && w < FEWEST_PERIODS * TAU {
            return best;
        }
        basis(points, origin, w, g, &mut scratch);
        let level = level_with(points, &scratch, terms)?;
        let rest = without(&level);
        let points = Points { values: &rest, ..points };
        let better = Damped::of(points, origin, w, g, &mut scratch)?.improved(points, 3, &mut scratch);
        (w, g) = (better.w, better.g);
        if best.as_ref().is_none_or(|(least, _)| better.squares < *least) {
            best = Some((better.squares, level));
        }
    }
    best
}

/// Level of `terms` terms by linear least squares together with the oscillation of this `basis`; its entries are 0 for none.
fn level_with(points: Points, basis: &[(f64, f64)], terms: usize) -> Option<[f64; 3]> {
    let (mut matrix, mut right) = ([[0.0; 5]; 5], [0.0; 5]);
    for ((&time, &value), &(c, s)) in points.times.iter().zip(points.values).zip(basis) {
        let mut row = [c, s, 1.0, time, time * time];
        row[2 + terms..].fill(0.0);
        for i in 0..5 {
            for j in 0..=i {
                matrix[i][j] += row[i] * row[j];
            }
            right[i] += row[i] * value;
        }
    }
    // A column without entries does not count.
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] = if row[i] == 0.0 { 1.0 } else { row[i] };
    }
    solve(matrix, right).map(|[_, _, level @ ..]| level)
}

fn polynomial([constant, slope, curvature]: &[f64; 3], x: f64) -> f64 {
    constant + x * (slope + x * curvature)
}

/// True if the level changes by more than its errors explain. Every third turning point shares no data with the one before.
pub(super) fn is_significant(cycles: &[Cycle]) -> bool {
    let independent: Vec<Measured> = cycles.iter().step_by(3).map(|cycle| cycle.offset).collect();
    let Some(constant) = mean(&independent) else { return false };
    let freedom = independent.len() as f64 - 1.0;
    let off = |one: &Measured| (one.value - constant.value) / one.error;
    let chi_square: f64 = independent.iter().map(off).map(|off| off * off).sum();
    chi_square > freedom + BEYOND * (2.0 * freedom).sqrt()
}

/// Level of these cycles at the times of the rows, from a smooth curve through their offsets; `None` if it is constant or
/// there are too few cycles.
pub(super) fn level(cycles: &[Cycle], times: &[f64]) -> Option<Vec<f64>> {
    let size = cycles.iter().fold(0.0_f64, |size, cycle| size.max(cycle.amplitude.value));
    let (low, high) = cycles.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), cycle| {
        (low.min(cycle.offset.value), high.max(cycle.offset.value))
    });
    if cycles.len() < FEWEST || high - low <= CONSTANT * size {
        return None;
    }
    // A drift is smooth: a curve explains most of the scatter of the offsets.
    let mean = cycles.iter().map(|cycle| cycle.offset.value).sum::<f64>() / cycles.len() as f64;
    let (mut about_mean, mut about_curve) = (0.0, 0.0);
    for cycle in cycles {
        let (mean, curve) = (cycle.offset.value - mean, cycle.offset.value - smooth(cycles, cycle.time.value)?);
        about_mean += mean * mean;
        about_curve += curve * curve;
    }
    if about_mean < SMOOTH * about_curve {
        return None;
    }
    let (first, last) = (*times.first()?, *times.last()?);
    let turning_points = cycles.iter().map(|cycle| cycle.time.value).filter(|time| *time > first && *time < last);
    let outer = |cycle: &Cycle, side: f64| cycle.time.value + side * 0.5 * cycle.period.value;
    let outer = [outer(cycles.first()?, -1.0), outer(cycles.last()?, 1.0)].map(|time| time.clamp(first, last));
    let knots = [first, outer[0]].into_iter().chain(turning_points).chain([outer[1], last]);
    let knots: Vec<f64> = knots.collect();
    let levels: Option<Vec<f64>> = knots.iter().map(|time| smooth(cycles, *time)).collect();
    let levels = levels?;
    Some(times.iter().map(|time| at(&knots, &levels, *time)).collect())
}

/// Linear interpolation between values at ascending times; extrapolates the first or last line.
pub(super) fn at(times: &[f64], values: &[f64], time: f64) -> f64 {
    let place = times.partition_point(|knot| *knot <= time).min(times.len().saturating_sub(1)).max(1);
    match (times.get(place - 1..=place), values.get(place - 1..=place)) {
        (Some(&[before, after]), Some(&[low, high])) if after > before => {
            low + (high - low) * (time - before) / (after - before)
        }
        _ => values.get(place - 1).copied().unwrap_or(0.0),
    }
}

/// Level at a time from a parabola through the nearby offsets, nearer ones with greater weight (W. S. Cleveland, J. Am.
/// Stat. Assoc. 74 (1979) 829). Constant from half a period beyond the outer turning points.
fn smooth(cycles: &[Cycle], time: f64) -> Option<f64> {
    let half = |cycle: &Cycle| 0.5 * cycle.period.value;
    let (first, last) = (cycles.first()?, cycles.last()?);
    let time = time.clamp(first.time.value - half(first), last.time.value + half(last));
    let width = (2 * REACH + 1).min(cycles.len());
    let place = cycles.partition_point(|cycle| cycle.time.value < time);
    let near = cycles.get(place.saturating_sub(REACH).min(cycles.len() - width)..)?.get(..width)?;
    let reach = near.iter().fold(0.0_f64, |reach, cycle| reach.max((cycle.time.value - time).abs()));
    let (mut matrix, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
    for cycle in near {
        let x = (cycle.time.value - time) / (1.05 * reach);
        let part = 1.0 - x.abs() * x * x;
        let weight = part * part * part / (cycle.offset.error * cycle.offset.error);
        let powers = [1.0, x, x * x];
        for (row, power) in powers.iter().enumerate() {
            right[row] += weight * power * cycle.offset.value;
            for (entry, other) in matrix[row].iter_mut().zip(&powers) {
                *entry += weight * power * other;
            }
        }
    }
    solve(matrix, right).map(|[level, ..]| level).filter(|level| level.is_finite())
}
