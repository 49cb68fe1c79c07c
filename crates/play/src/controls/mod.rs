//! Controls of the visitor: parameters, presets, states, method and step; set by slider, by dragging in the scene, or
//! typed.

pub(crate) mod button;
pub(crate) mod calculator;
mod drag;
pub(crate) mod drawing;
pub(crate) mod hold;
pub(crate) mod input;
mod member;
mod method;
mod parameter;
pub(crate) mod preset;
mod size;
mod slider;
mod start;
mod state;
pub(crate) mod typed;

pub use button::ButtonView;
pub use drawing::DrawingView;
pub use input::DIGITS;
pub use method::MethodView;
pub use parameter::{ChoiceView, ParameterGroup, ParameterView};
pub use preset::{PresetGroup, PresetView};
pub use size::SizeView;
pub use slider::Slider;
pub use state::StateView;
