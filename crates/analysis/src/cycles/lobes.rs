//! Crossings of the middle level of an oscillation, and the extremes between them.

use super::damped::Points;
use crate::fit::autoregression::correlated;
use crate::fit::linear::dot;
use units::order::median;

/// Part of a record between two crossings.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lobe {
    /// Time of the extreme.
    pub time: f64,
    /// Distance of the extreme from the middle level, with its sign.
    pub height: f64,
    /// True if the extreme is the first or last row, so that it may not be a turning point.
    pub cut: bool,
}

/// Crossings and lobes of a record about its middle level.
#[derive(Debug, Default)]
pub(super) struct Swings {
    /// Times of the crossings, alternately downwards and upwards.
    pub crossings: Vec<f64>,
    /// Lobes, one more than the crossings.
    pub lobes: Vec<Lobe>,
}

/// Standard deviation of uncorrelated noise about a smooth signal; see [`correlated_scatter`].
pub(super) fn scatter(values: &[f64]) -> f64 {
    correlated_scatter(values, 0.0)
}

/// Standard deviation of noise about a smooth signal, where neighbouring noise values have the correlation `rho`. It is
/// estimated from the median of fourth differences, in which a slow oscillation vanishes, or of second differences, if that
/// is less.
pub(super) fn correlated_scatter(values: &[f64], rho: f64) -> f64 {
    const FOURTH: [f64; 5] = [1.0, -4.0, 6.0, -4.0, 1.0];
    const SECOND: [f64; 3] = [1.0, -2.0, 1.0];
    // Only about 500 differences, enough for a median.
    let stride = (values.len() / 500).max(1);
    let fourth = |v: &[f64]| (v[0] - 4.0 * v[1] + 6.0 * v[2] - 4.0 * v[3] + v[4]).abs();
    let second = |v: &[f64]| (v[0] - 2.0 * v[1] + v[2]).abs();
    let differences =
        |width: usize, of: &dyn Fn(&[f64]) -> f64| values.windows(width).step_by(stride).map(of).collect();
    let variance = |of: &[f64]| dot(of, &correlated(of, rho));
    // 1.4826 converts a median to a standard deviation.
    let scatter = [(differences(5, &fourth), variance(&FOURTH)), (differences(3, &second), variance(&SECOND))]
        .into_iter()
        .map(|(differences, variance)| 1.4826 * median(differences) / variance.sqrt())
        .fold(f64::INFINITY, f64::min);
    if scatter.is_finite() { scatter } else { 0.0 }
}

/// Crossings of `middle`. A value within `threshold` of it (both in the unit of the values) has not crossed yet, so that noise makes no crossings.
pub(super) fn swings(points: Points, middle: f64, threshold: f64) -> Swings {
    let mut swings = Swings::default();
    let last = points.values.len().saturating_sub(1);
    let mut side = 0.0_f64;
    // Last point clearly on the present side.
    let mut clear = 0;
    for (index, (&time, &value)) in points.times.iter().zip(points.values).enumerate() {
        let height = value - middle;
        if height.abs() > threshold {
            if side * height <= 0.0 {
                if side != 0.0 {
                    let crossing = clear..index + 1;
                    let points = Points { times: &points.times[crossing.clone()], values: &points.values[crossing] };
                    swings.crossings.push(crossing_time(points, middle));
                }
                side = height.signum();
                swings.lobes.push(Lobe { time, height, cut: index == 0 });
            }
            clear = index;
        }
        if let Some(lobe) = swings.lobes.last_mut()
            && height * side > lobe.height * side
        {
            *lobe = Lobe { time, height, cut: index == last };
        }
    }
    swings
}

/// Time at which the straight line through these points crosses `middle`.
fn crossing_time(points: Points, middle: f64) -> f64 {
    let count = points.times.len() as f64;
    let mean_time = points.times.iter().sum::<f64>() / count;
    let mean_value = points.values.iter().sum::<f64>() / count;
    let (mut product, mut square) = (0.0, 0.0);
    for (time, value) in points.times.iter().zip(points.values) {
        product += (time - mean_time) * (value - mean_value);
        square += (time - mean_time) * (time - mean_time);
    }
    let crossing = mean_time + (middle - mean_value) * square / product;
    match (points.times.first(), points.times.last()) {
        (Some(first), Some(last)) if (*first..=*last).contains(&crossing) => crossing,
        (Some(first), Some(last)) => (first + last) / 2.0,
        _ => crossing,
    }
}
