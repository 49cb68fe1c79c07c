//! Medians of samples, of which there may be none.

use std::cmp::Ordering;

/// Median, of an even number the upper one; 0 for an empty list. In the order of [`f64::total_cmp`].
pub(crate) fn median(values: Vec<f64>) -> f64 {
    if values.is_empty() { 0.0 } else { units::order::median(values) }
}

/// Median of each component of some shades, of an even number the upper one; 0 without shades.
pub(crate) fn median_shade<T: Copy + Default>(shades: &[[T; 3]], compare: impl Fn(&T, &T) -> Ordering) -> [T; 3] {
    [0, 1, 2].map(|k| {
        let mut values: Vec<T> = shades.iter().map(|shade| shade[k]).collect();
        let middle = values.len() / 2;
        if values.is_empty() { T::default() } else { *values.select_nth_unstable_by(middle, &compare).1 }
    })
}

/// Median of the magnitudes of numbers, of an even number the upper one; 0 for an empty list.
pub(crate) fn magnitude(values: &[f32]) -> f64 {
    if values.is_empty() { 0.0 } else { f64::from(units::order::median_magnitude(values)) }
}
