//! Quantile of the chi-squared distribution, to ten digits.

/// Steps of the bisection for a quantile; each halves the interval.
const HALVINGS: u32 = 60;

/// Quantile of the chi-squared distribution: the value below which it lies with this probability. `freedom` at least 1.
pub(super) fn chi_squared(probability: f64, freedom: u32) -> f64 {
    let half = 0.5 * f64::from(freedom.max(1));
    let largest = 2.0 * half + 20.0 * (2.0 * half).sqrt() + 100.0;
    bisected(0.0, largest, |value| lower_gamma(half, 0.5 * value) < probability)
}

/// Regularised lower incomplete gamma function P(a, x) by its power series (DLMF 8.11.4). All terms are positive.
fn lower_gamma(a: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    let (mut term, mut sum, mut k) = (1.0 / a, 1.0 / a, a);
    while term > 1e-17 * sum {
        k += 1.0;
        term *= x / k;
        sum += term;
    }
    sum * libm::exp(a * libm::log(x) - x - libm::lgamma(a))
}

/// Place between two numbers up to which a condition holds.
pub(super) fn bisected(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of scipy.stats 1.11: `chi2.ppf(p, n)`.
    #[test]
    fn quantiles_are_those_of_scipy() {
        for (probability, freedom, expected) in [
            (0.025, 1, 9.820_691_171e-4),
            (0.975, 1, 5.023_886_187),
            (0.025, 12, 4.403_788_507),
            (0.975, 12, 23.336_664_158),
            (0.975, 39, 58.120_059_735),
        ] {
            let found = chi_squared(probability, freedom);
            assert!((found - expected).abs() < 1e-8 * expected, "{freedom}: {found}");
        }
    }
}
