//! Controls of the visitor: parameters, presets, states, method and step; set by slider, by dragging in the scene, or
//! typed.

pub(crate) mod button;
pub(crate) mod drag;
mod dragging;
pub(crate) mod drawing;
pub(crate) mod hold;
mod level;
mod method;
mod parameter;
pub(crate) mod preset;
mod settings;
mod size;
pub(crate) mod slider;
mod start;

pub use button::ButtonView;
pub use drawing::DrawingView;
pub use level::SceneLevel;
pub use method::MethodView;
pub use parameter::{ChoiceView, ParameterGroup, ParameterView};
pub use preset::{PresetGroup, PresetView};
pub use settings::Settings;
pub use size::SizeView;
pub use slider::Slider;

use crate::{Basis, TimeLine, Values};
use engine::Readings;
use hold::Holding;
use program::Program;

/// Presets, and the part of the scene that is being dragged.
#[derive(Debug)]
pub struct Controls {
    hold: Option<Holding>,
    /// Initial values of the states.
    initial: Readings,
    /// All assignments of all presets.
    presets: Readings,
}

/// The parts of the scene that can be dragged, at the moment shown.
#[derive(Debug)]
pub struct Grips<'a> {
    basis: &'a Basis,
    line: &'a TimeLine,
    values: &'a mut Values,
    controls: &'a mut Controls,
}

impl Controls {
    /// Controls of the program; nothing is dragged.
    pub(crate) fn new(program: &Program) -> Self {
        let initial: Vec<_> = program.model.states.iter().map(|state| state.initial).collect();
        let presets = program.presets.iter().flat_map(|preset| &preset.values);
        let presets: Vec<_> = presets.map(|assignment| assignment.value.node).collect();
        let [initial, presets] = [&initial, &presets].map(|nodes| Readings::new(&program.model, nodes));
        Self { hold: None, initial, presets }
    }

    /// Must be called when the model has changed.
    pub(crate) fn model_changed(&mut self, program: &Program) {
        *self = Self { hold: self.hold.take(), ..Self::new(program) };
    }

    /// True while a part of the scene is dragged.
    pub fn is_dragging(&self) -> bool {
        self.hold.is_some()
    }

    /// Pitch in hertz of the first state while the run is playing or a part is dragged: 440 Hz at 0, one octave up or
    /// down at its greatest magnitude in this run. `None` if there is nothing to hear.
    pub fn pitch(&self, line: &TimeLine) -> Option<f64> {
        let (&value, scale) = (line.course().state().first()?, line.greatest(0));
        let sounding = (line.is_playing() || self.is_dragging()) && value.is_finite() && scale > 0.0;
        sounding.then(|| 440.0 * libm::exp2((value / scale).clamp(-1.0, 1.0)))
    }

    /// Sets the part that is dragged.
    pub(crate) fn hold(&mut self, hold: Option<Holding>) {
        self.hold = hold;
    }

    /// Releases the part that is dragged and returns it.
    pub(crate) fn release(&mut self) -> Option<Holding> {
        self.hold.take()
    }

    /// The parts of the scene that can be dragged.
    pub(crate) fn grips<'a>(&'a mut self, basis: &'a Basis, line: &'a TimeLine, values: &'a mut Values) -> Grips<'a> {
        Grips { basis, line, values, controls: self }
    }
}
