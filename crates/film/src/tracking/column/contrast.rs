//! Contrast of the clicked place relative to the noise.

use crate::tracking::median::median;

/// Median of the absolute value of a standard normal deviate.
const MEDIAN: f64 = 0.6745;

/// Signal-to-noise ratio of a profile around a row: root mean square about the regression line, relative to the
/// standard deviation of the noise. A linear change of brightness does not help to locate a row. Noise alone gives
/// about 1.
///
/// The noise is estimated from differences of successive profiles, in which the surface passes only few rows.
pub(crate) fn contrast(profiles: &[Vec<f32>], clicked: usize, row: f64, half: usize) -> f64 {
    let noise = median(profiles.windows(2).map(|pair| difference(&pair[0], &pair[1])).collect()) / 2.0_f64.sqrt();
    let profile = profiles.get(clicked).map_or(&[][..], Vec::as_slice);
    let middle = row.round().max(0.0) as usize;
    let rows = middle.saturating_sub(half)..(middle + half + 1).min(profile.len());
    let signal = about_line(profile.get(rows).unwrap_or_default());
    if signal > 0.0 { signal / noise } else { 0.0 }
}

/// Standard deviation of the difference of two profiles, from its median absolute deviation. Rows with motion and
/// uniform flicker have little effect.
fn difference(one: &[f32], other: &[f32]) -> f64 {
    let differences: Vec<f64> = one.iter().zip(other).map(|(a, b)| f64::from(b - a)).collect();
    let common = median(differences.clone());
    median(differences.into_iter().map(|value| (value - common).abs()).collect()) / MEDIAN
}

/// Root mean square of values about their regression line.
fn about_line(values: &[f32]) -> f64 {
    let count = values.len() as f64;
    let mean = values.iter().map(|value| f64::from(*value)).sum::<f64>() / count;
    let places =
        || values.iter().enumerate().map(|(at, value)| (at as f64 - (count - 1.0) / 2.0, f64::from(*value) - mean));
    let (products, squares) =
        places().fold((0.0, 0.0), |(products, squares), (x, y)| (products + x * y, squares + x * x));
    let slope = products / f64::max(squares, 1.0);
    // The line takes two degrees of freedom.
    let residuals: f64 = places().map(|(x, y)| (y - slope * x) * (y - slope * x)).sum();
    (residuals / (count - 2.0).max(1.0)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Profiles of 200 rows with evenly distributed noise of standard deviation 1, and a slope.
    fn noisy(count: usize, signal: impl Fn(usize) -> f32) -> Vec<Vec<f32>> {
        let mut state = 7_u32;
        let mut noise = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            ((state >> 8) as f32 / (1 << 24) as f32 - 0.5) * 12.0_f32.sqrt()
        };
        (0..count).map(|_| (0..200).map(|row| 100.0 + 0.3 * row as f32 + signal(row) + noise()).collect()).collect()
    }

    #[test]
    fn noise_and_even_light_have_a_ratio_near_one() {
        let profiles = noisy(30, |_| 0.0);
        for row in [0.0, 50.0, 120.0, 199.0] {
            let ratio = contrast(&profiles, 3, row, 20);
            assert!((0.6..1.4).contains(&ratio), "{row}: {ratio}");
        }
    }

    #[test]
    fn an_edge_has_its_height_in_units_of_the_noise() {
        let profiles = noisy(30, |row| if row < 100 { 0.0 } else { 40.0 });
        // A step of height 1 is 1/4 about its line.
        let ratio = contrast(&profiles, 3, 100.0, 20);
        assert!((9.0..11.0).contains(&ratio), "{ratio}");
        assert_eq!(contrast(&[], 0, 5.0, 20), 0.0);
    }
}
