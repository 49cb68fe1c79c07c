//! Graphical edits of a drawing. The rest of the text is left unchanged.

mod add;
mod arrange;
mod attribute;
mod distance;
mod expect;
mod follow;
mod shift;

pub use add::{add_element, add_scene};
pub use arrange::{Order, duplicate_element, remove_elements, reorder_element};
pub use attribute::{set_attribute, set_text};
pub use distance::Measure;
pub(crate) use distance::split_distance;
pub use follow::follow;
pub use shift::shift;
