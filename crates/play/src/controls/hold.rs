//! State of a drag in the scene.

use crate::controls::start::Start;

/// The part being dragged.
#[derive(Clone, Debug)]
pub(crate) enum Holding {
    /// A part that moves a state.
    State(Box<Hold>),
    /// A part that sets a parameter.
    Parameter {
        parameter: usize,
        /// Value at the start of the drag, SI.
        from: f64,
        /// Change of the value (SI) per scene unit to the right and upwards.
        right: f64,
        up: f64,
        /// True once the parameter has changed.
        moved: bool,
    },
}

/// A drag that moves a state.
#[derive(Clone, Debug)]
pub(crate) struct Hold {
    pub state: usize,
    /// State vector at the start of the drag, SI. Except at time 0, the dragged variable is at rest.
    pub from: Vec<f64>,
    /// Parameters at the start of the drag, SI.
    pub parameters: Vec<f64>,
    /// Parameters that determine the dragged value; only at the start of a run.
    pub start: Option<Start>,
    /// Change of the value (SI) per scene unit to the right and upwards.
    pub right: f64,
    pub up: f64,
    /// Maximum displacement of the pointer, in scene units: the extent of the scene.
    pub reach: (f64, f64),
    /// Indices of the scene values that determine the drawing (those in attributes).
    pub shaping: Vec<usize>,
    /// True once the state has changed.
    pub moved: bool,
    /// True if the run continues after the drag.
    pub playing: bool,
}
