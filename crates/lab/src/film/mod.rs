//! Films in the page: decoding, display on the stage, and the panel. Tracking belongs to the desk.
//!
//! `access` is all that knows how a browser decodes. `signals.rs` holds what views track, `state.rs` what the desk says of
//! the open film. `tools.rs` says what a click on the film means, `tracking.rs` drives the desk's tracking in slices,
//! `together.rs` keeps the run at the time of the frame shown. `stage.rs` puts the film in the place of scene and transport
//! (`view::Host::picture`), `sample` is the film that the page has, `acts` are the four steps in the panel,
//! `filming` is the virtual camera.

mod access;
pub mod acts;
mod aim;
mod calibrating;
mod camera;
mod doubts;
mod filming;
mod frame;
mod frames;
mod keys;
mod loupe;
mod now;
mod opening;
mod overlay;
mod project;
mod refusals;
mod sample;
mod signals;
mod space_time;
pub mod stage;
mod state;
mod together;
mod tools;
mod tracking;
mod words;

pub use access::Player;
pub use camera::button as camera_button;
pub use filming::{button as virtual_camera_button, view as virtual_camera};
pub use frames::look_at;
pub use now::refresh;
pub use opening::{is_film, mark_page, open};
pub use project::open as open_of_project;
pub use sample::{begin as see_measured, follow as follow_story, open as open_sample};
pub use signals::Films;
pub use together::follow;
