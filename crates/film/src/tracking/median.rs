//! Median of samples, of which there may be none.

/// Median, of an even number the upper one; 0 for an empty list.
pub(crate) fn median(values: Vec<f64>) -> f64 {
    if values.is_empty() { 0.0 } else { units::order::median(values) }
}
