//! Interpolants of compared values, and their check against the continuous solution at two interior points.

use crate::methods::cubic::Cubic;

/// Fractions of the interval at which an interpolant is checked. Irregular, so that an oscillation in phase with the step is
/// noticed.
pub const CHECKS: [f64; 2] = [0.29, 0.62];
/// Accepted error of an interpolant, relative to its greatest magnitude.
const EXACTNESS: f64 = 1e-3;

/// Least distance of Bernstein coefficients from 0, relative to all of them, with which signs do not depend on rounding.
const CERTAINTY: f64 = 1e-9;

/// True if only one of two values is finite: the value becomes undefined between them. A comparison with NaN would hide that.
pub(crate) fn ceases(a: f64, b: f64) -> bool {
    a.is_finite() != b.is_finite()
}

/// Error of an interpolant so far, from its error before, the value found and the value expected.
pub(crate) fn worse(wrong: f64, found: f64, expected: f64) -> f64 {
    if ceases(found, expected) { f64::INFINITY } else { wrong.max((found - expected).abs()) }
}

/// True if an interpolant with this error is accepted.
pub(crate) fn is_right(cubic: Cubic, wrong: f64) -> bool {
    let (least, greatest) = cubic.range();
    if !(least.is_finite() && greatest.is_finite()) {
        // Not finite at either end; right if it is not finite in between either.
        return wrong.is_finite();
    }
    let nearest = if least > 0.0 { least } else { -greatest };
    wrong <= EXACTNESS * greatest.abs().max(least.abs()) || 4.0 * wrong < nearest
}

/// [`sign_changes`] if it is certainly 0 or 1, otherwise NaN. Without branches, for many intervals at once.
///
/// A cubic changes its sign at most as often as the sequence of its Bernstein coefficients. These must differ from 0 by far more than
/// rounding, so that no extremum is near 0.
#[inline(always)]
pub fn certain_sign_changes(low: f64, high: f64, leaving: f64, arriving: f64, first: f64, second: f64) -> f64 {
    let cubic = Cubic::new([low, high], [leaving, arriving]);
    let [one, other] = CHECKS.map(|part| cubic.at(part));
    let allowed = (1.0 - CERTAINTY) * EXACTNESS * if low.abs() > high.abs() { low.abs() } else { high.abs() };
    let is_right = ((first - one).abs() <= allowed) & ((second - other).abs() <= allowed);
    let (near_low, near_high) = (low + leaving / 3.0, high - arriving / 3.0);
    let least = CERTAINTY * (low.abs() + near_low.abs() + near_high.abs() + high.abs());
    let is_far = |coefficient: f64| coefficient.abs() > least;
    let are_far = is_far(low) & is_far(near_low) & is_far(near_high) & is_far(high);
    let change = |a: f64, b: f64| if (a < 0.0) == (b < 0.0) { 0.0 } else { 1.0 };
    let changes = change(low, near_low) + change(near_low, near_high) + change(near_high, high);
    if is_right & are_far & (changes <= 1.0) { changes } else { f64::NAN }
}

/// Number of changes of sign of a compared value in an interval without divisions, 0 to 3; NaN if the interval must be
/// divided. `low` and `high` are the values at the ends, `leaving` and `arriving` their slopes per interval, `first` and
/// `second` the values found at [`CHECKS`].
pub fn sign_changes(low: f64, high: f64, leaving: f64, arriving: f64, first: f64, second: f64) -> f64 {
    let cubic = Cubic::new([low, high], [leaving, arriving]);
    let [one, other] = CHECKS;
    let wrong = worse(worse(0.0, first, cubic.at(one)), second, cubic.at(other));
    let finite = low.is_finite() && high.is_finite() && wrong.is_finite();
    if finite && is_right(cubic, wrong) { cubic.sign_changes() as f64 } else { f64::NAN }
}

#[cfg(test)]
mod tests {
    use super::*;
    use units::split_mix::SplitMix64;

    /// Intervals of a smooth function, with errors of the interpolant and values near 0 of all magnitudes.
    #[test]
    fn changes_of_sign_that_are_certain_are_those_found() {
        let mut random = SplitMix64::new(1);
        let mut number = || (random.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0;
        let mut counts = [0; 3];
        for _ in 0..200_000 {
            let mut scaled = |scales: [f64; 4]| number() * scales[(2.0 * (number() + 1.0)) as usize];
            let ends = [(); 2].map(|()| scaled([1.0, 1.0, 1.0, 1e-10]));
            let slopes = [(); 2].map(|()| scaled([0.1, 0.4, 1.0, 10.0]));
            let cubic = Cubic::new(ends, slopes);
            let wrong = EXACTNESS * number();
            let [first, second] = CHECKS.map(|part| cubic.at(part) + wrong);
            let certain = certain_sign_changes(ends[0], ends[1], slopes[0], slopes[1], first, second);
            if certain.is_nan() {
                counts[2] += 1;
            } else {
                counts[certain as usize] += 1;
                assert_eq!(certain, sign_changes(ends[0], ends[1], slopes[0], slopes[1], first, second));
            }
        }
        assert!(counts.iter().all(|count| *count > 10_000), "{counts:?}");
        for undefined in [f64::NAN, f64::INFINITY] {
            for place in 0..6 {
                let mut values = [1.0, 1.0, 0.0, 0.0, 1.0, 1.0];
                values[place] = undefined;
                let [low, high, leaving, arriving, first, second] = values;
                assert!(certain_sign_changes(low, high, leaving, arriving, first, second).is_nan(), "{values:?}");
            }
        }
    }
}
