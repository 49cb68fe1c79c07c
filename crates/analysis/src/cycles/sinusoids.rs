//! The cycles of a damped sinusoid, each from a fit to the three half-cycles around one turning point.

use super::cycle::{Cycle, Measured};
use super::damped::{Damped, Points, basis};
use super::estimate::Estimate;
use crate::fit::autoregression::{Block, common_correlation};
use core::f64::consts::{PI, TAU};

/// Half the width of a window in periods: a turning point with its two neighbours, each with its quarter of a period.
const REACH: f64 = 0.75;
/// An amplitude below so many standard errors is noise.
const CLEAR: f64 = 4.0;

/// A damped sinusoid fitted to the half-cycles around one turning point, and the rows that it was fitted to.
struct Window<'a> {
    fit: Damped,
    points: Points<'a>,
    /// Angular frequency that its neighbours let expect.
    expected: f64,
}

/// So many turning points in a row that are not seen clearly end the table.
const FAILURES: usize = 3;

/// Damped sinusoids about all turning points that stand clear of white noise.
pub(super) struct Windows<'a> {
    windows: Vec<Window<'a>>,
    /// The time from which on nothing is seen.
    lost: Option<f64>,
}

impl Windows<'_> {
    /// The cycles, the time of their end where noise hides the rest, and the correlation of the noise in neighbouring rows. A
    /// level that `drifts` counts as no noise.
    pub(super) fn cycles(&self, drifts: bool) -> (Vec<Cycle>, Option<f64>, f64) {
        let mut scratch = Vec::new();
        let blocks: Vec<Block> = self.windows.iter().map(|window| window.residuals(drifts, &mut scratch)).collect();
        // Windows three turning points apart share no rows.
        let rho = common_correlation(blocks.iter().step_by(3)).max(0.0);
        let mut cycles: Vec<Cycle> = Vec::with_capacity(self.windows.len());
        let mut failures = 0;
        for (window, variance) in self.windows.iter().zip(variances(&blocks, rho)) {
            match window.cycle(variance, rho, &mut scratch) {
                Some(cycle) => {
                    failures = 0;
                    cycles.push(cycle);
                }
                None if failures + 1 < FAILURES => failures += 1,
                None => {
                    let lost = cycles.last().map(|last| last.time.value + 0.5 * last.period.value);
                    return (cycles, lost, rho);
                }
            }
        }
        (cycles, self.lost, rho)
    }
}

/// The variance of the noise in each window. One window has few rows, so that its own variance is uncertain; it is drawn towards
/// that of all windows, the more so the less the variances differ beyond that uncertainty (G. K. Smyth, Stat. Appl. Genet. Mol.
/// Biol. 3 (2004) 3).
fn variances(blocks: &[Block], rho: f64) -> Vec<f64> {
    let own: Vec<f64> = blocks.iter().map(|block| block.variance(rho)).collect();
    // The degrees of freedom of a variance of correlated residuals.
    let independent = (1.0 - rho * rho) / (1.0 + rho * rho);
    let freedoms: Vec<f64> = blocks.iter().map(|block| (block.freedom() as f64 * independent).max(1.0)).collect();
    let count = own.len() as f64;
    // Logarithms of chi-square over its degrees of freedom f have about the mean -1/f and the variance 2/f.
    let logarithms: Vec<f64> =
        own.iter().zip(&freedoms).map(|(variance, freedom)| libm::log(*variance) + 1.0 / freedom).collect();
    let mean = logarithms.iter().sum::<f64>() / count;
    let scatter = logarithms.iter().map(|one| (one - mean) * (one - mean)).sum::<f64>() / (count - 1.0);
    let expected = freedoms.iter().map(|freedom| 2.0 / freedom).sum::<f64>() / count;
    let common = libm::exp(mean);
    // As many degrees of freedom as the common variance is worth; all windows together where nothing speaks against it.
    let worth = if scatter > expected { 2.0 / (scatter - expected) } else { f64::INFINITY };
    let worth = worth.min(freedoms.iter().sum::<f64>() / 3.0);
    if !(common.is_finite() && worth.is_finite()) {
        return own;
    }
    own.iter().zip(&freedoms).map(|(own, freedom)| (freedom * own + worth * common) / (freedom + worth)).collect()
}

/// The windows about the turning points of a record, from a damped sinusoid close to it.
pub(super) fn windows<'a>(times: &'a [f64], values: &'a [f64], estimate: &Estimate) -> Option<Windows<'a>> {
    let (first, last) = (*times.first()?, *times.last()?);
    let mut windows: Vec<Window> = Vec::new();
    let mut before: Option<Cycle> = None;
    let mut lost = None;
    let mut local = (estimate.angular_frequency, estimate.damping);
    let mut time = turning_point(estimate, first + PI / local.0);
    let mut scratch = Vec::new();
    // The time before which nothing was seen any more, and for how many turning points.
    let mut failures = 0;
    while time + 0.98 * PI / local.0 <= last && failures < FAILURES {
        // A turning point that lies no later than the last one is that one again: so every round goes forwards.
        let earliest = before.map_or(f64::NEG_INFINITY, |before| before.time.value + 0.5 * PI / local.0);
        let found = at(times, values, time, local, &mut scratch);
        let clear = found.and_then(|window| {
            let variance = window.residuals(false, &mut scratch).variance(0.0);
            Some((window.cycle(variance, 0.0, &mut scratch)?, window))
        });
        match clear.filter(|(cycle, _)| cycle.time.value > earliest) {
            Some((cycle, window)) => {
                failures = 0;
                lost = None;
                local = (cycle.angular_frequency.value, cycle.damping.value);
                time = cycle.time.value;
                before = Some(cycle);
                windows.push(window);
            }
            None => {
                failures += 1;
                lost = lost.or(Some(time));
            }
        }
        time += PI / local.0;
    }
    // A gap, or an end, is not noise.
    Some(Windows { windows, lost: lost.filter(|_| failures >= FAILURES) })
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

/// The window about the turning point near `time`.
fn at<'a>(
    times: &'a [f64],
    values: &'a [f64],
    time: f64,
    (w, g): (f64, f64),
    scratch: &mut Vec<(f64, f64)>,
) -> Option<Window<'a>> {
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
        found = Some(Window { fit, points, expected: w });
        if shift.abs() < 1e-3 / w {
            break;
        }
        centre += shift;
    }
    found
}

impl Window<'_> {
    /// The residuals; a level that `drifts` is no part of them.
    fn residuals(&self, drifts: bool, scratch: &mut Vec<(f64, f64)>) -> Block {
        basis(self.points, self.fit.origin, self.fit.w, self.fit.g, scratch);
        self.fit.residuals(self.points, scratch, drifts)
    }

    /// The cycle, unless too little is known of it, for noise of this variance that is correlated by `rho` in neighbouring rows.
    fn cycle(&self, variance: f64, rho: f64, scratch: &mut Vec<(f64, f64)>) -> Option<Cycle> {
        basis(self.points, self.fit.origin, self.fit.w, self.fit.g, scratch);
        cycle(&self.fit, &self.fit.covariance(self.points, scratch, variance, rho)?, self.expected)
    }
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
