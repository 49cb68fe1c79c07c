//! What is held while a part of the scene is dragged.

use crate::controls::start::Start;

/// What is held.
#[derive(Clone, Debug)]
pub(crate) enum Holding {
    /// A part that moves a state.
    State(Box<Hold>),
    /// A part that sets a parameter.
    Parameter {
        parameter: usize,
        /// Its value when it was taken hold of.
        from: f64,
        /// What a scene unit to the right and upwards adds.
        right: f64,
        up: f64,
        /// Whether it has been changed.
        moved: bool,
    },
}

/// A part of the scene that is held and moves a state.
#[derive(Clone, Debug)]
pub(crate) struct Hold {
    pub state: usize,
    /// The state when it was taken hold of; except at the start the variable held is at rest.
    pub from: Vec<f64>,
    /// The parameters when it was taken hold of.
    pub parameters: Vec<f64>,
    /// What decides the value held, at the start of a run.
    pub start: Option<Start>,
    /// What a scene unit to the right and upwards adds.
    pub right: f64,
    pub up: f64,
    /// How far the pointer may move, in scene units: the extent of the scene.
    pub reach: (f64, f64),
    /// The values of the scene that shape the drawing, those in attributes.
    pub shaping: Vec<usize>,
    /// Whether the state has been changed.
    pub moved: bool,
    /// Whether the run goes on afterwards.
    pub playing: bool,
}
