//! Films in the page: decoding, display on the stage, and the panel. Tracking belongs to the desk.

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
mod signals;
mod space_time;
pub mod stage;
mod state;
mod together;
mod tools;
mod tracking;
mod words;

pub use access::Player;
pub use filming::view as virtual_camera;
pub use frames::look_at;
pub use now::refresh;
pub use opening::{is_film, mark_page, open};
pub use project::open as open_of_project;
pub use signals::Films;
pub use together::follow;
