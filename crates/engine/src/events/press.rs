//! Presses of buttons: what a person does in a run, part of what the run is started with.

use program::Model;

/// A press of a button.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Press {
    /// The independent variable at that moment, SI.
    pub time: f64,
    /// Which of [`program::Model::buttons`].
    pub button: usize,
}

/// The presses that a run of the model can follow, in the order of time; of those of one moment each keeps its place. Where
/// the independent variable counts, a press belongs to the count before.
pub(crate) fn fitting(mut presses: Vec<Press>, model: &Model) -> Vec<Press> {
    presses.retain(|press| press.button < model.buttons.len() && press.time >= 0.0 && press.time.is_finite());
    if model.independent.counts {
        presses.iter_mut().for_each(|press| press.time = press.time.floor());
    }
    presses.sort_by(|one, other| one.time.total_cmp(&other.time));
    presses
}
