//! Values far from all others, such as 9999 for a missing measurement. A fit may follow them, so that the other values get
//! the large residuals. This also happens with a robust loss if such a value begins or ends a record.

use super::outliers::Off;
use units::order::median;

/// Least distance from the median, in ranges of the other values.
const FAR: f64 = 5.0;
/// At most one value in this many can be apart.
const PART: usize = 10;
/// A curve whose residuals are below this part of the scatter of the other values describes them.
const DESCRIBED: f64 = 0.5;
/// Least length of a series to be judged.
const LEAST: usize = 8;

/// Measured value with its residual, both weighted by the error.
pub(in crate::fit) struct Fitted {
    /// Index among the residuals.
    pub place: usize,
    pub value: f64,
    pub residual: f64,
}

/// Values of a series that are far from all others, if the curve does not describe the others. Distances are from the
/// median, in standard deviations of the others. Sorts `series` by distance from the median.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_far_from_all_others_have_their_distances_in_standard_deviations() {
        // Eighteen values around 0 with the standard deviation sqrt(2/3), and two at 60 on either side.
        let series = |residual: f64| -> Vec<Fitted> {
            let value = |place: usize| match place {
                18 => 60.0,
                19 => -60.0,
                _ => (place % 3) as f64 - 1.0,
            };
            (0..20).map(|place| Fitted { place, value: value(place), residual }).collect()
        };
        let far = apart(&mut series(2.0));
        let distance = 60.0 / (2.0_f64 / 3.0).sqrt();
        let expected = [(18, -distance), (19, distance)];
        assert_eq!(far.len(), expected.len());
        for (off, (place, sigmas)) in far.iter().zip(expected) {
            assert_eq!(off.place, place);
            assert!((off.sigmas - sigmas).abs() < 1e-9 * distance, "{} at {place}", off.sigmas);
        }
        // A curve that describes the others is not led astray.
        assert!(apart(&mut series(0.1)).is_empty());
    }
}
