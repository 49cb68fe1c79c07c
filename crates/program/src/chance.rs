//! Random draws as pure functions: the same arguments give the same bits on every machine, whatever was drawn before.
//!
//! Each draw has its own stream, an integer that [`stream`] mixes from the seed, the quantity and the index of the firing.
//! The stream seeds a SplitMix64 generator (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014, 453), which gives as many
//! numbers as the draw needs.

use units::split_mix::{GOLDEN, SplitMix64, scramble};

/// Maximum number of rejection rounds. The average is below two; only absurd arguments reach the maximum.
const ROUNDS: usize = 1000;
/// Mean from which on rejection is faster than summing probabilities.
const LARGE: f64 = 10.0;
/// Number beyond which logarithms of factorials are too inexact to be compared. The distribution is then normal to four
/// digits, or a Poisson distribution.
const ENORMOUS: f64 = 1e12;

/// Hash of two numbers: an integer from 0 to 2^53 - 1; NaN if either is NaN.
pub fn stream(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        return f64::NAN;
    }
    // 0 and -0 must give the same stream.
    let bits = |number: f64| (number + 0.0).to_bits();
    let mixed = scramble(scramble(bits(a).wrapping_add(GOLDEN)) ^ bits(b).wrapping_add(GOLDEN));
    (mixed >> 11) as f64
}

/// Random number generator of a stream.
struct Numbers(SplitMix64);

impl Numbers {
    /// The generator of a stream; `None` for NaN.
    fn of(stream: f64) -> Option<Self> {
        (!stream.is_nan()).then(|| Self(SplitMix64::new(scramble((stream + 0.0).to_bits()))))
    }

    /// Next number, uniform in (0, 1), both ends excluded.
    fn next(&mut self) -> f64 {
        ((self.0.bits() >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
    }
}

/// Uniform draw in (0, 1); NaN if `stream` is NaN.
pub fn uniform(stream: f64) -> f64 {
    Numbers::of(stream).map_or(f64::NAN, |mut numbers| numbers.next())
}

/// Normal draw with mean 0 and standard deviation 1 (G. E. P. Box, M. E. Muller, Ann. Math. Stat. 29 (1958) 610); NaN if
/// `stream` is NaN.
pub fn normal(stream: f64) -> f64 {
    let Some(mut numbers) = Numbers::of(stream) else { return f64::NAN };
    let radius = (-2.0 * libm::log(numbers.next())).sqrt();
    radius * libm::cos(2.0 * std::f64::consts::PI * numbers.next())
}

/// Exponential draw with mean 1; NaN if `stream` is NaN.
pub fn exponential(stream: f64) -> f64 {
    -libm::log(uniform(stream))
}

/// Poisson draw with this mean; NaN if the mean is negative or not finite, or if `stream` is NaN.
pub fn poisson(mean: f64, stream: f64) -> f64 {
    let Some(mut numbers) = Numbers::of(stream).filter(|_| mean >= 0.0 && mean.is_finite()) else { return f64::NAN };
    if mean < LARGE {
        return invert(numbers.next(), libm::exp(-mean), |count| mean / count);
    }
    if mean > ENORMOUS {
        return (mean + mean.sqrt() * normal(stream)).round();
    }
    // PTRS of W. Hörmann, Insurance: Mathematics and Economics 12 (1993) 39.
    let b = 0.931 + 2.53 * mean.sqrt();
    let a = -0.059 + 0.02483 * b;
    let inverse = 1.1239 + 1.1328 / (b - 3.4);
    let squeeze = 0.9277 - 3.6224 / (b - 2.0);
    for _ in 0..ROUNDS {
        let (u, v) = (numbers.next() - 0.5, numbers.next());
        let margin = 0.5 - u.abs();
        let count = ((2.0 * a / margin + b) * u + mean + 0.43).floor();
        if margin >= 0.07 && v <= squeeze {
            return count;
        }
        if count < 0.0 || (margin < 0.013 && v > margin) {
            continue;
        }
        let accepted = libm::log(v * inverse / (a / (margin * margin) + b));
        if accepted <= count * libm::log(mean) - mean - libm::lgamma(count + 1.0) {
            return count;
        }
    }
    mean.round()
}

/// Binomial draw: number of successes in `trials` with this probability each. NaN if `trials` is negative, not an integer
/// or not finite, if the probability is outside 0 to 1, or if `stream` is NaN.
pub fn binomial(trials: f64, probability: f64, stream: f64) -> f64 {
    let possible =
        trials >= 0.0 && trials.is_finite() && trials.floor() == trials && (0.0..=1.0).contains(&probability);
    let Some(mut numbers) = Numbers::of(stream).filter(|_| possible) else { return f64::NAN };
    if probability > 0.5 {
        return trials - binomial(trials, 1.0 - probability, stream);
    }
    let (mean, odds) = (trials * probability, probability / (1.0 - probability));
    if mean < LARGE {
        let none = libm::exp(trials * libm::log1p(-probability));
        return invert(numbers.next(), none, |count| odds * (trials - count + 1.0) / count).min(trials);
    }
    let deviation = (mean * (1.0 - probability)).sqrt();
    if trials > ENORMOUS {
        return match probability < 1e-4 {
            true => poisson(mean, stream),
            false => (mean + deviation * normal(stream)).round(),
        };
    }
    // BTRS of W. Hörmann, J. Stat. Comput. Simul. 46 (1993) 101.
    let b = 1.15 + 2.53 * deviation;
    let a = -0.0873 + 0.0248 * b + 0.01 * probability;
    let squeeze = 0.92 - 4.2 / b;
    let alpha = (2.83 + 5.1 / b) * deviation;
    let mode = ((trials + 1.0) * probability).floor();
    let factorials = |count: f64| libm::lgamma(count + 1.0) + libm::lgamma(trials - count + 1.0);
    for _ in 0..ROUNDS {
        let (u, v) = (numbers.next() - 0.5, numbers.next());
        let margin = 0.5 - u.abs();
        let count = ((2.0 * a / margin + b) * u + mean + 0.5).floor();
        if !(0.0..=trials).contains(&count) {
            continue;
        }
        if margin >= 0.07 && v <= squeeze {
            return count;
        }
        let accepted = libm::log(v * alpha / (a / (margin * margin) + b));
        if accepted <= factorials(mode) - factorials(count) + (count - mode) * libm::log(odds) {
            return count;
        }
    }
    mode
}

/// Inversion by summation: the smallest count at which the cumulative probability reaches `part`. `none` is the probability
/// of 0, `ratio(k)` that of `k` divided by that of `k - 1`.
fn invert(part: f64, none: f64, ratio: impl Fn(f64) -> f64) -> f64 {
    let (mut count, mut probability, mut sum) = (0.0, none, none);
    // For a mean below 10 the probability beyond is negligible.
    while part > sum && count < ROUNDS as f64 {
        count += 1.0;
        probability *= ratio(count);
        sum += probability;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    const DRAWS: usize = 1_000_000;

    /// Mean and variance of many draws agree with the expected ones within 5 standard errors; `kurtosis` is the fourth
    /// central moment divided by the squared variance.
    #[track_caller]
    fn check(what: &str, draw: impl Fn(f64) -> f64, mean: f64, variance: f64, kurtosis: f64) {
        let key = stream(7.0, 12_345.0);
        let values: Vec<f64> = (0..DRAWS).map(|number| draw(stream(key, number as f64))).collect();
        let n = DRAWS as f64;
        let found = values.iter().sum::<f64>() / n;
        assert!((found - mean).abs() <= 5.0 * (variance / n).sqrt(), "{what}: mean {found} and not {mean}");
        let spread = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / n;
        let error = variance * ((kurtosis - 1.0) / n).sqrt();
        assert!((spread - variance).abs() <= 5.0 * error, "{what}: variance {spread} and not {variance} ± {error}");
    }

    #[test]
    fn distributions_have_their_means_and_variances() {
        check("uniform", uniform, 0.5, 1.0 / 12.0, 1.8);
        check("normal", normal, 0.0, 1.0, 3.0);
        check("exponential", exponential, 1.0, 1.0, 9.0);
        for mean in [0.01, 0.7, 3.0, 9.9, 10.1, 33.3, 1e3, 1e6, 3e9, 9e11, 1e14] {
            check(&format!("poisson {mean}"), |stream| poisson(mean, stream), mean, mean, 3.0 + 1.0 / mean);
        }
        for (trials, p) in [
            (1.0, 0.3),
            (20.0, 0.1),
            (20.0, 0.9),
            (19.0, 0.5),
            (1000.0, 0.02),
            (1e6, 1e-6),
            (1e6, 0.25),
            (1e6, 0.999),
            (1e11, 1e-9),
            (1e13, 1e-11),
            (1e15, 0.5),
        ] {
            let variance: f64 = trials * p * (1.0 - p);
            let kurtosis = 3.0 + (1.0 - 6.0 * p * (1.0 - p)) / variance;
            check(
                &format!("binomial {trials} {p}"),
                |stream| binomial(trials, p, stream),
                trials * p,
                variance,
                kurtosis,
            );
        }
    }

    /// Frequencies of the single counts, on both sides of the mean where the method changes.
    #[test]
    fn counts_are_as_frequent_as_they_should_be() {
        let compare = |what: &str, draw: &dyn Fn(f64) -> f64, probability: &dyn Fn(f64) -> f64| {
            let key = stream(3.0, 99.0);
            let mut counts = vec![0.0; 64];
            for number in 0..DRAWS {
                counts[draw(stream(key, number as f64)) as usize] += 1.0;
            }
            for (count, found) in counts.into_iter().enumerate() {
                let expected = DRAWS as f64 * probability(count as f64);
                let error = expected.max(1.0).sqrt();
                assert!((found - expected).abs() < 5.5 * error, "{what} {count}: {found} and not {expected}");
            }
        };
        for mean in [9.5, 12.5] {
            let of = |k: f64| libm::exp(k * libm::log(mean) - mean - libm::lgamma(k + 1.0));
            compare(&format!("poisson {mean}"), &|stream| poisson(mean, stream), &of);
        }
        for p in [0.15, 0.3] {
            let n = 50.0;
            let of = |k: f64| {
                if k > n {
                    return 0.0;
                }
                let ways = libm::lgamma(n + 1.0) - libm::lgamma(k + 1.0) - libm::lgamma(n - k + 1.0);
                libm::exp(ways + k * libm::log(p) + (n - k) * libm::log(1.0 - p))
            };
            compare(&format!("binomial {p}"), &|stream| binomial(n, p, stream), &of);
        }
    }

    /// Three neighbouring seeds, sites or firings are uncorrelated.
    #[test]
    fn neighbours_are_not_correlated() {
        let by_seed = |seed: f64, number: f64| uniform(stream(stream(seed, 5.0), number));
        let by_site = |site: f64, number: f64| uniform(stream(stream(1.0, site), number));
        let by_firing = |lag: f64, number: f64| uniform(stream(stream(1.0, 5.0), number + lag));
        let series: [&dyn Fn(f64, f64) -> f64; 3] = [&by_seed, &by_site, &by_firing];
        for (which, of) in series.into_iter().enumerate() {
            for (a, b) in [(1.0, 2.0), (2.0, 3.0), (1.0, 3.0)] {
                let product = |number: usize| (of(a, number as f64) - 0.5) * (of(b, number as f64) - 0.5);
                let correlation = 12.0 * (0..DRAWS).map(product).sum::<f64>() / DRAWS as f64;
                assert!(correlation.abs() < 5.0 / (DRAWS as f64).sqrt(), "{which}: {a} {b}: {correlation}");
            }
        }
    }

    /// Reference bits, equal on all machines, and undefined arguments.
    #[test]
    fn bits_and_what_is_undefined() {
        assert_eq!(stream(1.0, 2.0), stream(1.0, 2.0));
        assert_ne!(stream(1.0, 2.0), stream(2.0, 1.0));
        assert_eq!(stream(0.0, -0.0), stream(-0.0, 0.0));
        let nan = f64::NAN;
        for value in [
            stream(nan, 1.0),
            stream(1.0, nan),
            uniform(nan),
            normal(nan),
            exponential(nan),
            poisson(nan, 1.0),
            poisson(-1.0, 1.0),
            poisson(f64::INFINITY, 1.0),
            poisson(1.0, nan),
            binomial(nan, 0.5, 1.0),
            binomial(2.0, nan, 1.0),
            binomial(2.5, 0.5, 1.0),
            binomial(-1.0, 0.5, 1.0),
            binomial(2.0, 1.5, 1.0),
            binomial(f64::INFINITY, 0.5, 1.0),
        ] {
            assert!(value.is_nan());
        }
        for number in 0..1000 {
            let own = stream(8.0, f64::from(number));
            assert_eq!((poisson(0.0, own), binomial(0.0, 0.5, own), binomial(9.0, 0.0, own)), (0.0, 0.0, 0.0));
            assert_eq!(binomial(9.0, 1.0, own), 9.0);
            // The greatest arguments terminate, with possible results.
            assert!(poisson(f64::MAX, own).is_finite() && poisson(f64::MIN_POSITIVE, own) == 0.0);
            assert!((0.0..=f64::MAX).contains(&binomial(f64::MAX, 0.5, own)));
        }
    }
}
