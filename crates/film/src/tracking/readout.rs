//! The readout time of a rolling shutter from an oscillation.
//!
//! A camera that reads its rows one after another shows a row at `part` of the picture's height after the middle one later by
//! `readout * part`. The position then contains `readout * part * velocity`: for an oscillation a second harmonic in the phase of
//! position times velocity. A restoring force that is not proportional to the displacement has its second harmonic in the phase of the square
//! of the position and is fitted beside it. Amplitude and phase may change slowly, as polynomials of time.

use crate::tracking::linear::solve;
use crate::tracking::motion::motion;
use crate::tracking::track::Readout;

/// The highest degree of the polynomials.
const DEGREE: usize = 5;
/// A constant, the polynomials times cosine and sine, the square of the position, and the readout time last.
const TERMS: usize = 2 * (DEGREE + 1) + 3;
/// Frames that are used: enough for an error below a millisecond.
const FRAMES: usize = 600;
/// Periods that the film must show.
const PERIODS: f64 = 3.0;
/// The estimate counts if it is so many standard errors from zero.
const CLEAR: f64 = 4.0;
/// Steps of Gauss and Newton.
const STEPS: usize = 6;

/// The readout time by least squares; `None` where the motion is no oscillation of some periods, or shows none.
///
/// `parts` says at which part of the picture's height each position was read, from the middle.
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
        // No camera reads for longer than a frame lasts.
        if seconds.abs() > 1.5 * span / (count - 1) as f64 {
            return None;
        }
    }
    (seconds.abs() > CLEAR * sigma).then_some(Readout { seconds, sigma })
}

/// The root mean square by which an oscillation of slowly changing amplitude and phase misses the positions; `None` where the motion is no
/// oscillation of some periods.
pub(crate) fn residual(times: &[f64], values: &[f64], parts: &[f64]) -> Option<f64> {
    let count = times.len().min(FRAMES);
    let (times, values, parts) = (times.get(..count)?, values.get(..count)?, parts.get(..count)?);
    if count < 3 * TERMS {
        return None;
    }
    let cycles = cycles(times, values).filter(|cycles| *cycles >= PERIODS)?;
    Some(step(times, values, parts, times[0], times[count - 1] - times[0], cycles)?.2)
}

/// How many periods the film shows: those of the sinusoid that agrees best.
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
    // Half steps resolve a peak; six frames a period are the fewest that a velocity needs.
    let candidates = (2..=times.len() / 3).map(|half| half as f64 / 2.0);
    candidates.map(|cycles| (cycles, power(cycles))).max_by(|a, b| a.1.total_cmp(&b.1)).map(|best| best.0)
}

/// The step of the readout time, its standard error, and the root mean square of the residuals in pixels.
fn step(
    instants: &[f64],
    values: &[f64],
    parts: &[f64],
    start: f64,
    span: f64,
    cycles: f64,
) -> Option<(f64, f64, f64)> {
    let degree = DEGREE.min(cycles as usize - 1);
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let size = values.iter().map(|value| (value - mean).abs()).fold(f64::MIN_POSITIVE, f64::max);
    let mut matrix = [[0.0; TERMS]; TERMS];
    let mut side = [0.0; TERMS];
    let mut squares = 0.0;
    for (at, (instant, value)) in instants.iter().zip(values).enumerate() {
        let slow = 2.0 * (instant - start) / span - 1.0;
        let (sine, cosine) = libm::sincos(std::f64::consts::PI * cycles * (slow + 1.0));
        let mut terms = [0.0; TERMS];
        // Legendre polynomials, by their recurrence.
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
    // Polynomials of a degree that is not used.
    for (k, row) in matrix.iter_mut().enumerate().take(TERMS - 3).skip(2 * (degree + 1)) {
        row[k] = 1.0;
    }
    let (solution, inverse) = solve(matrix, side)?;
    let explained: f64 = solution.iter().zip(side).map(|(a, b)| a * b).sum();
    let variance = (squares - explained).max(0.0) / (instants.len() - TERMS) as f64;
    Some((solution[TERMS - 1], (variance * inverse[TERMS - 1][TERMS - 1]).sqrt(), size * variance.sqrt()))
}
