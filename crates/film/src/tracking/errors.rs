//! Standard errors from the track itself.
//!
//! Formal errors of a comparison of pixels take the noise of neighbouring pixels for independent, which compression makes
//! untrue. A smooth motion vanishes in sixth differences, and noise does not: they tell how large the errors really are.

/// Frames that a sixth difference joins.
const JOINED: usize = 7;
/// No position of a compressed picture is better than this, in pixels.
const LEAST: f64 = 0.02;

/// The weights of the sixth divided difference at these times, so that independent errors of variance 1 give it variance 1.
fn weights(times: &[f64]) -> Option<[f64; JOINED]> {
    let mut weights = [0.0; JOINED];
    for (k, weight) in weights.iter_mut().enumerate() {
        let others = times.iter().enumerate().filter(|(j, _)| *j != k);
        *weight = 1.0 / others.map(|(_, other)| times[k] - other).product::<f64>();
    }
    let norm = weights.iter().map(|weight| weight * weight).sum::<f64>().sqrt();
    weights.iter_mut().for_each(|weight| *weight /= norm);
    norm.is_finite().then_some(weights)
}

/// The sixth differences of a coordinate, each in units of one value's error; by the first of their seven frames.
pub(crate) fn differences(times: &[f64], values: &[f64]) -> Vec<Option<f64>> {
    let windows = times.windows(JOINED).zip(values.windows(JOINED));
    windows.map(|(times, values)| Some(weights(times)?.iter().zip(values).map(|(a, b)| a * b).sum())).collect()
}

/// The standard error of a coordinate's values, by the median of the squared sixth differences (0.4549 is the median of chi squared with
/// one degree of freedom); `None` for fewer than seven.
pub(crate) fn own(times: &[f64], values: &[f64]) -> Option<f64> {
    let mut squares: Vec<f64> = differences(times, values).into_iter().flatten().map(|value| value * value).collect();
    squares.sort_by(f64::total_cmp);
    squares.get(squares.len() / 2).map(|median| (median / 0.4549).sqrt())
}

/// The standard errors of a coordinate: the formal ones, times a factor that makes them as large as the scatter of the track.
pub(crate) fn scaled(times: &[f64], values: &[f64], formal: &[f64]) -> Vec<f64> {
    let mut sorted: Vec<f64> = formal.iter().copied().filter(|error| error.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    // The median: a frame without a surface would decide the mean.
    let usual = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
    let factor = match own(times, values) {
        Some(own) if usual > 0.0 => own / usual,
        _ => 1.0,
    };
    formal.iter().map(|error| (error * factor).max(LEAST)).collect()
}

/// Which values lie further than `limit` of their errors from what their neighbours predict.
pub(crate) fn outliers(times: &[f64], values: &[f64], sigmas: &[f64], limit: f64) -> Vec<bool> {
    // A wrong value shows in every difference that contains it, and most where its weight is largest.
    let differences = differences(times, values);
    (0..values.len())
        .map(|at| {
            let middle = at.saturating_sub(JOINED / 2).min(differences.len().saturating_sub(1));
            let Some(difference) = differences.get(middle).copied().flatten() else { return false };
            let Some(weights) = times.get(middle..middle + JOINED).and_then(weights) else { return false };
            let error: f64 = (0..JOINED).map(|k| weights[k] * sigmas[middle + k]).map(|part| part * part).sum();
            let own = weights.get(at - middle).copied().unwrap_or(0.0).abs();
            let largest = weights.iter().fold(0.0_f64, |largest, weight| largest.max(weight.abs()));
            difference.abs() > limit * error.sqrt() && own >= 0.99 * largest
        })
        .collect()
}
