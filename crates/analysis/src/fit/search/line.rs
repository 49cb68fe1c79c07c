//! Lines in the spectrum of a series: damped sinusoids that stand out.

use crate::cycles::damped::{Damped, Points, basis};
use crate::cycles::is_white_noise;
use std::f64::consts::TAU;

/// A damped sinusoid in a series.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    /// Angular frequency, rad per unit of the times.
    pub frequency: f64,
    /// Part of the sum of squares about the mean that it explains.
    pub share: f64,
}

/// Greatest number of rows that are used; more are thinned.
const ROWS: usize = 256;
/// Least number of rows.
const FEWEST: usize = 12;
/// Least number of cycles in the record: fewer are a drift.
const CYCLES: f64 = 1.5;
/// Distance of the frequencies tried, in cycles.
const SPACING: f64 = 0.5;

/// The strongest lines of a series, at most `most`: each is sought in what the ones before leave. Empty for white noise.
pub(crate) fn lines(times: &[f64], values: &[f64], most: usize, rows: usize) -> Vec<Line> {
    let (Some(first), Some(last)) = (times.first(), times.last()) else { return Vec::new() };
    let span = last - first;
    let is_extended = span > 0.0;
    if times.len() < FEWEST || !is_extended || is_white_noise(values) {
        return Vec::new();
    }
    let stride = times.len().div_ceil(rows.min(ROWS));
    let mut rest: Vec<f64> = values.iter().copied().step_by(stride).collect();
    let times: Vec<f64> = times.iter().step_by(stride).map(|time| (time - first) / span).collect();
    let mean = rest.iter().sum::<f64>() / rest.len() as f64;
    let total: f64 = rest.iter().map(|value| (value - mean) * (value - mean)).sum();
    let mut found = Vec::new();
    let mut scratch = Vec::new();
    let mut before = total;
    while found.len() < most {
        let points = Points { times: &times, values: &rest };
        let tried = (0..=rest.len()).map(|step| TAU * (CYCLES + SPACING * step as f64));
        let tried = tried.take_while(|w| *w < 0.5 * TAU * rest.len() as f64);
        let near = tried.filter_map(|w| Damped::of(points, 0.0, w, 0.0, &mut scratch));
        let Some(near) = near.min_by(|one, other| one.squares.total_cmp(&other.squares)) else { break };
        basis(points, 0.0, near.w, near.g, &mut scratch);
        let line = near.improved(points, 10, &mut scratch);
        let share = (before - line.squares) / total;
        if !(share > 0.0 && line.w > 0.0) {
            break;
        }
        before = line.squares;
        found.push(Line { frequency: line.w / span, share });
        for (value, (c, s)) in rest.iter_mut().zip(&scratch) {
            *value -= line.linear[0] * c + line.linear[1] * s + line.linear[2];
        }
    }
    found
}
