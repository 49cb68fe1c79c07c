//! Standard errors from the scatter of the track.
//!
//! Formal errors assume independent noise of neighbouring pixels, which compression violates. A smooth motion vanishes
//! in sixth differences and noise does not, so that they give the actual errors.

use crate::tracking::median::median;
use units::order::sort_numbers;

/// Number of values in a sixth difference.
const JOINED: usize = 7;
/// Deviation of a sinusoid with a period of eight values or more from the cubic through its neighbours, relative to the
/// range of nine values.
const RANGE: f64 = 0.06;
/// Minimum standard error, px. Interpolation errors vary smoothly with the motion and vanish in differences, too.
const LEAST: f64 = 0.005;

/// Weights of the divided difference of `COUNT` values with norm 1: independent errors of variance 1 give it variance 1.
/// `None` if times coincide.
pub(crate) fn weights<const COUNT: usize>(times: &[f64; COUNT]) -> Option<[f64; COUNT]> {
    let mut weights = [0.0; COUNT];
    for (k, weight) in weights.iter_mut().enumerate() {
        let others = times.iter().enumerate().filter(|(j, _)| *j != k);
        *weight = 1.0 / others.map(|(_, other)| times[k] - other).product::<f64>();
    }
    let norm = weights.iter().map(|weight| weight * weight).sum::<f64>().sqrt();
    weights.iter_mut().for_each(|weight| *weight /= norm);
    norm.is_finite().then_some(weights)
}

/// Sixth differences of a coordinate, in units of the error of one value, by the first of their seven values.
fn differences(times: &[f64], values: &[f64]) -> Vec<Option<f64>> {
    let windows = times.windows(JOINED).zip(values.windows(JOINED));
    windows
        .map(|(times, values)| {
            Some(weights::<JOINED>(times.first_chunk()?)?.iter().zip(values).map(|(a, b)| a * b).sum())
        })
        .collect()
}

/// Standard error of a coordinate: root mean square of the sixth differences, without those beyond three standard
/// errors by their median. `None` for fewer than seven values.
fn own(times: &[f64], values: &[f64]) -> Option<f64> {
    let mut squares: Vec<f64> = differences(times, values).into_iter().flatten().map(|value| value * value).collect();
    sort_numbers(&mut squares);
    // 0.4549: median of chi squared with one degree of freedom.
    let limit = 9.0 * squares.get(squares.len() / 2)? / 0.4549;
    let usual = &squares[..squares.partition_point(|square| *square <= limit)];
    // 0.9733: variance of a normal distribution truncated at three standard deviations.
    Some((usual.iter().sum::<f64>() / usual.len().max(1) as f64 / 0.9733).sqrt())
}

/// Standard errors of a coordinate: formal errors, multiplied by the ratio of the scatter of the track to their median
/// if it exceeds 1. `times` in s, `values` and `formal` in px.
pub(crate) fn scaled(times: &[f64], values: &[f64], formal: &[f64]) -> Vec<f64> {
    // The median, since a frame without a surface would dominate the mean.
    let usual = median(formal.iter().copied().filter(|error| error.is_finite()).collect());
    let factor = match own(times, values) {
        Some(own) if usual > 0.0 => (own / usual).max(1.0),
        _ => 1.0,
    };
    formal.iter().map(|error| (error * factor).max(LEAST)).collect()
}

/// True for each value further than `limit` standard errors from the prediction of its neighbours.
pub(crate) fn outliers(times: &[f64], values: &[f64], sigmas: &[f64], limit: f64) -> Vec<bool> {
    let windows = times.windows(JOINED).zip(values.windows(JOINED)).zip(sigmas.windows(JOINED));
    let large: Vec<bool> = windows
        .map(|((times, values), sigmas)| {
            let Some(weights) = times.first_chunk::<JOINED>().and_then(weights) else { return false };
            let difference: f64 = weights.iter().zip(values).map(|(a, b)| a * b).sum();
            let variance: f64 = weights.iter().zip(sigmas).map(|(a, b)| a * a * b * b).sum();
            difference.abs() > limit * variance.sqrt()
        })
        .collect();
    // The middle of seven values has the largest weight in their difference. A value near an end is never in the
    // middle. It is an outlier if the difference with it is large and the first one without it is not.
    let (half, last) = (JOINED / 2, large.len().saturating_sub(1));
    let is_large = |window: Option<usize>| window.and_then(|window| large.get(window)).copied().unwrap_or(false);
    (0..values.len())
        .map(|at| {
            if at < half {
                is_large(Some(0)) && !is_large(Some(at + 1))
            } else if at > last + half {
                is_large(Some(last)) && !is_large(at.checked_sub(JOINED))
            } else {
                is_large(Some(at - half))
            }
        })
        .collect()
}

/// True for values that deviate by more than `least` and a fraction of the range around them from a smooth curve
/// through two neighbours on each side, and for values between two such values close together.
pub(crate) fn jumps(values: &[f64], least: f64) -> Vec<bool> {
    let mut jumps = vec![false; values.len()];
    for (at, part) in values.windows(5).enumerate() {
        let &[a, b, value, c, d] = part else { continue };
        let around = values.get(at.saturating_sub(2)..(at + 7).min(values.len())).unwrap_or(part);
        let (low, high) = around.iter().fold((f64::MAX, f64::MIN), |(low, high), one| (one.min(low), one.max(high)));
        jumps[at + 2] = (value - (4.0 * (b + c) - a - d) / 6.0).abs() > least + RANGE * (high - low);
    }
    let found: Vec<usize> = (0..jumps.len()).filter(|at| jumps[*at]).collect();
    for pair in found.windows(2).filter(|pair| pair[1] - pair[0] <= JOINED) {
        jumps[pair[0]..pair[1]].fill(true);
    }
    jumps
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A swing with 20 frames a period, seen at uneven times with errors of 0.1.
    fn swing(count: u32) -> (Vec<f64>, Vec<f64>) {
        let mut state = 7_u32;
        let mut uniform = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state >> 8) / f64::from(1 << 24) - 0.5
        };
        let times: Vec<f64> = (0..count).map(|k| f64::from(k) + 0.2 * uniform()).collect();
        let error = |uniform: &mut dyn FnMut() -> f64| 0.1 * (0..12).map(|_| uniform()).sum::<f64>();
        let value = |time: &f64| 60.0 * libm::sin(std::f64::consts::TAU / 20.0 * time) + error(&mut uniform);
        let values = times.iter().map(value).collect();
        (times, values)
    }

    #[test]
    fn sixth_differences_show_the_errors_and_not_the_motion() {
        let (times, values) = swing(300);
        let own = own(&times, &values).expect("enough values");
        assert!((0.085..0.115).contains(&own), "{own}");
        assert_eq!(super::own(&times[..6], &values[..6]), None);
    }

    #[test]
    fn formal_errors_keep_their_proportions() {
        let (times, values) = swing(300);
        let formal: Vec<f64> = (0..300).map(|k| if k == 100 { 0.04 } else { 0.02 }).collect();
        let sigmas = scaled(&times, &values, &formal);
        assert!((sigmas[100] / sigmas[0] - 2.0).abs() < 1e-12 && (0.085..0.115).contains(&sigmas[0]), "{}", sigmas[0]);
    }

    #[test]
    fn a_smooth_track_keeps_its_formal_errors() {
        let times: Vec<f64> = (0..30).map(f64::from).collect();
        assert_eq!(scaled(&times, &[100.0; 30], &[0.25; 30]), [0.25; 30]);
    }

    #[test]
    fn a_wrong_value_is_an_outlier() {
        let (times, mut values) = swing(100);
        let sigmas = vec![0.1; 100];
        assert!(!outliers(&times, &values, &sigmas, 6.0).contains(&true));
        for wrong in [0, 2, 50, 99] {
            let kept = std::mem::replace(&mut values[wrong], 100.0);
            assert!(outliers(&times, &values, &sigmas, 6.0)[wrong], "{wrong}");
            values[wrong] = kept;
        }
    }
}
