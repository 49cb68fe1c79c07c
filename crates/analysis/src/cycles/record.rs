//! A record cycle by cycle: drift, cut-off values and correlated noise are found first, then each cycle is measured.

use super::cut_off::{CutOff, without_limits};
use super::cycle::{Cycle, Measured};
use super::drift::{self, Drift};
use super::estimate::{Estimate, estimate};
use super::rows::without_gaps;
use super::shape;
use super::sinusoids::{Windows, windows};
use crate::order::median;
use core::f64::consts::TAU;

/// A record, cycle by cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct Cycles {
    /// The damped sinusoid closest to the whole record, roughly.
    pub estimate: Estimate,
    /// One entry for each turning point that has both of its neighbours.
    pub cycles: Vec<Cycle>,
    /// From this time on the noise hides the oscillation, or it does not cross its middle clearly.
    pub lost: Option<f64>,
    /// True if each cycle is measured by a damped sinusoid; else periods are those between crossings of the middle, and
    /// amplitudes those of the turning points.
    pub sinusoidal: bool,
    /// The correlation of the noise in neighbouring rows, from 0 to 1. Errors account for it.
    pub correlation: f64,
    /// The drift of the level that was subtracted before the cycles were measured. Offsets include it.
    pub drift: Option<Drift>,
    /// Values cut off at an end of the range of the instrument, which were left out.
    pub cut_off: Option<CutOff>,
}

/// The reason why a record has no cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoCycles {
    /// Nothing oscillates clearly above the noise.
    Unclear,
    /// There are too few rows in a period to measure one cycle by itself: this many.
    Sparse(f64),
}

/// White noise has correlations of so many standard deviations at most.
const BEYOND_NOISE: f64 = 3.0;
/// Periods of sinusoids that are so many standard errors from those between crossings belong to another shape.
const OFF: f64 = 2.5;
/// A polynomial through a crossing misses it by this part of a period where the damping is strong, whatever the noise is.
const SYSTEMATIC: f64 = 2e-4;
/// So many times a drift is looked for in what is left without it.
const DRIFT_ROUNDS: usize = 3;
/// A cycle by itself is measured from so many rows a period at least: eight rows for the five numbers of three half-cycles.
const FEWEST_ROWS: f64 = 16.0 / 3.0;

/// Measures each cycle of values over times, both in units of the caller. A damped sinusoid with an offset of its own is fitted to
/// the three half-cycles around each turning point; errors are those of least squares, from the scatter of the residuals and
/// the correlation of the noise in neighbouring rows. Where the shape is no sinusoid, crossings of the middle and turning points
/// are measured instead: where these have the smaller errors, or their periods contradict those of the sinusoids. Rows one
/// turning point apart share two thirds of their data; those three apart share none.
///
/// # Errors
/// Where there is no oscillation of at least three turning points above the noise, and where rows are too sparse.
pub fn cycles(times: &[f64], values: &[f64]) -> Result<Cycles, NoCycles> {
    let (mut rows, cut_off) = without_limits(without_gaps(times, values));
    let (times, own): (Vec<f64>, Vec<f64>) = rows.drain(..).unzip();
    if is_white_noise(&own) {
        return Err(NoCycles::Unclear);
    }
    // The level is found first, in rounds: each shifts what is measured of the next.
    let mut values = own;
    let mut level = vec![0.0; times.len()];
    let mut rounds = 0;
    let mut found = loop {
        let estimate = estimate(&times, &values).ok_or(NoCycles::Unclear)?;
        let windows = windows(&times, &values, &estimate).ok_or(NoCycles::Unclear)?;
        let drift = if rounds < DRIFT_ROUNDS { drift::level(&windows.cycles(true).0, &times) } else { None };
        let Some(drift) = drift else { break measured(&times, &values, estimate, &windows)? };
        for ((value, level), drift) in values.iter_mut().zip(&mut level).zip(drift) {
            *value -= drift;
            *level += drift;
        }
        rounds += 1;
    };
    found.cycles.iter_mut().for_each(|cycle| cycle.offset.value += drift::at(&times, &level, cycle.time.value));
    if rounds > 0 && drift::is_significant(&found.cycles) {
        found.drift = level.first().zip(level.last()).map(|(from, to)| Drift { from: *from, to: *to });
    }
    Ok(Cycles { cut_off, ..found })
}

/// The cycles of rows without gaps and drift.
fn measured(times: &[f64], values: &[f64], estimate: Estimate, windows: &Windows) -> Result<Cycles, NoCycles> {
    let (cycles, lost, correlation) = windows.cycles(false);
    let mut found = Cycles { estimate, cycles, lost, sinusoidal: true, correlation, drift: None, cut_off: None };
    let crossings = shape::cycles(times, values, correlation);
    if is_another_shape(&found.cycles, &crossings) {
        let lost = self::lost(times, &crossings);
        found = Cycles { cycles: crossings, lost, sinusoidal: false, ..found };
    }
    let period = match found.cycles.is_empty() {
        true => TAU / estimate.angular_frequency,
        false => median(found.cycles.iter().map(|cycle| cycle.period.value).collect()),
    };
    let density = period / median(times.windows(2).map(|pair| pair[1] - pair[0]).collect());
    match density < FEWEST_ROWS {
        true => Err(NoCycles::Sparse(density)),
        false if found.cycles.is_empty() => Err(NoCycles::Unclear),
        false => Ok(found),
    }
}

/// True if rows are correlated neither with the next ones nor with those after them.
fn is_white_noise(values: &[f64]) -> bool {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    // A sinusoid of four rows a period has no correlation of neighbours.
    [1, 2].into_iter().all(|lag| {
        let pairs = values.iter().zip(values.iter().skip(lag));
        let products: f64 = pairs.map(|(one, other)| (one - mean) * (other - mean)).sum();
        products.abs() <= BEYOND_NOISE / count.sqrt() * squares
    })
}

/// The end of cycles between crossings, if the record goes on for longer than two of them.
fn lost(times: &[f64], crossings: &[Cycle]) -> Option<f64> {
    let (cycle, last) = (crossings.last()?, times.last()?);
    let end = cycle.time.value + cycle.period.value;
    (end + cycle.period.value < *last).then_some(end)
}

/// True if the cycles between crossings describe the record better than those of sinusoids, which reach further down into the
/// noise: both are compared where there are crossings.
fn is_another_shape(sinusoids: &[Cycle], crossings: &[Cycle]) -> bool {
    let end = crossings.last().map_or(f64::NEG_INFINITY, |last| last.time.value + 0.25 * last.period.value);
    let common = &sinusoids[..sinusoids.partition_point(|cycle| cycle.time.value <= end)];
    if common.is_empty() {
        return sinusoids.is_empty() && !crossings.is_empty();
    }
    let usual = |cycles: &[Cycle]| median(cycles.iter().map(|cycle| cycle.period.error).collect());
    if usual(crossings) < usual(common) {
        return true;
    }
    // Each third row shares no data with the one before.
    let mean = |cycles: &[Cycle]| {
        let independent: Vec<Measured> = cycles.iter().step_by(3).map(|cycle| cycle.period).collect();
        let count = independent.len() as f64;
        let error = independent.iter().map(|one| one.error * one.error).sum::<f64>().sqrt() / count;
        Measured { value: independent.iter().map(|one| one.value).sum::<f64>() / count, error }
    };
    let (one, other) = (mean(common), mean(crossings));
    // Of a sinusoid, the better estimate is correlated with the other one: the variance of their difference is the difference of
    // the variances (J. A. Hausman, Econometrica 46 (1978) 1251).
    let variance = (other.error * other.error - one.error * one.error).max(0.25 * one.error * one.error);
    let systematic = SYSTEMATIC * one.value;
    (one.value - other.value).abs() > OFF * (variance + systematic * systematic).sqrt()
}
