//! The drawing in the source text: its elements with their places, for graphical editing.
//!
//! [`read`] gives the elements and their grips from the text alone. [`Sketch`] computes their places in the picture.
//! [`crate::edit`] makes the changes.
//!
//! A sketch builds the scene once more, with `scene/space/marks.rs` taking notes of the places. `edit/drawing` moves, sizes,
//! turns and orders elements. What is moved keeps what it follows: a distance is added to the expression
//! (`edit/drawing/distance.rs`).

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
