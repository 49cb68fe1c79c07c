//! Restoring the state of a link.

use crate::Desk;

/// Restores a state written by [`play::Play::share`], with the sizes that it needs. The first result is true if the sizes
/// changed.
///
/// # Errors
/// As [`play::Play::restore`]; a size that is not possible is listed with the other parts that do not fit.
pub fn restore(desk: &mut Desk, fragment: &str) -> (bool, Result<(), play::Refusal>) {
    let wanted = desk.play().basis().sizes_for(fragment);
    let wanted: Vec<(&str, u32)> = wanted.iter().map(|(name, value)| (name.as_str(), *value)).collect();
    let resized = !wanted.is_empty() && desk.resize(&wanted).is_ok();
    (resized, desk.play_mut().restore(fragment))
}
