//! Readout time of a rolling shutter from an oscillation.
//!
//! A camera that reads its rows one after another shows a row at `part` of the picture's height below the middle later
//! by `readout * part`. The position then contains `readout * part * velocity`. For an oscillation this is a second
//! harmonic with the phase of position times velocity. A restoring force that is not proportional to the displacement
//! has a second harmonic with the phase of the squared position, which is fitted as well. Amplitude and phase may vary
//! slowly, as polynomials of time.

use crate::tracking::linear::solve;
use crate::tracking::motion::motion;
use crate::tracking::track::Readout;

/// Maximum degree of the polynomials.
const DEGREE: usize = 5;
/// Minimum degree: phase and amplitude of few periods vary, too.
const LEAST: usize = 2;
/// Number of terms: a constant, the polynomials times cosine and sine, the squared position, and the readout time last.
const TERMS: usize = 2 * (DEGREE + 1) + 3;
/// Maximum number of frames; enough for an error below 1 ms.
const FRAMES: usize = 600;
/// Minimum number of periods in the film.
const PERIODS: f64 = 3.0;
/// Minimum number of periods for the deviation from an oscillation.
const SOME: f64 = 2.0;
/// Minimum ratio of the estimate to its standard error.
const CLEAR: f64 = 4.0;
/// Number of Gauss-Newton steps.
const STEPS: usize = 6;

/// Least-squares estimate of the readout time; `None` if the motion is not an oscillation of several periods, or the
/// estimate is not significant. `times` in s; `parts`: readout position of each value relative to the middle of the
/// picture, in picture heights.
pub(crate) fn estimate(times: &[f64], values: &[f64], parts: &[f64]) -> Option<Readout> {
    let count = times.len().min(FRAMES);
    let (times, values, parts) = (times.get(..count)?, values.get(..count)?, parts.get(..count)?);
    if count < 3 * TERMS {
        return None;
    }
    let span = times[count - 1] - times[0];
    let cycles = cycles(times, values)?;
    if cycles < PERIODS {
        return None;
    }
    let mut seconds = 0.0;
    let mut sigma = f64::INFINITY;
    for _ in 0..STEPS {
        let instants: Vec<f64> = times.iter().zip(parts).map(|(time, part)| time + seconds * part).collect();
        let (step, error, _) = step(&instants, values, parts, times[0], span, cycles)?;
        seconds += step;
        sigma = error;
        // The readout cannot take longer than the frame interval, with a margin.
        if seconds.abs() > 1.5 * span / (count - 1) as f64 {
            return None;
        }
    }
    (seconds.abs() > CLEAR * sigma).then_some(Readout { seconds, sigma })
}

/// Root mean square deviation of the positions from an oscillation of slowly varying amplitude and phase, in the unit
/// of `values`. `None` if the motion is not an oscillation of at least two periods.
pub(crate) fn residual(times: &[f64], values: &[f64], parts: &[f64]) -> Option<f64> {
    let count = times.len().min(FRAMES);
    let (times, values, parts) = (times.get(..count)?, values.get(..count)?, parts.get(..count)?);
    if count < 3 * TERMS {
        return None;
    }
    let cycles = cycles(times, values).filter(|cycles| *cycles >= SOME)?;
    Some(step(times, values, parts, times[0], times[count - 1] - times[0], cycles)?.2)
}

/// Number of periods: that of the sinusoid with the largest power.
fn cycles(times: &[f64], values: &[f64]) -> Option<f64> {
    let span = times[times.len() - 1] - times[0];
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let power = |cycles: f64| {
        let (mut cosine, mut sine) = (0.0, 0.0);
        for (time, value) in times.iter().zip(values) {
            let (s, c) = libm::sincos(std::f64::consts::TAU * cycles * (time - times[0]) / span);
            cosine += c * (value - mean);
            sine += s * (value - mean);
        }
        cosine * cosine + sine * sine
    };
    // Half steps resolve a peak. The upper bound is six frames per period, the minimum for a velocity.
    let candidates = (2..=times.len() / 3).map(|half| half as f64 / 2.0);
    candidates.map(|cycles| (cycles, power(cycles))).max_by(|a, b| a.1.total_cmp(&b.1)).map(|best| best.0)
}

/// Step of the readout time (s), its standard error (s), and the root mean square of the residuals (px).
fn step(
    instants: &[f64],
    values: &[f64],
    parts: &[f64],
    start: f64,
    span: f64,
    cycles: f64,
) -> Option<(f64, f64, f64)> {
    let degree = DEGREE.min((cycles as usize - 1).max(LEAST));
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let size = values.iter().map(|value| (value - mean).abs()).fold(f64::MIN_POSITIVE, f64::max);
    let mut matrix = [[0.0; TERMS]; TERMS];
    let mut side = [0.0; TERMS];
    let mut squares = 0.0;
    for (at, (instant, value)) in instants.iter().zip(values).enumerate() {
        let slow = 2.0 * (instant - start) / span - 1.0;
        let (sine, cosine) = libm::sincos(std::f64::consts::PI * cycles * (slow + 1.0));
        let mut terms = [0.0; TERMS];
        // Recurrence of the Legendre polynomials.
        let (mut before, mut now) = (0.0, 1.0);
        for k in 0..=degree {
            terms[2 * k] = now * cosine;
            terms[2 * k + 1] = now * sine;
            let k = k as f64;
            (before, now) = (now, ((2.0 * k + 1.0) * slow * now - k * before) / (k + 1.0));
        }
        let value = (value - mean) / size;
        terms[TERMS - 3] = 1.0;
        terms[TERMS - 2] = value * value;
        terms[TERMS - 1] = motion(instants, values, at).0 / size * parts[at];
        for row in 0..TERMS {
            for column in 0..TERMS {
                matrix[row][column] += terms[row] * terms[column];
            }
            side[row] += terms[row] * value;
        }
        squares += value * value;
    }
    // Unused degrees of the polynomials.
    for (k, row) in matrix.iter_mut().enumerate().take(TERMS - 3).skip(2 * (degree + 1)) {
        row[k] = 1.0;
    }
    let (solution, inverse) = solve(matrix, side)?;
    let explained: f64 = solution.iter().zip(side).map(|(a, b)| a * b).sum();
    let variance = (squares - explained).max(0.0) / (instants.len() - TERMS) as f64;
    Some((solution[TERMS - 1], (variance * inverse[TERMS - 1][TERMS - 1]).sqrt(), size * variance.sqrt()))
}
