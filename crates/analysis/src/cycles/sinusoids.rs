//! What each cycle of an oscillation is like by itself.

use super::cycle::{Cycle, Measured};
use super::damped::{Damped, Points, basis};
use super::estimate::{Estimate, estimate};
use super::rows::without_gaps;
use super::shape;
use crate::order::median;
use core::f64::consts::{PI, TAU};
use units::Language;

/// A record, cycle by cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct Cycles {
    /// The damped sinusoid closest to the whole record, roughly.
    pub estimate: Estimate,
    /// One entry for each turning point that has both of its neighbours.
    pub cycles: Vec<Cycle>,
    /// From here on the noise hides the oscillation, or it does not cross its middle clearly.
    pub lost: Option<f64>,
    /// Whether they are those of a sinusoid; else periods are those between crossings of the middle, and amplitudes those of
    /// the turning points.
    pub sinusoidal: bool,
}

impl Cycles {
    /// Why the cycles end at a time, which is written with its unit.
    pub fn lost_text(&self, time: &str, language: Language) -> String {
        let why = match self.sinusoidal {
            true => language.pick("the noise hides the oscillation", "el ruido oculta la oscilación"),
            false => language.pick(
                "the oscillation does not cross its middle level clearly: by more than the noise and a hundredth of its range",
                "la oscilación no cruza con claridad su nivel medio: por más que el ruido y que una centésima de su recorrido",
            ),
        };
        language.pick(format!("From {time} on {why}."), format!("A partir de {time} {why}."))
    }
}

/// Half the width of a window in periods: a turning point with its two neighbours, each with its quarter of a period.
const REACH: f64 = 0.75;
/// An amplitude below so many standard errors is noise.
const CLEAR: f64 = 4.0;

/// White noise has a correlation of neighbouring rows of so many standard deviations at most.
const BEYOND_NOISE: f64 = 3.0;

/// Periods of sinusoids that are so many standard errors from those between crossings belong to another shape.
const OFF: f64 = 3.0;

/// Measures each cycle. A damped sinusoid with an offset of its own is fitted to the three half-cycles around each turning
/// point; errors are those of least squares, from the scatter of the residuals. Where the shape is no sinusoid, crossings of the
/// middle and turning points are measured instead: where these have the smaller errors, or their periods contradict those of
/// the sinusoids. Rows one turning point apart share two thirds of their data; those three apart share none. `None` where
/// there is no oscillation of at least three turning points above the noise.
pub fn cycles(times: &[f64], values: &[f64]) -> Option<Cycles> {
    let (times, values): (Vec<f64>, Vec<f64>) = without_gaps(times, values).into_iter().unzip();
    if is_white_noise(&values) {
        return None;
    }
    let estimate = estimate(&times, &values)?;
    let mut result = sinusoids(&times, &values, estimate)?;
    let crossings = shape::cycles(&times, &values);
    if is_another_shape(&result.cycles, &crossings) {
        let lost = lost(&times, &crossings);
        result = Cycles { estimate, cycles: crossings, lost, sinusoidal: false };
    }
    (!result.cycles.is_empty()).then_some(result)
}

/// Whether neighbouring rows are uncorrelated.
fn is_white_noise(values: &[f64]) -> bool {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let products: f64 = values.windows(2).map(|pair| (pair[0] - mean) * (pair[1] - mean)).sum();
    let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    products.abs() <= BEYOND_NOISE / count.sqrt() * squares
}

/// When cycles between crossings end, if the record goes on for longer than two of them.
fn lost(times: &[f64], crossings: &[Cycle]) -> Option<f64> {
    let (cycle, last) = (crossings.last()?, times.last()?);
    let end = cycle.time.value + cycle.period.value;
    (end + cycle.period.value < *last).then_some(end)
}

/// Whether the cycles between crossings are to be believed, and not those of sinusoids, which reach further down into the
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
    (one.value - other.value).abs() > OFF * libm::hypot(one.error, other.error)
}

/// The cycles of a damped sinusoid.
fn sinusoids(times: &[f64], values: &[f64], estimate: Estimate) -> Option<Cycles> {
    let (first, last) = (*times.first()?, *times.last()?);
    let mut result = Cycles { estimate, cycles: Vec::new(), lost: None, sinusoidal: true };
    let mut local = (estimate.angular_frequency, estimate.damping);
    let mut time = turning_point(&estimate, first + PI / local.0);
    let mut scratch = Vec::new();
    // The time before which nothing was seen any more, and for how many turning points.
    let mut failures = 0;
    while time + 0.98 * PI / local.0 <= last && failures < 3 {
        // A turning point that lies no later than the last one is that one again: so every round goes forwards.
        let earliest = result.cycles.last().map_or(f64::NEG_INFINITY, |last| last.time.value + 0.5 * PI / local.0);
        let found = at(times, values, time, local, &mut scratch).filter(|cycle| cycle.time.value > earliest);
        match found {
            Some(cycle) => {
                failures = 0;
                result.lost = None;
                local = (cycle.angular_frequency.value, cycle.damping.value);
                time = cycle.time.value;
                result.cycles.push(cycle);
            }
            None => {
                failures += 1;
                result.lost = result.lost.or(Some(time));
            }
        }
        time += PI / local.0;
    }
    // A gap, or an end, is not noise.
    result.lost = result.lost.filter(|_| failures >= 3);
    Some(result)
}

/// The first turning point of an estimate from `time` on.
fn turning_point(estimate: &Estimate, time: f64) -> f64 {
    let phase = estimate.angular_frequency * (time - estimate.origin)
        + estimate.phase
        + lead(estimate.damping, estimate.angular_frequency);
    time + ((phase / PI).ceil() - phase / PI) * PI / estimate.angular_frequency
}

/// By how much a damped oscillation turns before its cosine does, in radians.
fn lead(damping: f64, angular_frequency: f64) -> f64 {
    libm::atan2(damping, angular_frequency)
}

/// The cycle whose turning point is near `time`.
fn at(times: &[f64], values: &[f64], time: f64, (w, g): (f64, f64), scratch: &mut Vec<(f64, f64)>) -> Option<Cycle> {
    let mut centre = time;
    let mut found = None;
    // Once from where the turning point is expected, once more from where it is.
    for _ in 0..2 {
        let (fit, points) = fit(times, values, centre, (w, g), scratch)?;
        // Turned about so that the turning point is the next one to the centre.
        let phase = libm::atan2(-fit.linear[1], fit.linear[0]) + lead(fit.g, fit.w);
        let shift = -(phase - PI * (phase / PI).round()) / fit.w;
        if shift.abs() > 0.5 * PI / w {
            return None;
        }
        found = Some((fit, points));
        if shift.abs() < 1e-3 / w {
            break;
        }
        centre += shift;
    }
    let (fit, points) = found?;
    basis(points, fit.origin, fit.w, fit.g, scratch);
    cycle(&fit, &fit.covariance(points, scratch)?, w)
}

/// The damped sinusoid in the window about `centre`.
fn fit<'a>(
    times: &'a [f64],
    values: &'a [f64],
    centre: f64,
    (w, g): (f64, f64),
    scratch: &mut Vec<(f64, f64)>,
) -> Option<(Damped, Points<'a>)> {
    let reach = REACH * TAU / w;
    let from = times.partition_point(|time| *time < centre - reach);
    let until = times.partition_point(|time| *time <= centre + reach);
    let points = Points { times: times.get(from..until)?, values: values.get(from..until)? };
    // Fewer points than these say nothing about their own scatter.
    if points.times.len() < 8 {
        return None;
    }
    Some((Damped::of(points, centre, w, g, scratch)?.improved(points, 30, scratch), points))
}

/// What a fit says about the cycle, unless it is too unsure of it; `expected` is the frequency of its neighbours.
fn cycle(fit: &Damped, covariance: &[[f64; 5]; 5], expected: f64) -> Option<Cycle> {
    let variance = |gradient: [f64; 5]| -> f64 {
        let products = (0..5).flat_map(|i| (0..5).map(move |j| (i, j)));
        products.map(|(i, j)| gradient[i] * covariance[i][j] * gradient[j]).sum::<f64>()
    };
    let measured = |value: f64, gradient: [f64; 5]| Measured { value, error: variance(gradient).max(0.0).sqrt() };
    let (w, g) = (fit.w, fit.g);
    let [a, b, offset] = fit.linear;
    let size = fit.amplitude();
    let phase = libm::atan2(-b, a) + lead(g, w);
    let shift = -(phase - PI * (phase / PI).round()) / w;
    // The turning point is at the origin of the fit, but for the little that the last step left.
    let decay = libm::exp(-g * shift);
    let amplitude = measured(size * decay, [a / size * decay, b / size * decay, 0.0, 0.0, 0.0]);
    let square = size * size;
    let turn = w * w + g * g;
    let time =
        measured(fit.origin + shift, [-b / square / w, a / square / w, 0.0, g / turn / w - shift / w, -1.0 / turn]);
    let clear = amplitude.value > CLEAR * amplitude.error;
    let near = (0.7..1.4).contains(&(w / expected));
    (clear && near).then(|| Cycle {
        time,
        maximum: a > 0.0,
        amplitude,
        period: measured(TAU / w, [0.0, 0.0, 0.0, -TAU / (w * w), 0.0]),
        decrement: measured(TAU * g / w, [0.0, 0.0, 0.0, -TAU * g / (w * w), TAU / w]),
        angular_frequency: measured(w, [0.0, 0.0, 0.0, 1.0, 0.0]),
        damping: measured(g, [0.0, 0.0, 0.0, 0.0, 1.0]),
        offset: measured(offset, [0.0, 0.0, 1.0, 0.0, 0.0]),
    })
}
