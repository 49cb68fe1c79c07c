//! Velocity and acceleration from positions in neighbouring frames.

/// Velocity and acceleration at position `at`, from the parabola through it and its neighbours; 0 for fewer than three
/// positions. `times` in s.
pub(crate) fn motion(times: &[f64], values: &[f64], at: usize) -> (f64, f64) {
    let count = times.len().min(values.len());
    if count < 3 {
        return (0.0, 0.0);
    }
    let middle = at.clamp(1, count - 2);
    let (before, after) = (times[middle] - times[middle - 1], times[middle + 1] - times[middle]);
    let first = (values[middle] - values[middle - 1]) / before;
    let second = (values[middle + 1] - values[middle]) / after;
    let curvature = (second - first) / (before + after);
    let late = times[at.min(count - 1)] - times[middle];
    let velocity = (first * after + second * before) / (before + after) + 2.0 * curvature * late;
    (velocity, 2.0 * curvature)
}

/// Displacements in px from the position at the middle of an exposure of `exposure` s, at evenly spaced instants. A
/// single 0 without an exposure.
pub(crate) fn smear((velocity, acceleration): (f64, f64), exposure: f64) -> Vec<f64> {
    let length = velocity.abs() * exposure;
    if exposure <= 0.0 || !(length + acceleration * exposure * exposure).is_finite() {
        return vec![0.0];
    }
    // Two instants per pixel: the shifted splines are four pixels wide.
    let count = (2.0 * length).ceil().clamp(2.0, 64.0);
    let shift = |k: usize| {
        let late = ((k as f64 + 0.5) / count - 0.5) * exposure;
        // Midpoints of subintervals have a smaller variance than the whole interval; the factor corrects that.
        let late = late * (count * count / (count * count - 1.0)).sqrt();
        velocity * late + acceleration * late * late / 2.0
    };
    (0..count as usize).map(shift).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_has_its_velocity_and_acceleration_everywhere() {
        let times = [0.0, 0.1, 0.25, 0.3];
        let values = times.map(|t| 2.0 - 3.0 * t + 4.0 * t * t);
        for (at, t) in times.iter().enumerate() {
            let (velocity, acceleration) = motion(&times, &values, at);
            assert!((velocity - (8.0 * t - 3.0)).abs() < 1e-9, "{at}");
            assert!((acceleration - 8.0).abs() < 1e-9, "{at}");
        }
    }

    #[test]
    fn smear_has_the_moments_of_the_motion() {
        let shifts = smear((300.0, 5000.0), 0.02);
        let mean = shifts.iter().sum::<f64>() / shifts.len() as f64;
        assert!((mean - 5000.0 * 0.02 * 0.02 / 24.0).abs() < 1e-9);
        let variance = shifts.iter().map(|shift| (shift - mean) * (shift - mean)).sum::<f64>() / shifts.len() as f64;
        assert!((variance - 3.0).abs() < 0.02, "{variance}");
    }
}
