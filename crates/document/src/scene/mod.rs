//! The drawing: SVG with `{expressions}`, restricted to safe elements and attributes.

mod allowed;
mod amounts;
mod appearance;
mod attributes;
mod build;
mod builder;
mod choice;
mod clip;
mod colours;
mod drag;
mod elements;
mod ids;
mod parts;
mod quantity;
mod reading;
mod repeat;
mod space;
mod style;
mod template;
mod translate;
mod value_list;
mod values;
mod xml;

pub(crate) use allowed::ELEMENTS;
pub(crate) use build::{build, build_marked};
pub(crate) use colours::PALETTE;
pub use parts::Part;
pub(crate) use parts::{ARC_RADIUS, BOB_RADIUS, PARTS, part, part_of};
pub(crate) use space::marks::Marks;
pub(crate) use space::points::{Step, pairs, steps};
pub(crate) use template::normalised;
pub(crate) use translate::{SceneText, has_word, translated};
pub(crate) use xml::{RawChild, RawElement, parse};
