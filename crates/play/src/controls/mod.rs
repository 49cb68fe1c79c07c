//! Controls of the visitor: parameters, presets, states, method and step; set by slider, by dragging in the scene, or
//! typed.

pub(crate) mod button;
mod drag;
pub(crate) mod drawing;
pub(crate) mod hold;
mod method;
mod parameter;
pub(crate) mod preset;
mod size;
mod slider;
mod start;
mod state;

pub use button::ButtonView;
pub use drawing::DrawingView;
pub use method::MethodView;
pub use parameter::{ChoiceView, ParameterGroup, ParameterView};
pub use preset::{PresetGroup, PresetView};
pub use size::SizeView;
pub use slider::Slider;
