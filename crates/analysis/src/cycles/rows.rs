//! Finite rows of a record.

use units::order::sort_by;

/// Pairs of time and value, without gaps, in the order of time.
pub(super) fn without_gaps(times: &[f64], values: &[f64]) -> Vec<(f64, f64)> {
    let mut rows: Vec<(f64, f64)> = times
        .iter()
        .zip(values)
        .filter(|(time, value)| time.is_finite() && value.is_finite())
        .map(|(time, value)| (*time, *value))
        .collect();
    if !rows.is_sorted_by(|one, other| one.0 <= other.0) {
        sort_by(&mut rows, |one, other| one.0.total_cmp(&other.0));
    }
    rows
}
