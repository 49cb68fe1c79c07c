//! Values that lie far from all others, as a number does that stands for a missing measurement, 9999 for instance. A fit
//! may follow them, so that residuals accuse the others; with a robust loss, too, where one begins or ends a record.

use super::outliers::Off;
use crate::order::median;

/// So many times the range of the others a value has to be away from their median.
const FAR: f64 = 5.0;
/// No greater part of the values is apart.
const PART: usize = 10;
/// A curve that leaves less than this part of their scatter describes the others.
const DESCRIBED: f64 = 0.5;
/// A series of fewer values is not judged.
const LEAST: usize = 8;

/// A measured value with what the curve leaves of it, both weighted by its error.
pub(in crate::fit) struct Fitted {
    /// Its place among the residuals.
    pub place: usize,
    pub value: f64,
    pub residual: f64,
}

/// Those values of a series that lie apart, where the curve does not describe the others, with their distances from the median
/// in standard deviations of these.
pub(in crate::fit) fn apart(series: &mut [Fitted]) -> Vec<Off> {
    if series.len() < LEAST {
        return Vec::new();
    }
    let centre = median(series.iter().map(|one| one.value).collect());
    let distance = |one: &Fitted| (one.value - centre).abs();
    series.sort_unstable_by(|one, other| distance(one).total_cmp(&distance(other)));
    let least = series.len() - series.len().div_ceil(PART);
    let is_far = |&count: &usize| {
        let [reach, next] = [count - 1, count].map(|place| distance(&series[place]));
        reach > 0.0 && next > FAR * 2.0 * reach
    };
    let Some(count) = (least..series.len()).find(is_far) else { return Vec::new() };
    let (near, far) = series.split_at(count);
    let mean = |square: &dyn Fn(&Fitted) -> f64| near.iter().map(square).sum::<f64>() / count as f64;
    let scatter = mean(&|one| distance(one) * distance(one)).sqrt();
    if mean(&|one| one.residual * one.residual).sqrt() < DESCRIBED * scatter {
        return Vec::new();
    }
    let mut far: Vec<Off> =
        far.iter().map(|one| Off { place: one.place, sigmas: (centre - one.value) / scatter }).collect();
    far.sort_unstable_by_key(|off| off.place);
    far
}
