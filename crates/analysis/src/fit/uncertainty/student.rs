//! Quantiles of the normal distribution and of Student's t.

/// Two-sided quantile of the normal distribution, in standard deviations: 2 for a probability of 0.0455 beyond it.
pub(crate) fn normal(probability: f64) -> f64 {
    // erfc is convex here, so that Newton's steps from below never overshoot.
    let mut x: f64 = 0.0;
    for _ in 0..200 {
        let excess = libm::erfc(x) - probability;
        let step = excess / (core::f64::consts::FRAC_2_SQRT_PI * libm::exp(-x * x));
        x += step;
        if step.abs() <= 1e-12 * x {
            break;
        }
    }
    x * core::f64::consts::SQRT_2
}

/// Two-sided quantile of Student's t with `freedom` degrees of freedom, at least 1 and not necessarily whole: 12.7 for 0.05
/// and one degree, 1.96 for many. Accurate to 0.001, for 0.05 and 5 degrees or more to 5e-5 (G. W. Hill, Comm. ACM 13 (1970)
/// 619, algorithm 396).
pub fn student(probability: f64, freedom: f64) -> f64 {
    let n = freedom.max(1.0);
    if n < 1.5 {
        // Cauchy distribution.
        let angle = probability * core::f64::consts::FRAC_PI_2;
        return libm::cos(angle) / libm::sin(angle);
    }
    let a = 1.0 / (n - 0.5);
    let b = 48.0 / (a * a);
    let mut c = ((20_700.0 * a / b - 98.0) * a - 16.0) * a + 96.36;
    let d = ((94.5 / (b + c) - 3.0) / b + 1.0) * (a * core::f64::consts::FRAC_PI_2).sqrt() * n;
    let power = libm::pow(d * probability, 2.0 / n);
    let y = if power > 0.05 + a {
        let x = normal(probability);
        let square = x * x;
        if n < 5.0 {
            c += 0.3 * (n - 4.5) * (x + 0.6);
        }
        c += (((0.05 * d * x - 5.0) * x - 7.0) * x - 2.0) * x + b;
        let y = (((((0.4 * square + 6.3) * square + 36.0) * square + 94.5) / c - square - 3.0) / b + 1.0) * x;
        libm::expm1(a * y * y)
    } else {
        ((1.0 / (((n + 6.0) / (n * power) - 0.089 * d - 0.822) * (n + 2.0) * 3.0) + 0.5 / (n + 4.0)) * power - 1.0)
            * (n + 1.0)
            / (n + 2.0)
            + 1.0 / power
    };
    (n * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (probability, expected) in
            [(0.317_310_507_9, 1.0), (0.05, 1.959_963_985), (0.01, 2.575_829_304), (1e-6, 4.891_638)]
        {
            assert!((normal(probability) - expected).abs() < 1e-6, "{probability}");
        }
        // Two-sided, from tables with seven digits.
        for (probability, freedom, expected) in [
            (0.05, 1.0, 12.706_20),
            (0.05, 2.0, 4.302_653),
            (0.05, 3.0, 3.182_446),
            (0.05, 5.0, 2.570_582),
            (0.05, 10.0, 2.228_139),
            (0.05, 20.0, 2.085_963),
            (0.05, 120.0, 1.979_930),
            (0.01, 4.0, 4.604_095),
            (0.001, 10.0, 4.586_894),
            (0.001, 30.0, 3.645_959),
            (0.001, 120.0, 3.373_454),
            (0.2, 2.0, 1.885_618),
            (0.2, 3.0, 1.637_744),
            (0.2, 10.0, 1.372_184),
            (0.2, 30.0, 1.310_415),
            (0.5, 2.0, 0.816_496_6),
            (0.5, 3.0, 0.764_892_3),
            (0.5, 4.0, 0.740_697_1),
            (0.5, 10.0, 0.699_812_1),
            (0.5, 30.0, 0.682_755_7),
            (0.9, 3.0, 0.136_598_2),
            (0.9, 10.0, 0.128_890_2),
        ] {
            let found = student(probability, freedom);
            let accuracy = if freedom < 3.0 { 1e-3 } else { 2e-3 / (freedom * freedom).min(2_000.0) };
            assert!((found / expected - 1.0).abs() < accuracy, "{probability} {freedom}: {found}");
        }
    }
}
