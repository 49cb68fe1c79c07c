//! Numbers as text that reads back exactly.

/// The fewest digits that read back as the same number; plain from 1e-5 to 1e16, with an exponent elsewhere. What is not
/// finite is empty.
pub fn shortest(value: f64) -> String {
    let magnitude = value.abs();
    if !value.is_finite() {
        String::new()
    } else if magnitude == 0.0 || (1e-5..1e16).contains(&magnitude) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}
