//! What is read off: time, states and quantities with their units.

use crate::Session;

/// What a readout shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReadoutKind {
    /// The independent variable.
    Independent,
    /// State of this number.
    State(usize),
    /// Quantity of this number.
    Quantity(usize),
}

/// One value with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Readout {
    /// What it is.
    pub kind: ReadoutKind,
    /// The ASCII name, `omega_0`, `y'`; typeset it with [`model::typeset_name`].
    pub name: String,
    /// The label in the session's language; empty where the author gave none.
    pub label: String,
    /// The value in the unit; a dash when it is not finite; a text in the session's language.
    pub value: String,
    /// The unit for people; empty for a pure number, a text or a truth value.
    pub unit: String,
    /// Whether it changes while the parameters do not.
    pub varies: bool,
}

impl Session {
    /// Everything that can be read off at the time shown: the independent variable, the states, the quantities.
    pub fn readouts(&mut self) -> Vec<Readout> {
        Vec::new()
    }

    /// The values of [`document::Scene::values`] at the time shown, SI, for attributes. Computed once for each time.
    pub fn scene_values(&mut self) -> &[f64] {
        &[]
    }

    /// Value `index` of the scene at the time shown, for people, with its unit.
    pub fn scene_text(&mut self, index: usize, decimals: Option<u8>) -> String {
        let _ = (index, decimals);
        String::new()
    }

    /// The pitch in hertz at which the first state sounds: two octaves around 440 Hz for the range it has had in this
    /// run. `None` while there is nothing to hear.
    pub fn pitch(&self) -> Option<f64> {
        None
    }
}
