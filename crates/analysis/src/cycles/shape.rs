//! Cycles of an oscillation of any shape, from its crossings of the middle level and its turning points. A sinusoid would
//! give wrong values if the shape is not sinusoidal. For a pendulum at large amplitude or a relaxation oscillation, the
//! period is the time between crossings in the same direction.

use super::cycle::{Cycle, Measured};
use super::damped::Points;
use super::estimate::centre;
use super::lobes::{Lobe, Swings, correlated_scatter, scatter, swings};
use crate::fit::autoregression::{Block, common_correlation, correlated, orthonormal, subtract_projection};
use crate::fit::linear::{dot, norm};
use crate::smoothing;
use core::f64::consts::TAU;
use units::order::median;

/// Half-widths, in periods, of the ranges about a crossing and a turning point to which a polynomial is fitted.
const CROSSING: f64 = 0.08;
const TURNING: f64 = 0.08;
/// Greatest number of rows per polynomial; more are thinned.
const ROWS: usize = 40;
/// Greatest correlation taken from the residuals of sinusoids, which may be due to another shape.
const MOST: f64 = 0.9;
/// Least number of residuals beyond the fitted numbers from which their correlation is estimated.
const FREE: usize = 100;
/// Rows farther from the middle level than this part of the height of a lobe are not used for a crossing.
const STEEP: f64 = 0.7;

/// Cycles around the turning points with two crossings on either side. The period is the mean of two times between
/// crossings in the same direction, one downwards and one upwards. The decrement follows from the heights before and after
/// the turning point, half a period apart. The amplitude is half the height between the turning point and the mean of its
/// neighbours, of which the later one has more weight because it has decayed more. `rho` is the correlation of the noise of
/// neighbouring rows.
pub(super) fn cycles(times: &[f64], values: &[f64], rho: f64) -> Vec<Cycle> {
    let points = Points { times, values };
    let rho = rho.min(MOST);
    let mut noise = Noise { white: scatter(values), rho, correlated: correlated_scatter(values, rho) };
    let Some(found) = about_middle(points, noise) else { return Vec::new() };
    let periods = found.crossings.windows(3).map(|three| three[2] - three[0]).collect();
    let period = median(periods);
    if !(period > 0.0 && period.is_finite()) {
        return Vec::new();
    }
    noise = noise_at_crossings(points, &found, period, noise.white).filter(|own| own.rho <= rho).unwrap_or(noise);
    let crossings: Vec<Measured> =
        (0..found.crossings.len()).map(|place| crossing(points, &found, place, period, noise)).collect();
    let turns: Vec<(Measured, Measured)> =
        found.swings.lobes.iter().map(|lobe| turning_point(points, lobe, found.middle, period, noise)).collect();
    let mut cycles = Vec::new();
    for place in 2..crossings.len().saturating_sub(1) {
        let cycle = cycle(&crossings[place - 2..place + 2], &turns[place - 1..place + 2]);
        let near = cycle.as_ref().is_some_and(|cycle| (0.7..1.4).contains(&(cycle.period.value / period)));
        // Lobes a period apart have others between them that noise has hidden.
        let whole =
            found.swings.lobes[place - 2..=place + 2].windows(2).all(|pair| pair[1].time - pair[0].time < period);
        cycles.extend(cycle.filter(|_| near && whole));
    }
    cycles
}

/// Noise of the values.
#[derive(Clone, Copy, Debug)]
struct Noise {
    /// Standard deviation of the noise that differs from row to row, used if a few rows do not determine it by their
    /// residuals.
    white: f64,
    /// Correlation of neighbouring rows of the longer-lasting noise.
    rho: f64,
    /// Standard deviation of the longer-lasting noise.
    correlated: f64,
}

impl Noise {
    /// Upper bound of the noise in a record of `rows` rows. The expected maximum of n normal values grows like sqrt(2 ln
    /// n), and scatters by less than one standard deviation.
    fn greatest(self, rows: usize) -> f64 {
        self.white.max(self.correlated) * (1.0 + (2.0 * libm::log(rows.max(1) as f64)).sqrt())
    }
}

/// Noise about polynomials of degree five through the crossings; `None` if there are too few rows.
fn noise_at_crossings(points: Points, found: &Found, period: f64, white: f64) -> Option<Noise> {
    let blocks: Vec<Block> = (0..found.crossings.len())
        .map(|place| {
            let rows = steep(points, found, place, period);
            // Consecutive rows, not thinned.
            let from = rows.times.len().saturating_sub(ROWS) / 2;
            let (times, values) = (rows.times.iter().skip(from).take(ROWS), rows.values.iter().skip(from).take(ROWS));
            let times: Vec<f64> = times.map(|time| (time - found.crossings[place]) / period).collect();
            let power = |degree| times.iter().map(|time| libm::pow(*time, f64::from(degree))).collect();
            let basis = orthonormal((0..6).map(power).collect());
            let mut residuals: Vec<f64> = values.map(|value| value - found.middle).collect();
            subtract_projection(&basis, &mut residuals);
            Block::new(basis, residuals)
        })
        .collect();
    let free: usize = blocks.iter().map(Block::freedom).sum();
    if free < FREE {
        return None;
    }
    let rho = common_correlation(blocks.iter()).max(0.0);
    let variance = median(blocks.iter().map(|block| block.variance(rho)).collect());
    Some(Noise { white, rho, correlated: variance.sqrt() })
}

/// Rows of the steep part about a crossing.
fn steep<'a>(points: Points<'a>, found: &Found, place: usize, period: f64) -> Points<'a> {
    let height = found.swings.lobes[place].height.abs().min(found.swings.lobes[place + 1].height.abs());
    let is_steep = |value: f64| (value - found.middle).abs() <= STEEP * height;
    near(points, found.crossings[place], CROSSING * period, 4, is_steep)
}

/// Crossings and lobes of a record about its middle level.
struct Found {
    middle: f64,
    crossings: Vec<f64>,
    swings: Swings,
}

fn about_middle(points: Points, noise: Noise) -> Option<Found> {
    let (low, high) = (points.values.iter())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)));
    let size = high / 2.0 - low / 2.0;
    if !(size > 0.0 && size.is_finite()) {
        return None;
    }
    // Hysteresis of a crossing: above the noise and a hundredth of the range.
    let threshold = noise.greatest(points.values.len()).max(0.02 * size);
    let mut middle = points.values.iter().sum::<f64>() / points.values.len() as f64;
    let mut found = swings(points, middle, threshold);
    for _ in 0..2 {
        let Some(off) = centre(&found) else { break };
        middle += off;
        found = swings(points, middle, threshold);
    }
    Some(Found { middle, crossings: found.crossings.clone(), swings: found })
}

/// Rows within `reach` of a time for which `wanted` is true, at least about `least`.
fn near<'a>(points: Points<'a>, time: f64, reach: f64, least: usize, wanted: impl Fn(f64) -> bool) -> Points<'a> {
    let count = points.times.len();
    let place = points.times.partition_point(|row| *row < time);
    let half = least / 2;
    let (mut from, mut until) = (place.saturating_sub(half), (place + half).min(count));
    while from > 0 && points.times[from - 1] >= time - reach && wanted(points.values[from - 1]) {
        from -= 1;
    }
    while until < count && points.times[until] <= time + reach && wanted(points.values[until]) {
        until += 1;
    }
    Points { times: &points.times[from..until], values: &points.values[from..until] }
}

/// Polynomial fitted to some rows.
struct Local {
    times: Vec<f64>,
    values: Vec<f64>,
    degree: usize,
    /// Noise about the polynomial; its correlation is that of the thinned rows.
    noise: Noise,
}

impl Local {
    fn new(points: Points, degree: usize, noise: Noise) -> Option<Self> {
        let stride = points.times.len().div_ceil(ROWS).max(1);
        let times: Vec<f64> = points.times.iter().copied().step_by(stride).collect();
        let values: Vec<f64> = points.values.iter().copied().step_by(stride).collect();
        let degree = degree.min(times.len().checked_sub(1)?);
        let noise = Noise { rho: libm::pow(noise.rho, stride as f64), ..noise };
        let mut local = Self { times, values, degree, noise };
        let freedom = local.times.len() - degree - 1;
        if freedom >= 3 {
            let off = |(time, value): (&f64, &f64)| Some(value - local.at(*time, 0)?.value);
            let squares: Option<f64> =
                local.times.iter().zip(&local.values).map(off).map(|off| Some(off? * off?)).sum();
            local.noise.white = (squares? / freedom as f64).sqrt();
        }
        Some(local)
    }

    /// Value of the polynomial, or of a derivative, at a time. Its error is the greater one of those from its residuals and
    /// from the correlated noise.
    fn at(&self, time: f64, derivative: usize) -> Option<Measured> {
        let weights = smoothing::weights(&self.times, time, self.degree, derivative)?;
        let white = self.noise.white * norm(&weights);
        let correlated = self.noise.correlated * dot(&weights, &correlated(&weights, self.noise.rho)).max(0.0).sqrt();
        Some(Measured { value: dot(&weights, &self.values), error: white.max(correlated) })
    }

    /// Time near `time` at which the polynomial, or its derivative, has the value `level`, by Newton's method.
    fn root(&self, time: f64, derivative: usize, level: f64) -> Option<Measured> {
        let (first, last) = (*self.times.first()?, *self.times.last()?);
        let mut at = time;
        for _ in 0..20 {
            let off = self.at(at, derivative)?.value - level;
            let step = off / self.at(at, derivative + 1)?.value;
            if !step.is_finite() {
                return None;
            }
            at = (at - step).clamp(first, last);
            if step.abs() <= 1e-12 * (last - first) {
                break;
            }
        }
        let slope = self.at(at, derivative + 1)?.value;
        let error = self.at(at, derivative)?.error / slope.abs();
        (error.is_finite() && at > first && at < last).then_some(Measured { value: at, error })
    }
}

/// Crossing of the middle level: from a cubic through the rows of the steep part.
fn crossing(points: Points, found: &Found, place: usize, period: f64, noise: Noise) -> Measured {
    let (rough, middle) = (found.crossings[place], found.middle);
    let rows = steep(points, found, place, period);
    let root = |degree: usize, rows: Points| Local::new(rows, degree, noise)?.root(rough, 0, middle);
    let Some(cubic) = root(3, rows) else {
        let step = rows.times.last().zip(rows.times.first()).map_or(0.0, |(last, first)| last - first);
        return Measured { value: rough, error: step / 4.0 };
    };
    // Too few rows for residuals: the difference from a straight line measures the error of the cubic.
    let coarse = if rows.times.len() < 7 {
        root(1, near(points, rough, 0.0, 2, |_| false)).map_or(0.0, |line| (line.value - cubic.value) / 4.0)
    } else {
        0.0
    };
    Measured { value: cubic.value, error: libm::hypot(cubic.error, coarse) }
}

/// Time and value of the turning point of a lobe, from a polynomial of degree four through the nearby rows.
fn turning_point(points: Points, lobe: &Lobe, middle: f64, period: f64, noise: Noise) -> (Measured, Measured) {
    let rows = near(points, lobe.time, TURNING * period, 6, |_| true);
    let found = Local::new(rows, 4, noise).and_then(|local| {
        let time = local.root(lobe.time, 1, 0.0)?;
        Some((time, local.at(time.value, 0)?))
    });
    let step = rows.times.last().zip(rows.times.first()).map_or(0.0, |(last, first)| last - first);
    found.unwrap_or((
        Measured { value: lobe.time, error: step / 4.0 },
        Measured { value: middle + lobe.height, error: noise.white.max(noise.correlated).max(f64::MIN_POSITIVE) },
    ))
}

/// Cycle around the middle one of three turning points, with the two crossings on either side of it.
fn cycle(crossings: &[Measured], turns: &[(Measured, Measured)]) -> Option<Cycle> {
    let (&[a, b, c, d], &[(_, before), (time, own), (_, after)]) = (crossings, turns) else { return None };
    let squares = |of: &[Measured]| of.iter().map(|one| one.error * one.error).sum::<f64>();
    let period =
        Measured { value: ((c.value - a.value) + (d.value - b.value)) / 2.0, error: squares(crossings).sqrt() / 2.0 };
    // Heights half a period apart; the level cancels in them.
    let (early, late) = ((before.value - own.value).abs(), (own.value - after.value).abs());
    let ratio = early / late;
    // Weighted mean of the neighbours: in a geometric decay it is as far from the level as the turning point itself.
    let others = (before.value + ratio * after.value) / (1.0 + ratio);
    let beside = libm::hypot(before.error, ratio * after.error) / (1.0 + ratio);
    let amplitude = Measured { value: (own.value - others).abs() / 2.0, error: libm::hypot(own.error, beside) / 2.0 };
    let offset = Measured { value: (own.value + others) / 2.0, error: amplitude.error };
    let error = libm::hypot(before.error / early, after.error / late);
    let decrement = Measured {
        value: 2.0 * libm::log(ratio),
        error: 2.0 * libm::hypot(error, own.error * (1.0 / early - 1.0 / late)),
    };
    let angular_frequency =
        Measured { value: TAU / period.value, error: TAU * period.error / (period.value * period.value) };
    let damping = Measured {
        value: decrement.value / period.value,
        error: libm::hypot(decrement.error, decrement.value * period.error / period.value) / period.value,
    };
    let known =
        [period, amplitude, decrement, damping].iter().all(|one| one.value.is_finite() && one.error.is_finite());
    known.then_some(Cycle {
        time,
        maximum: own.value > others,
        amplitude,
        period,
        decrement,
        angular_frequency,
        damping,
        offset,
    })
}
