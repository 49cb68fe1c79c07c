//! Statistics of residuals: autocorrelation, runs of equal sign.

use serde::{Deserialize, Serialize};

/// Statistic of Durbin & Watson (Biometrika 37 (1950) 409): about 2 for independent residuals, near 0 for strong positive
/// autocorrelation. `series` are stretches without gaps.
pub fn durbin_watson(series: &[&[f64]]) -> f64 {
    let (mut differences, mut squares) = (0.0, 0.0);
    for residuals in series {
        squares += residuals.iter().fold(0.0, |sum, value| sum + value * value);
        differences += residuals.windows(2).fold(0.0, |sum, pair| sum + (pair[1] - pair[0]) * (pair[1] - pair[0]));
    }
    if squares > 0.0 { differences / squares } else { 2.0 }
}

/// Correlation of each residual with the one before, from -1 to 1. `series`: the residuals of each record, in the order of time.
pub fn autocorrelation(series: &[&[f64]]) -> f64 {
    let (mut products, mut squares) = (0.0, 0.0);
    for residuals in series {
        squares += residuals.iter().fold(0.0, |sum, value| sum + value * value);
        products += residuals.windows(2).fold(0.0, |sum, pair| sum + pair[1] * pair[0]);
    }
    if squares > 0.0 { products / squares } else { 0.0 }
}

/// Runs test of Wald & Wolfowitz (Ann. Math. Statist. 11 (1940) 147) on the signs of residuals.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RunsTest {
    /// Number of runs of equal sign.
    pub runs: usize,
    /// Expected number of runs for independent residuals.
    pub expected: f64,
    /// Difference in standard deviations; negative for too few runs.
    pub z: f64,
    /// Probability of a difference at least as large by chance.
    pub p: f64,
}

/// Counts the runs in each series. `None` for fewer than ten residuals or all of one sign.
pub fn runs_test(series: &[&[f64]]) -> Option<RunsTest> {
    let (mut runs, mut expected, mut variance, mut count) = (0_usize, 0.0, 0.0, 0.0);
    for residuals in series {
        let (mut positive, mut negative, mut last) = (0.0, 0.0, None);
        for &value in residuals.iter().filter(|value| **value != 0.0) {
            let sign = value > 0.0;
            if last != Some(sign) {
                runs += 1;
                last = Some(sign);
            }
            if sign {
                positive += 1.0;
            } else {
                negative += 1.0;
            }
        }
        let own: f64 = positive + negative;
        if own == 0.0 {
            continue;
        }
        let twice = 2.0 * positive * negative;
        count += own;
        expected += twice / own + 1.0;
        variance += twice * (twice - own) / (own * own * (own - 1.0).max(1.0));
    }
    if count < 10.0 || variance <= 0.0 {
        return None;
    }
    let z = (runs as f64 - expected) / variance.sqrt();
    Some(RunsTest { runs, expected, z, p: libm::erfc(z.abs() / std::f64::consts::SQRT_2) })
}

/// Number of lags in the sum of products of scores: the choice of Andrews for the Bartlett kernel, from the first-order
/// autocorrelation (Econometrica 59 (1991) 817, eq. 6.2 and 6.4). `scores` holds one series per parameter, of `count`
/// scores; parameters without a score are ignored.
pub(crate) fn lags(scores: &[&[f64]], count: usize) -> usize {
    let (mut numerator, mut denominator) = (0.0, 0.0);
    for series in scores.iter().filter(|series| series.iter().any(|score| *score != 0.0)) {
        // The formula is not valid beyond this.
        let rho = autocorrelation(&[series]).clamp(-0.97, 0.97);
        let (minus, plus) = (1.0 - rho, 1.0 + rho);
        let minus_4 = minus * minus * minus * minus;
        numerator += 4.0 * rho * rho / (minus_4 * minus * minus * plus * plus);
        denominator += 1.0 / minus_4;
    }
    if denominator == 0.0 || count < 4 {
        return 0;
    }
    let lags = 1.1447 * libm::cbrt(numerator / denominator * count as f64);
    (lags as usize).min(count / 3)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn residuals_that_alternate_and_that_cling() {
        let alternate = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0];
        let cling = [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0];
        assert_eq!(durbin_watson(&[&alternate]), 44.0 / 12.0);
        assert_eq!(durbin_watson(&[&cling]), 4.0 / 12.0);
        assert_eq!(autocorrelation(&[&cling]), 9.0 / 12.0);
        let test = runs_test(&[&cling]).unwrap();
        // 6 of each sign: 7 runs expected, variance 30/11.
        assert_eq!((test.runs, test.expected), (2, 7.0));
        assert!((test.z + 5.0 / libm::sqrt(30.0 / 11.0)).abs() < 1e-12);
        assert!((test.p - 0.002_463).abs() < 1e-5);
        assert!(runs_test(&[&alternate]).unwrap().z > 2.9);
        assert_eq!(runs_test(&[&cling[..6]]), None);
    }

    /// 1.1447 cbrt(100,000 alpha), with alpha computed by another program from the correlations 1/4, 3/4 and -11/12.
    #[test]
    fn lags_are_those_of_the_formula() {
        let quarter = [1.0, 1.0, 1.0, -1.0, -1.0, -1.0, 1.0, 1.0, -1.0, -1.0, 1.0, 1.0];
        let cling = [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0];
        let alternate = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0];
        let nothing = [0.0; 12];
        let cases: [(&[&[f64]], usize); 5] = [
            (&[&quarter], 34),
            (&[&quarter, &alternate], 79),
            (&[&cling, &nothing], 120),
            (&[&alternate], 270),
            (&[&quarter, &cling], 120),
        ];
        for (scores, expected) in cases {
            assert_eq!(lags(scores, 100_000), expected);
        }
        assert_eq!((lags(&[&alternate], 12), lags(&[&alternate], 3), lags(&[&nothing], 100)), (4, 0, 0));
    }
}
