//! Results that lie far from the others, and likely reasons.

use super::measured::Measured;
use units::order::middle;
use units::{Words, words};

/// Distance from the median from which on a result is an outlier, in standard deviations of its error and of the scatter
/// of all.
const FAR: f64 = 3.5;

/// Factor from the median of |x - median| to the standard deviation of a normal distribution.
const SCALE: f64 = 1.4826;

/// Relative distance within which a factor is recognised.
const NEAR: f64 = 0.1;

/// Likely reason for an outlier.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// A factor of 10, 100 or 1000: the unit.
    Unit,
    /// A factor of 2: radius and diameter, or amplitude and peak to peak.
    Double,
    /// A factor of 2 pi: frequency and angular frequency.
    Angular,
    /// The sign.
    Sign,
}

impl Reason {
    /// Description for people.
    pub fn words(self) -> Words {
        match self {
            Self::Unit => words("another power of ten: look at the unit"),
            Self::Double => words("twice or half as large: radius for diameter, or the like"),
            Self::Angular => words("a factor of 2π: frequency for angular frequency"),
            Self::Sign => words("the other sign"),
        }
    }
}

/// For each result, true if it is an outlier: |x - median| > 3.5 sqrt(error² + scatter²). The scatter is that of all results
/// beyond their errors, from the median of |x - median|, so that outliers do not hide each other. Because outliers shift and
/// widen both medians a little, these are taken again from the results that are not marked, until no further one is marked.
pub(super) fn is_outlier(results: &[Measured]) -> Vec<bool> {
    let mut marked = vec![false; results.len()];
    loop {
        let kept = || results.iter().zip(&marked).filter(|(_, marked)| !**marked).map(|(one, _)| one);
        let center = middle(kept().map(|one| one.value).collect());
        let whole = normal_factor(kept().count()) * middle(kept().map(|one| (one.value - center).abs()).collect());
        let error = middle(kept().map(|one| one.error).collect());
        let scatter = (whole * whole - error * error).max(0.0);
        let far = |one: &Measured| (one.value - center).abs() > FAR * (one.error * one.error + scatter).sqrt();
        let next: Vec<bool> = results.iter().zip(&marked).map(|(one, marked)| *marked || far(one)).collect();
        if next == marked {
            return marked;
        }
        marked = next;
    }
}

/// Factor from the median of |x - median| of this many values to the standard deviation of a normal distribution. Of few
/// values the median is too small on average (Croux and Rousseeuw, Computational Statistics 1 (1992) 411).
fn normal_factor(count: usize) -> f64 {
    const FEW: [f64; 8] = [1.196, 1.495, 1.363, 1.206, 1.200, 1.140, 1.129, 1.107];
    let few = count.checked_sub(2).and_then(|place| FEW.get(place));
    SCALE * few.copied().unwrap_or(count as f64 / (count as f64 - 0.8))
}

/// Likely reason why a result differs from the median of the others.
pub(super) fn reason(outlier: Measured, others: &[Measured]) -> Option<Reason> {
    let center = middle(others.iter().map(|one| one.value).collect());
    let factor = outlier.value / center;
    let is_near = |expected: f64| (factor / expected - 1.0).abs() < NEAR || (factor * expected - 1.0).abs() < NEAR;
    if !factor.is_finite() || factor == 0.0 {
        return None;
    }
    if (factor + 1.0).abs() < NEAR {
        return Some(Reason::Sign);
    }
    if [10.0, 100.0, 1000.0].into_iter().any(is_near) {
        return Some(Reason::Unit);
    }
    if is_near(2.0) {
        return Some(Reason::Double);
    }
    is_near(core::f64::consts::TAU).then_some(Reason::Angular)
}
