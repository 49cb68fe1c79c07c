//! The size of a pixel from all marks of a ruler.

use crate::calibration::refusal::Refusal;
use crate::calibration::scale::{Scale, distance};
use crate::plane::Plane;

/// Samples a pixel along the ruler.
const DENSITY: f64 = 2.0;
/// Pixels to both sides of the line that are averaged.
const ASIDE: i32 = 2;
/// The amplitude of the marks over the scatter of the profile that remains, at least.
const CLEAR: f64 = 0.5;
/// Samples along the line at most.
const SAMPLES: f64 = 20_000.0;

/// The size of a pixel from the spacing of a ruler's marks along the line between two of them, with `intervals` of `length`
/// metres between the two.
///
/// The frequency of a sinusoid that fits the profile best, near the one that the two clicks give; its error is the bound of
/// D. C. Rife and R. R. Boorstyn, *IEEE Trans. Inf. Theory* 20 (1974) 591, with everything that the sinusoid leaves taken for noise.
///
/// # Errors
///
/// Where the marks lie too close together, or the ruler shows no regular marks.
pub fn by_marks(plane: &Plane, ends: [[f64; 2]; 2], intervals: u32, length: f64) -> Result<Scale, Refusal> {
    let distance = distance(ends)?;
    if !(length > 0.0 && length.is_finite()) {
        return Err(Refusal::Length);
    }
    let count = (distance * DENSITY).min(SAMPLES).floor();
    // A mark needs some pixels, and a frequency some marks.
    if intervals < 3 || f64::from(intervals) * 3.0 > distance {
        return Err(Refusal::Marks);
    }
    let profile = profile(plane, ends, count);
    let coarse = f64::from(intervals);
    // Between half an interval more and less: golden section, since the power has one peak there.
    let (mut low, mut high) = (coarse - 0.5, coarse + 0.5);
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    for _ in 0..40 {
        let (p, q) = (high - golden * (high - low), low + golden * (high - low));
        if power(&profile, p).0 > power(&profile, q).0 { high = q } else { low = p }
    }
    let cycles = (low + high) / 2.0;
    let (power, total) = power(&profile, cycles);
    // A sinusoid of amplitude A has the power A²/4 times the square of the weights.
    let amplitude = 2.0 * power.sqrt();
    let noise = (total - amplitude * amplitude / 2.0).max(0.0).sqrt();
    if (cycles - coarse).abs() > 0.45 || amplitude.is_nan() || amplitude < CLEAR * noise {
        return Err(Refusal::Marks);
    }
    // The window leaves half of the samples; neighbouring samples of one pixel are no independent ones.
    let independent = count / DENSITY / 2.0;
    let sigma = (24.0 / independent).sqrt() * noise / amplitude / std::f64::consts::TAU;
    Ok(Scale { pixel: length * cycles / distance, relative_sigma: sigma / cycles })
}

/// The grey values along a line with the weights of a window (J. von Hann), about their weighted mean.
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

/// The power at so many cycles over the profile, and the variance of the profile.
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
