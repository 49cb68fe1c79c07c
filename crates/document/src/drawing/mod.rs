//! The drawing as it is written: its elements with their places, for editors in which it is drawn by hand.
//!
//! [`read`] gives the elements and what can be gripped of each, from the text alone. [`Sketch`] says where in the picture all that
//! stands. [`crate::edit`] has the changes.

mod component;
mod followed;
mod grip;
mod item;
mod shapes;
mod sketch;

pub use crate::scene::Part;
pub use component::{Axis, follows};
pub(crate) use component::{at_axis, components};
pub use followed::{colours, draggable, followed};
pub use grip::Grip;
pub use item::{Drawing, Item, Written, read};
pub use shapes::{drawable, shows_text};
pub use sketch::{Ground, Located, Sketch};
