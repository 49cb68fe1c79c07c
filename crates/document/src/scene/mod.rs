//! The drawing: SVG with `{expressions}`, reduced to what is known to be harmless.

mod allowed;
mod attributes;
mod build;
mod builder;
mod choice;
mod drag;
mod frame;
mod measures;
mod parts;
mod points;
mod reading;
mod repeat;
mod shapes;
mod space;
mod style;
mod template;
mod translate;
mod values;
mod xml;

pub(crate) use allowed::ELEMENTS;
pub(crate) use build::build;
pub(crate) use parts::part_of;
pub(crate) use template::normalised;
pub(crate) use translate::{SceneText, has_word, translated};
