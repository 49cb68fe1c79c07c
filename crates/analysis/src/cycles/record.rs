//! Analysis of a record: drift, cut-off values and correlated noise are determined first, then each cycle is measured.

use super::cut_off::{CutOff, without_limits};
use super::cycle::{Cycle, Measured};
use super::drift::{self, Drift};
use super::estimate::{Estimate, estimate};
use super::rows::without_gaps;
use super::shape;
use super::sinusoids::{Windows, windows};
use core::f64::consts::TAU;
use units::order::median;

/// Cycles of a record.
#[derive(Clone, Debug, PartialEq)]
pub struct Cycles {
    /// Damped sinusoid close to the whole record.
    pub estimate: Estimate,
    /// Cycles, one for each turning point with both neighbours.
    pub cycles: Vec<Cycle>,
    /// Time from which on the noise hides the oscillation, or it does not cross its middle level clearly; `None` if it is
    /// measured to the end.
    pub lost: Option<f64>,
    /// True if each cycle is measured by a damped sinusoid. Else periods are those between crossings of the middle level,
    /// and amplitudes those of the turning points.
    pub sinusoidal: bool,
    /// Correlation of the noise in neighbouring rows, 0 to 1. Errors account for it.
    pub correlation: f64,
    /// Drift of the level that was subtracted before the cycles were measured; `None` if not significant. Offsets include
    /// it.
    pub drift: Option<Drift>,
    /// Values that were left out because they are cut off at an end of the range of the instrument.
    pub cut_off: Option<CutOff>,
}

/// Reason why a record has no cycles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoCycles {
    /// Nothing oscillates clearly above the noise.
    Unclear,
    /// There are too few rows per period to measure one cycle by itself: this many.
    Sparse(f64),
}

/// Greatest correlation of white noise, in its standard deviations.
const BEYOND_NOISE: f64 = 3.0;
/// Difference of the periods of sinusoids and of crossings, in standard errors, beyond which the shape is not sinusoidal.
const OFF: f64 = 2.5;
/// Systematic error of a polynomial through a crossing at strong damping, as a part of the period.
const SYSTEMATIC: f64 = 2e-4;
/// Upper bound of the rounds in which a drift is subtracted.
const DRIFT_ROUNDS: usize = 3;
/// Least number of rows per period for one cycle by itself: eight rows for the five parameters of three half-cycles.
const FEWEST_ROWS: f64 = 16.0 / 3.0;

/// Measures each cycle of values over times, both in the units of the caller. A damped sinusoid with its own offset is
/// fitted to the three half-cycles around each turning point. Errors are those of least squares, from the scatter of the
/// residuals and the correlation of the noise in neighbouring rows. If crossings of the middle level and turning points
/// give smaller errors, or their periods contradict those of the sinusoids, the shape is not sinusoidal and they are used
/// instead. Cycles one turning point apart share two thirds of their data; cycles three apart share none.
///
/// # Errors
/// There is no oscillation of at least three turning points above the noise, or rows are too sparse.
pub fn cycles(times: &[f64], values: &[f64]) -> Result<Cycles, NoCycles> {
    let (mut rows, cut_off) = without_limits(without_gaps(times, values));
    let (times, own): (Vec<f64>, Vec<f64>) = rows.drain(..).unzip();
    if is_white_noise(&own) {
        return Err(NoCycles::Unclear);
    }
    // The level is subtracted in rounds, because the measured offsets depend on it.
    let parabola = drift::parabola(&times, &own);
    let mut drifts = parabola.is_some();
    let mut level = parabola.unwrap_or_else(|| vec![0.0; times.len()]);
    let mut values: Vec<f64> = own.iter().zip(&level).map(|(value, level)| value - level).collect();
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
        drifts = true;
        rounds += 1;
    };
    found.cycles.iter_mut().for_each(|cycle| cycle.offset.value += drift::at(&times, &level, cycle.time.value));
    if drifts && drift::is_significant(&found.cycles) {
        found.drift = level.first().zip(level.last()).map(|(from, to)| Drift { from: *from, to: *to });
    }
    Ok(Cycles { cut_off, ..found })
}

/// Cycles of rows without gaps and drift.
fn measured(times: &[f64], values: &[f64], estimate: Estimate, windows: &Windows) -> Result<Cycles, NoCycles> {
    let (cycles, lost, correlation) = windows.cycles(false);
    let mut found = Cycles { estimate, cycles, lost, sinusoidal: true, correlation, drift: None, cut_off: None };
    let crossings = shape::cycles(times, values, correlation);
    let is_another_shape = is_another_shape(&found.cycles, &crossings);
    match (is_another_shape, windows.cycles_with_harmonics()) {
        (false, None) => {}
        (false, Some((cycles, lost, correlation))) => found = Cycles { cycles, lost, correlation, ..found },
        (true, harmonic) => {
            // Harmonics are no noise.
            let harmonic = harmonic.map(|(_, _, correlation)| correlation).filter(|own| *own < correlation);
            let crossings = harmonic.map_or(crossings, |correlation| shape::cycles(times, values, correlation));
            let correlation = harmonic.unwrap_or(correlation);
            let lost = self::lost(times, &crossings);
            found = Cycles { cycles: crossings, lost, correlation, sinusoidal: false, ..found };
        }
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
pub(crate) fn is_white_noise(values: &[f64]) -> bool {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    // A sinusoid with four rows per period has uncorrelated neighbours, so lag 2 is tested too.
    [1, 2].into_iter().all(|lag| {
        let pairs = values.iter().zip(values.iter().skip(lag));
        let products: f64 = pairs.map(|(one, other)| (one - mean) * (other - mean)).sum();
        products.abs() <= BEYOND_NOISE / count.sqrt() * squares
    })
}

/// End of the cycles between crossings, if the record continues for more than one period after it.
fn lost(times: &[f64], crossings: &[Cycle]) -> Option<f64> {
    let (cycle, last) = (crossings.last()?, times.last()?);
    let end = cycle.time.value + cycle.period.value;
    (end + cycle.period.value < *last).then_some(end)
}

/// True if the cycles between crossings describe the record better than those of sinusoids. Compared where there are
/// crossings, because sinusoids can be followed further into the noise.
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
    // Every third cycle shares no data with the one before.
    let mean = |cycles: &[Cycle]| {
        let independent: Vec<Measured> = cycles.iter().step_by(3).map(|cycle| cycle.period).collect();
        let count = independent.len() as f64;
        let error = independent.iter().map(|one| one.error * one.error).sum::<f64>().sqrt() / count;
        Measured { value: independent.iter().map(|one| one.value).sum::<f64>() / count, error }
    };
    let (one, other) = (mean(common), mean(crossings));
    // For a sinusoid, the more efficient estimate is correlated with the other one: the variance of their difference is the
    // difference of their variances (J. A. Hausman, Econometrica 46 (1978) 1251).
    let variance = (other.error * other.error - one.error * one.error).max(0.25 * one.error * one.error);
    let systematic = SYSTEMATIC * one.value;
    (one.value - other.value).abs() > OFF * (variance + systematic * systematic).sqrt()
}
