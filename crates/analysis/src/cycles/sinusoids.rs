//! Cycles of a damped sinusoid, each from a fit to the three half-cycles around one turning point.

use super::cycle::{Cycle, Measured};
use super::damped::{Damped, Points, basis, covariance, normal};
use super::estimate::Estimate;
use crate::fit::autoregression::{Block, common_correlation};
use core::f64::consts::{PI, TAU};

/// Half the width of a window in periods: a turning point and its two neighbours, with a quarter of a period beyond them.
const REACH: f64 = 0.75;
/// Least amplitude in standard errors; below it is noise.
const CLEAR: f64 = 4.0;

/// Damped sinusoid fitted to the half-cycles around one turning point, with its rows.
struct Window<'a> {
    fit: Damped,
    points: Points<'a>,
    /// Angular frequency expected from the neighbours.
    expected: f64,
}

/// Least ratio of the variance that harmonics explain, by number, to the remaining one, for a shape with harmonics. In white noise
/// it is about 1.
const HARMONIC: f64 = 3.0;

/// Number of consecutive unclear turning points that ends the table.
const FAILURES: usize = 3;

/// Damped sinusoids about all turning points that are clear of white noise.
pub(super) struct Windows<'a> {
    windows: Vec<Window<'a>>,
    /// Time from which on no turning point is clear.
    lost: Option<f64>,
}

impl Windows<'_> {
    /// Cycles, the time of their end if noise hides the rest, and the correlation of the noise in neighbouring rows. With
    /// `drifts`, a drift of the level does not count as noise.
    pub(super) fn cycles(&self, drifts: bool) -> (Vec<Cycle>, Option<f64>, f64) {
        let mut scratch = Vec::new();
        let blocks: Vec<Block> = self.windows.iter().map(|window| window.residuals(drifts, &mut scratch)).collect();
        self.measured(&blocks, |window, variance, rho| self.windows[window].cycle(variance, rho, &mut scratch))
    }

    /// [`Windows::cycles`] of a shape with harmonics, which are fitted with the oscillation in each window; `None` if the windows
    /// show none.
    pub(super) fn cycles_with_harmonics(&self) -> Option<(Vec<Cycle>, Option<f64>, f64)> {
        let mut scratch = Vec::new();
        let (mut explained, mut left, mut freedom) = (0.0, 0.0, 0.0);
        let (mut fits, mut blocks) = (Vec::new(), Vec::new());
        for window in &self.windows {
            let plain = window.residuals(false, &mut scratch);
            let (fit, columns, block) = window.fit.with_harmonics(window.points, &mut scratch)?;
            explained += plain.squares() - block.squares();
            left += block.squares();
            freedom += block.freedom() as f64;
            fits.push((fit, columns));
            blocks.push(block);
        }
        let harmonics = 4.0 * fits.len() as f64;
        let is_significant = explained / harmonics > HARMONIC * left / freedom;
        if !is_significant {
            return None;
        }
        Some(self.measured(&blocks, |window, variance, rho| {
            let (fit, columns) = &fits[window];
            cycle(fit, &covariance(normal(columns), columns, variance, rho)?, self.windows[window].expected)
        }))
    }

    /// Cycles of all windows with these residuals; `cycle` makes that of a window from the variance and the correlation of the noise.
    fn measured(
        &self,
        blocks: &[Block],
        mut cycle: impl FnMut(usize, f64, f64) -> Option<Cycle>,
    ) -> (Vec<Cycle>, Option<f64>, f64) {
        // Windows three turning points apart share no rows.
        let rho = common_correlation(blocks.iter().step_by(3)).max(0.0);
        let mut cycles: Vec<Cycle> = Vec::with_capacity(self.windows.len());
        let mut failures = 0;
        for (window, variance) in variances(blocks, rho).into_iter().enumerate() {
            match cycle(window, variance, rho) {
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

/// Variance of the noise in each window. One window has few rows, so that its own variance is uncertain. It is shrunk
/// towards the common variance of all windows; the less the variances differ beyond their uncertainty, the more (G. K.
/// Smyth, Stat. Appl. Genet. Mol. Biol. 3 (2004) 3).
fn variances(blocks: &[Block], rho: f64) -> Vec<f64> {
    let own: Vec<f64> = blocks.iter().map(|block| block.variance(rho)).collect();
    // Degrees of freedom of a variance of correlated residuals.
    let independent = (1.0 - rho * rho) / (1.0 + rho * rho);
    let freedoms: Vec<f64> = blocks.iter().map(|block| (block.freedom() as f64 * independent).max(1.0)).collect();
    let count = own.len() as f64;
    // The logarithm of chi-square over its degrees of freedom f has a mean of about -1/f and a variance of about 2/f.
    let logarithms: Vec<f64> =
        own.iter().zip(&freedoms).map(|(variance, freedom)| libm::log(*variance) + 1.0 / freedom).collect();
    let mean = logarithms.iter().sum::<f64>() / count;
    let scatter = logarithms.iter().map(|one| (one - mean) * (one - mean)).sum::<f64>() / (count - 1.0);
    let expected = freedoms.iter().map(|freedom| 2.0 / freedom).sum::<f64>() / count;
    let common = libm::exp(mean);
    // Degrees of freedom of the common variance; those of all windows together if their variances do not differ.
    let worth = if scatter > expected { 2.0 / (scatter - expected) } else { f64::INFINITY };
    let worth = worth.min(freedoms.iter().sum::<f64>() / 3.0);
    if !(common.is_finite() && worth.is_finite()) {
        return own;
    }
    own.iter().zip(&freedoms).map(|(own, freedom)| (freedom * own + worth * common) / (freedom + worth)).collect()
}

/// Windows about the turning points of a record of `times` (s) and as many `values`, from a damped sinusoid close to it.
pub(super) fn windows<'a>(times: &'a [f64], values: &'a [f64], estimate: &Estimate) -> Option<Windows<'a>> {
    let (first, last) = (*times.first()?, *times.last()?);
    let mut windows: Vec<Window> = Vec::new();
    let mut before: Option<Cycle> = None;
    let mut lost = None;
    let mut local = (estimate.angular_frequency, estimate.damping);
    let mut time = turning_point(estimate, first + PI / local.0);
    let mut scratch = Vec::new();
    // Number of consecutive unclear turning points, and the time of the first of them in `lost`.
    let mut failures = 0;
    while time + 0.98 * PI / local.0 <= last && failures < FAILURES {
        // A turning point not later than the last one is the same one; skipping it makes every round advance.
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
    // A gap or the end of the record is not noise.
    Some(Windows { windows, lost: lost.filter(|_| failures >= FAILURES) })
}

/// First turning point of an estimate from `time` on.
fn turning_point(estimate: &Estimate, time: f64) -> f64 {
    let phase = estimate.angular_frequency * (time - estimate.origin)
        + estimate.phase
        + lead(estimate.damping, estimate.angular_frequency);
    time + ((phase / PI).ceil() - phase / PI) * PI / estimate.angular_frequency
}

/// Phase by which a damped oscillation has its turning point before that of its cosine, rad.
fn lead(damping: f64, angular_frequency: f64) -> f64 {
    libm::atan2(damping, angular_frequency)
}

/// Window about the turning point near `time`.
fn at<'a>(
    times: &'a [f64],
    values: &'a [f64],
    time: f64,
    (w, g): (f64, f64),
    scratch: &mut Vec<(f64, f64)>,
) -> Option<Window<'a>> {
    let mut centre = time;
    let mut found = None;
    // First about the expected turning point, then about the fitted one.
    for _ in 0..2 {
        let (fit, points) = fit(times, values, centre, (w, g), scratch)?;
        // Time from the centre to the nearest turning point.
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
    /// Residuals; with `drifts`, a parabolic drift of the level is subtracted.
    fn residuals(&self, drifts: bool, scratch: &mut Vec<(f64, f64)>) -> Block {
        basis(self.points, self.fit.origin, self.fit.w, self.fit.g, scratch);
        self.fit.residuals(self.points, scratch, drifts)
    }

    /// Cycle for noise of this variance with the correlation `rho` of neighbouring rows; `None` if it is too uncertain.
    fn cycle(&self, variance: f64, rho: f64, scratch: &mut Vec<(f64, f64)>) -> Option<Cycle> {
        basis(self.points, self.fit.origin, self.fit.w, self.fit.g, scratch);
        cycle(&self.fit, &self.fit.covariance(self.points, scratch, variance, rho)?, self.expected)
    }
}

/// Damped sinusoid fitted in the window about `centre`.
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
    // Fewer rows do not determine their own scatter.
    if points.times.len() < 8 {
        return None;
    }
    Some((Damped::of(points, centre, w, g, scratch)?.improved(points, 30, scratch), points))
}

/// Cycle from a fit, `None` if it is too uncertain; `expected` is the angular frequency of its neighbours.
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
    // The turning point is at the origin of the fit, except for the rest of the last step.
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
