//! Standard deviation between groups.

use super::measured::Measured;
use super::quantiles::bisected;

/// Standard deviation between the groups at which a sum of squared deviations takes the value `target`; 0 if the sum is
/// smaller without any. `squares`: the sum, in units of the variances, with this variance between the groups; it decreases.
pub(crate) fn scatter(results: &[Measured], target: f64, squares: impl Fn(f64) -> f64) -> f64 {
    if squares(0.0) <= target {
        return 0.0;
    }
    // At the square of 1000 ranges and errors the sum is negligible.
    let low = results.iter().map(|one| one.value).fold(f64::INFINITY, f64::min);
    let high = results.iter().map(|one| one.value).fold(f64::NEG_INFINITY, f64::max);
    let largest_error = results.iter().map(|one| one.error).fold(0.0, f64::max);
    bisected(0.0, 1000.0 * (high - low + largest_error), |tau| squares(tau * tau) > target)
}
