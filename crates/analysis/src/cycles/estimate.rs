//! Estimate of a damped sinusoid close to a record: the start of a fit.

use super::damped::{Damped, Points};
use super::lobes::{Swings, scatter, swings};
use super::rows::without_gaps;
use units::order::median;

/// Damped sinusoid `offset + amplitude exp(-damping (t - origin)) cos(angular_frequency (t - origin) + phase)` close to a
/// record. Values and times are in the units of the record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Time of the first row, from which the other numbers count.
    pub origin: f64,
    /// Level about which the record oscillates.
    pub offset: f64,
    /// Envelope at the origin, greater than 0.
    pub amplitude: f64,
    /// Angular frequency, rad per unit of time, greater than 0.
    pub angular_frequency: f64,
    /// Decay rate of the envelope, 1 per unit of time; negative if it grows.
    pub damping: f64,
    /// Phase, rad, from -pi to pi.
    pub phase: f64,
}

impl Estimate {
    /// Value of the damped sinusoid at a time.
    pub fn value(&self, time: f64) -> f64 {
        let time = time - self.origin;
        let swing = libm::cos(self.angular_frequency * time + self.phase);
        self.offset + self.amplitude * libm::exp(-self.damping * time) * swing
    }
}

/// Damped sinusoid close to a record of any scale, with gaps (NaN) or without. `None` for fewer than six points, or if all
/// times or all values are equal.
///
/// The crossings of the middle level give the frequency, the extremes between them damping and offset; three Gauss-Newton
/// steps improve them. If there are too few crossings, or that curve explains less than half of the scatter, all
/// frequencies up to the sampling limit are tried.
pub fn estimate(times: &[f64], values: &[f64]) -> Option<Estimate> {
    let rows = without_gaps(times, values);
    let (first, last) = (rows.first()?.0, rows.last()?.0);
    let (low, high) =
        rows.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), row| (low.min(row.1), high.max(row.1)));
    let (span, scale) = (last - first, high / 2.0 - low / 2.0);
    if rows.len() < 6 || !(span > 0.0 && span.is_finite()) || !(scale > 0.0 && scale.is_finite()) {
        return None;
    }
    // Times from 0 to 1, values from -1 to 1: numerically safe at any scale.
    let centre = high / 2.0 + low / 2.0;
    let times: Vec<f64> = rows.iter().map(|row| (row.0 - first) / span).collect();
    let values: Vec<f64> = rows.iter().map(|row| (row.1 - centre) / scale).collect();
    let points = Points { times: &times, values: &values };
    let best = near(points)?;
    Some(Estimate {
        origin: first,
        offset: best.linear[2] * scale + centre,
        amplitude: best.amplitude() * scale,
        angular_frequency: best.w / span,
        damping: best.g / span,
        phase: libm::atan2(-best.linear[1], best.linear[0]),
    })
}

/// Estimate for times from 0 to 1 and values from -1 to 1.
fn near(points: Points) -> Option<Damped> {
    let mut scratch = Vec::with_capacity(points.times.len());
    let mean = points.values.iter().sum::<f64>() / points.values.len() as f64;
    let total: f64 = points.values.iter().map(|value| (value - mean) * (value - mean)).sum();
    let counted = from_crossings(points, mean)
        .and_then(|(w, g)| Some(Damped::of(points, 0.0, w, g, &mut scratch)?.improved(points, 3, &mut scratch)));
    if let Some(counted) = counted.filter(|counted| counted.squares < 0.5 * total) {
        return Some(counted);
    }
    let searched = search(points, &mut scratch);
    match (counted, searched) {
        (Some(counted), Some(searched)) if counted.squares <= searched.squares => Some(counted),
        (counted, searched) => searched.or(counted),
    }
}

/// Frequency and damping from crossings and extremes.
fn from_crossings(points: Points, mean: f64) -> Option<(f64, f64)> {
    // Hysteresis of a crossing: three standard deviations of noise, at least a hundredth of the range.
    let threshold = (3.0 * scatter(points.values)).clamp(0.02, 0.3);
    let mut found = swings(points, mean, threshold);
    let mut middle = mean;
    for _ in 0..2 {
        let Some(better) = centre(&found) else { break };
        middle += better;
        found = swings(points, middle, threshold);
    }
    let half = half_period(&found.crossings)?;
    Some((core::f64::consts::PI / half, damping(&found)))
}

/// Correction of the middle level, in the unit of the values: a quarter of the sum of an extreme, twice the next, and the one after that, averaged
/// over the first few.
pub(super) fn centre(found: &Swings) -> Option<f64> {
    let whole: Vec<f64> = found.lobes.iter().filter(|lobe| !lobe.cut).map(|lobe| lobe.height).take(8).collect();
    let middles: Vec<f64> = whole.windows(3).map(|h| (h[0] + 2.0 * h[1] + h[2]) / 4.0).collect();
    (!middles.is_empty()).then(|| middles.iter().sum::<f64>() / middles.len() as f64)
}

/// Half period: slope of the crossing times over their number. A gap or noise may hide a pair of crossings.
fn half_period(crossings: &[f64]) -> Option<f64> {
    let distances: Vec<f64> = crossings.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let typical = Some(median(distances)).filter(|typical| *typical > 0.0)?;
    let mut number = 0.0;
    let mut numbers = vec![0.0];
    for pair in crossings.windows(2) {
        // Neighbouring crossings have opposite directions: an odd number of half periods lies between them.
        let pairs = (((pair[1] - pair[0]) / typical - 1.0) / 2.0).round().max(0.0);
        number += 1.0 + 2.0 * pairs;
        numbers.push(number);
    }
    slope(numbers.iter().zip(crossings).map(|(number, time)| (*number, *time, 1.0))).filter(|half| *half > 0.0)
}

/// Decay rate of the extremes, each weighted by the accuracy of its logarithm; 0 for fewer than two.
fn damping(found: &Swings) -> f64 {
    let whole = found.lobes.iter().filter(|lobe| !lobe.cut);
    let rate = slope(whole.map(|lobe| (lobe.time, libm::log(lobe.height.abs()), lobe.height * lobe.height)));
    rate.map_or(0.0, |rate| (-rate).clamp(-20.0, 100.0))
}

/// Slope of the straight line through weighted points, given as (x, y, weight).
fn slope(points: impl Iterator<Item = (f64, f64, f64)> + Clone) -> Option<f64> {
    let (weights, x, y) =
        points.clone().fold((0.0, 0.0, 0.0), |sum, (x, y, w)| (sum.0 + w, sum.1 + w * x, sum.2 + w * y));
    let (x, y) = (x / weights, y / weights);
    let (product, square) =
        points.fold((0.0, 0.0), |sum, p| (sum.0 + p.2 * (p.0 - x) * (p.1 - y), sum.1 + p.2 * (p.0 - x) * (p.0 - x)));
    let slope = product / square;
    slope.is_finite().then_some(slope)
}

/// Best of all frequencies, from a quarter of a period in the record to two rows a period.
fn search(points: Points, scratch: &mut Vec<(f64, f64)>) -> Option<Damped> {
    // Thinned, to bound the time; frequencies beyond 200 periods are found from the crossings.
    let stride = points.times.len().div_ceil(400);
    let times: Vec<f64> = points.times.iter().copied().step_by(stride).collect();
    let values: Vec<f64> = points.values.iter().copied().step_by(stride).collect();
    let few = Points { times: &times, values: &values };
    let mut best: Option<Damped> = None;
    for quarter in 1..=2 * times.len() {
        let w = core::f64::consts::TAU * 0.25 * quarter as f64;
        for g in [0.0, 4.0] {
            if let Some(trial) = Damped::of(few, 0.0, w, g, scratch)
                && best.is_none_or(|best| trial.squares < best.squares)
            {
                best = Some(trial);
            }
        }
    }
    let best = best?;
    Some(Damped::of(points, 0.0, best.w, best.g, scratch)?.improved(points, 10, scratch))
}
