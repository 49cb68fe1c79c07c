//! Size of a pixel from all marks of a ruler.

use crate::calibration::refusal::Refusal;
use crate::calibration::scale::{Scale, distance};
use crate::plane::Plane;

/// Samples per px along the ruler.
const DENSITY: f64 = 2.0;
/// Pixels on each side of the line that are averaged.
const ASIDE: i32 = 2;
/// Minimum amplitude of the marks relative to the residual scatter of the profile.
const CLEAR: f64 = 0.5;
/// Maximum number of samples along the line.
const SAMPLES: f64 = 20_000.0;

/// Size of a pixel from the spacing of the marks between two clicks. `ends`: the clicks, px; `intervals`: number of
/// intervals between them; `length`: length of one interval, m.
///
/// Fits the frequency of a sinusoid to the profile, near that of the two clicks. Its error is the bound of Rife and
/// Boorstyn, *IEEE Trans. Inf. Theory* 20 (1974) 591, with the residual taken as noise.
///
/// # Errors
///
/// [`Refusal::Close`] or [`Refusal::Length`] for invalid input, [`Refusal::Marks`] if no regular marks are visible.
pub fn by_marks(plane: &Plane, ends: [[f64; 2]; 2], intervals: u32, length: f64) -> Result<Scale, Refusal> {
    let distance = distance(ends)?;
    if !(length > 0.0 && length.is_finite()) {
        return Err(Refusal::Length);
    }
    let count = (distance * DENSITY).min(SAMPLES).floor();
    // A mark needs at least three pixels, a frequency three intervals.
    if intervals < 3 || f64::from(intervals) * 3.0 > distance {
        return Err(Refusal::Marks);
    }
    let profile = profile(plane, ends, count);
    let coarse = f64::from(intervals);
    // Within half an interval of the clicks the power has one maximum: golden-section search.
    let (mut low, mut high) = (coarse - 0.5, coarse + 0.5);
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    for _ in 0..40 {
        let (p, q) = (high - golden * (high - low), low + golden * (high - low));
        if power(&profile, p).0 > power(&profile, q).0 { high = q } else { low = p }
    }
    let cycles = (low + high) / 2.0;
    let (power, total) = power(&profile, cycles);
    // A sinusoid of amplitude A has the power A²/4 with normalized weights.
    let amplitude = 2.0 * power.sqrt();
    let noise = (total - amplitude * amplitude / 2.0).max(0.0).sqrt();
    if (cycles - coarse).abs() > 0.45 || amplitude.is_nan() || amplitude < CLEAR * noise {
        return Err(Refusal::Marks);
    }
    // The window halves the effective number of samples, and samples within a pixel are not independent.
    let independent = count / DENSITY / 2.0;
    let sigma = (24.0 / independent).sqrt() * noise / amplitude / std::f64::consts::TAU;
    Ok(Scale { pixel: length * cycles / distance, relative_sigma: sigma / cycles })
}

/// Grey values along a line of px coordinates, minus their weighted mean, with normalized weights of a Hann window.
fn profile(plane: &Plane, [from, to]: [[f64; 2]; 2], count: f64) -> Vec<(f64, f64)> {
    let along = [to[0] - from[0], to[1] - from[1]];
    let length = libm::hypot(along[0], along[1]);
    let normal = [along[1] / length, -along[0] / length];
    let mut profile: Vec<(f64, f64)> = (0..count as usize)
        .map(|k| {
            let part = (k as f64 + 0.5) / count;
            let value = |aside: i32| {
                let aside = f64::from(aside);
                plane.linear(
                    from[0] + part * along[0] + aside * normal[0],
                    from[1] + part * along[1] + aside * normal[1],
                )
            };
            let sine = libm::sin(std::f64::consts::PI * part);
            ((-ASIDE..=ASIDE).map(value).sum::<f64>() / f64::from(2 * ASIDE + 1), sine * sine)
        })
        .collect();
    let weights: f64 = profile.iter().map(|one| one.1).sum();
    let mean = profile.iter().map(|one| one.0 * one.1).sum::<f64>() / weights;
    profile.iter_mut().for_each(|one| *one = (one.0 - mean, one.1 / weights));
    profile
}

/// Power at `cycles` periods over the profile, and the variance of the profile.
fn power(profile: &[(f64, f64)], cycles: f64) -> (f64, f64) {
    let (mut cosine, mut sine, mut total) = (0.0, 0.0, 0.0);
    for (k, (value, weight)) in profile.iter().enumerate() {
        let (s, c) = libm::sincos(std::f64::consts::TAU * cycles * (k as f64 + 0.5) / profile.len() as f64);
        cosine += weight * value * c;
        sine += weight * value * s;
        total += weight * value * value;
    }
    (cosine * cosine + sine * sine, total)
}
