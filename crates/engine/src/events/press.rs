//! Presses of buttons; they are part of the setup of a run.

use program::Model;
use units::order::sort_by;

/// A press of a button.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Press {
    /// Independent variable at the press, SI units.
    pub time: f64,
    /// Index in [`program::Model::buttons`].
    pub button: usize,
}

/// The valid presses for a model, sorted by time; presses at the same time keep their order. If the independent variable
/// counts, a press is moved to the count before.
pub(crate) fn fitting(mut presses: Vec<Press>, model: &Model) -> Vec<Press> {
    presses.retain(|press| press.button < model.buttons.len() && press.time >= 0.0 && press.time.is_finite());
    if model.independent.counts {
        presses.iter_mut().for_each(|press| press.time = press.time.floor());
    }
    sort_by(&mut presses, |one, other| one.time.total_cmp(&other.time));
    presses
}
